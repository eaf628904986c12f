// The page of a report: panes, layers, selection and tables.
import {Turntable} from "./camera.js";
import {listenToKeys, listenToPointers} from "./controls.js";
import {readReport} from "./data.js";
import {Panes} from "./panes.js";
import {pick} from "./pick.js";
import {ReportScene} from "./scene.js";
import {selectionCard, selectionMark} from "./selection.js";
import {element, fillText} from "./tables.js";

const at = id => document.getElementById(id);

function countText({geometry, elements}) {
  const nouns = {triangles: "triangles", lines: "edges", points: "points"};
  return `${elements.length.toLocaleString("en-US")} ${nouns[geometry.kind]}`;
}

class Page {
  constructor(report) {
    this.report = report;
    this.scene = new ReportScene(report);
    this.turntable = new Turntable(this.scene.box, report.view);
    this.panes = new Panes(report, this.scene, this.turntable, i => this.toggleSingle(i));
    this.fillStages();
    this.fillLayers();
    this.listen();
    this.followAddress();
  }

  // #stage=3 shows one view alone, #edges=1 the edges of triangles.
  followAddress() {
    const wanted = new URLSearchParams(location.hash.slice(1));
    const stage = Number(wanted.get("stage"));
    const narrow = matchMedia("(max-width: 760px)").matches;
    this.setEdges(wanted.get("edges") === "1");
    if (stage >= 1 && stage <= this.report.stages.length) this.arrange(stage - 1, true);
    else this.arrange(0, narrow || this.report.stages.length === 1);
  }

  arrange(active, single) {
    this.panes.arrange(active, single);
    at("all").setAttribute("aria-pressed", String(!single));
    this.stageButtons.forEach((button, i) => button.setAttribute("aria-pressed", String(single && i === active)));
    this.showLayers();
  }

  toggleSingle(i) {
    this.arrange(i, !this.panes.single);
  }

  fillStages() {
    at("all").addEventListener("click", () => this.arrange(this.panes.active, false));
    this.stageButtons = this.report.stages.map((stage, i) => {
      const button = element("button", undefined, "stage");
      button.append(element("b", String(i + 1)), element("span", stage.name));
      button.title = stage.name;
      button.addEventListener("click", () => this.arrange(i, true));
      at("stages").append(button);
      return button;
    });
  }

  fillLayers() {
    this.boxes = this.scene.layers.map(layer => {
      const label = element("label"), box = element("input");
      box.type = "checkbox";
      box.dataset.layer = layer.id;
      box.addEventListener("change", () => {
        const {visible} = this.panes.panes[this.panes.active];
        if (box.checked) visible.add(layer.id);
        else visible.delete(layer.id);
        this.showLayers();
        this.panes.redraw();
      });
      const swatch = element("span", "", `swatch ${layer.geometry.kind}`);
      swatch.style.setProperty("--color", layer.color);
      if (layer.field) swatch.classList.add("field");
      label.append(box, swatch, element("span", layer.name), element("small", countText(layer)));
      at("layers").append(label);
      return box;
    });
    at("restore").addEventListener("click", () => {
      const pane = this.panes.panes[this.panes.active];
      pane.visible = new Set(pane.stage.layers);
      this.showLayers();
      this.panes.redraw();
    });
  }

  // The boxes say what the active pane shows.
  showLayers() {
    const {stage, visible} = this.panes.panes[this.panes.active];
    at("layers-of").textContent = `${this.panes.active + 1} ${stage.name}`;
    for (const box of this.boxes) box.checked = visible.has(box.dataset.layer);
    const changed = visible.size !== stage.layers.length || stage.layers.some(id => !visible.has(id));
    at("restore").hidden = !changed;
  }

  setEdges(wanted) {
    this.panes.options.edges = wanted;
    at("edges").setAttribute("aria-pressed", String(wanted));
    this.panes.redraw();
  }

  pickAt({i, aspect, height, pointer}) {
    const {visible} = this.panes.panes[i];
    const layers = this.scene.layers.filter(layer => visible.has(layer.id));
    const camera = this.turntable.lookThrough(aspect);
    this.select(pick(camera, pointer, height, this.report.points.positions, layers, this.turntable.radius));
  }

  select(picked) {
    at("selection").hidden = !picked;
    at("selection-text").replaceChildren(...(picked ? [selectionCard(this.report, picked)] : []));
    this.panes.setMark(picked ? selectionMark(this.report, picked) : null);
  }

  listen() {
    at("edges").addEventListener("click", () => this.setEdges(!this.panes.options.edges));
    at("home").addEventListener("click", () => {
      this.turntable.reset();
      this.panes.redraw();
    });
    at("help").addEventListener("click", () => {
      const shown = at("help-text").hidden;
      at("help-text").hidden = !shown;
      at("help").setAttribute("aria-pressed", String(shown));
    });
    at("point-size").addEventListener("input", event => {
      this.panes.options.pointScale = Number(event.target.value);
      this.panes.redraw();
    });
    at("selection-close").addEventListener("click", () => this.select(null));
    window.addEventListener("hashchange", () => this.followAddress());
    listenToPointers(this.panes, this.turntable, {
      onPick: place => this.pickAt(place),
      onActivate: i => { if (!this.panes.single && i !== this.panes.active) this.arrange(i, false); },
    });
    listenToKeys(this.panes, this.turntable, {
      onStage: i => this.arrange(i, true),
      onGrid: () => this.arrange(this.panes.active, false),
      onEdges: () => this.setEdges(!this.panes.options.edges),
      onEscape: () => this.select(null),
    });
  }
}

// Whether the browser has WebGL 2 at all; three.js would write an error of its own.
function hasWebGl() {
  return Boolean(document.createElement("canvas").getContext("webgl2"));
}

const report = readReport();
fillText(report);
if (hasWebGl()) {
  window.cocoonPage = new Page(report);
} else {
  document.body.classList.add("text-only");
  const list = at("text-stages");
  for (const stage of report.stages) list.append(element("dt", stage.name), element("dd", stage.caption));
}
document.body.classList.add("ready");
