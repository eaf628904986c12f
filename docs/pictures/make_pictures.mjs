// The pictures of README.md and docs/update.md, from the report of the demo. Run by `./dev pictures`:
//   node make_pictures.mjs PROGRAM
import {execFileSync} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {openReport, settle, startBrowser} from "../../tests/app/viewer/browser.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "cocoon-pictures-"));
execFileSync(process.argv[2], ["demo", "-o", folder, "--quiet"]);
const report = join(folder, "report.html");
const browser = await startBrowser();

const {page: whole} = await openReport(browser, report, {width: 1280, height: 800});
await settle(whole);
await whole.screenshot({path: join(here, "report.png")});

const {page: views} = await openReport(browser, report, {width: 1572, height: 660});
await settle(views);
await views.locator("#view").screenshot({path: join(here, "update_steps.png")});

// One view alone, 760 x 400, from nearby where `zoom` is less than 1, of the place `center`:
// [file, view, look].
const tip = [0.9, -0.75, 1];  // an end of the U-shaped cloud
const pictures = [
  ["cloud_surface.png", 2, {layers: ["cloud-1-surface", "cloud-1-loops"], zoom: 0.42, edges: true, center: [0, 0, 1.1]}],
  ["overlapping_facets.png", 2, {zoom: 0.3, edges: true, center: tip}],
  ["groups.png", 3, {zoom: 0.3, edges: true, center: tip}],
  ["chosen_region.png", 4, {}],
  ["updated_model.png", 5, {zoom: 0.3, edges: true, center: tip}],
  ["deviation.png", 6, {}],
];
for (const [file, view, look] of pictures) {
  const {page} = await openReport(browser, report, {width: 1132, height: 451, hash: `#stage=${view}`});
  await page.evaluate(([view, {layers, zoom = 1, edges = false, center}]) => {
    const {cocoonPage} = window, {panes, turntable, report} = cocoonPage, pane = panes.panes[view - 1];
    if (layers) pane.visible = new Set(layers);
    if (center) turntable.center.fromArray(center.map((x, axis) => x - report.origin[axis]));
    turntable.zoomed = zoom;
    cocoonPage.setEdges(edges);
    pane.node.querySelector(".caption").hidden = pane.node.querySelector(".pane-title").hidden = true;
    panes.redraw();
  }, [view, look]);
  await settle(page);
  await page.locator("#view").screenshot({path: join(here, file)});
}
await browser.close();
rmSync(folder, {recursive: true});
