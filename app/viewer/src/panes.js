// The panes: one for each stage, side by side or one alone, all drawn on one canvas that lies over
// them and through one camera.
import {WebGLRenderer} from "three";
import {element, numberText} from "./tables.js";
import {fieldColors} from "./scene.js";

const restTime = 250, slowFrame = 90;  // milliseconds

export class Panes {
  constructor(report, reportScene, turntable, onTitle) {
    this.scene = reportScene;
    this.turntable = turntable;
    this.options = {edges: false, pointScale: 1};
    this.grid = document.getElementById("panes");
    this.canvas = document.getElementById("canvas");
    this.panes = report.stages.map((stage, i) => this.makePane(stage, i, onTitle));
    this.active = 0;
    this.single = false;
    this.mark = null;
    this.renderer = new WebGLRenderer({canvas: this.canvas, antialias: true, alpha: true, preserveDrawingBuffer: true});
    this.renderer.setClearColor(0, 0);
    // At once: a frame later the browser would have shown the old picture stretched to the new size.
    new ResizeObserver(() => this.draw()).observe(this.grid);
  }

  makePane(stage, i, onTitle) {
    const node = element("div", undefined, "pane");
    const title = element("button", undefined, "pane-title");
    title.append(element("b", String(i + 1)), stage.name);
    title.title = "Show this view alone, or all";
    title.addEventListener("click", () => onTitle(i));
    node.append(title, element("p", stage.caption, "caption"));
    const fieldLayer = this.scene.layers.find(layer => stage.layers.includes(layer.id) && layer.scale !== undefined);
    if (fieldLayer) node.append(this.makeLegend(fieldLayer));
    this.grid.append(node);
    return {node, stage, visible: new Set(stage.layers)};
  }

  makeLegend({scale}) {
    const legend = element("div", undefined, "legend");
    const bar = element("i");
    bar.style.background = `linear-gradient(to right, ${fieldColors.join(", ")})`;
    legend.append(element("span", numberText(-scale, 3)), bar, element("span", `+${numberText(scale, 3)}`));
    return legend;
  }

  arrange(active, single) {
    this.active = active;
    this.single = single;
    this.grid.classList.toggle("single", single);
    this.panes.forEach(({node}, i) => {
      node.hidden = single && i !== active;
      node.classList.toggle("active", i === active);
    });
    this.redraw();
  }

  // The pane under a place of the window, with the place relative to it; null beside them.
  paneAt(x, y) {
    for (const [i, {node}] of this.panes.entries()) {
      if (node.hidden) continue;
      const box = node.getBoundingClientRect();
      if (x < box.left || x >= box.right || y < box.top || y >= box.bottom) continue;
      return {i, aspect: box.width / box.height, height: box.height,
              pointer: {x: 2 * (x - box.left) / box.width - 1, y: 1 - 2 * (y - box.top) / box.height}};
    }
    return null;
  }

  setMark(mark) {
    if (this.mark) this.scene.scene.remove(this.mark);
    this.mark = mark;
    if (mark) this.scene.scene.add(mark);
    this.redraw();
  }

  // Draws once, in the next frame: the page does nothing while nobody touches it. Where frames take
  // long, a moving camera draws the active pane alone, and the others follow when it rests.
  redraw(moving = false) {
    this.moving = moving;
    clearTimeout(this.rest);
    if (moving) this.rest = setTimeout(() => this.redraw(), restTime);
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(begin => {
      this.pending = false;
      this.draw(this.moving && this.slow);
      // The browser asks for the frame after this one when it is done with it.
      if (this.moving && !this.slow) requestAnimationFrame(end => { this.slow = end - begin > slowFrame; });
    });
  }

  draw(activeOnly = false) {
    const {renderer} = this, whole = this.grid.getBoundingClientRect();
    if (whole.width < 1 || whole.height < 1) return;
    this.fitCanvas(whole);
    renderer.setScissorTest(true);
    for (const [i, {node, visible}] of this.panes.entries()) {
      if (node.hidden || activeOnly && i !== this.active) continue;
      const box = node.getBoundingClientRect();
      const view = [box.left - whole.left, whole.bottom - box.bottom, box.width, box.height];
      renderer.setViewport(...view);
      renderer.setScissor(...view);
      const pointSize = Math.max(1.5, box.height / 240) * this.options.pointScale * renderer.getPixelRatio();
      this.scene.show(visible, {edges: this.options.edges, pointSize});
      const camera = this.turntable.lookThrough(box.width / box.height);
      this.scene.lights.quaternion.setFromRotationMatrix(camera.matrixWorld);
      renderer.render(this.scene.scene, camera);
    }
  }

  // A canvas of a new size is empty; else what is not drawn anew stays.
  fitCanvas({width, height}) {
    const ratio = window.devicePixelRatio || 1;
    if (this.size?.width === width && this.size.height === height && this.size.ratio === ratio) return;
    this.size = {width, height, ratio};
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }
}
