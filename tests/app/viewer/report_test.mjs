// The HTML report as a person meets it, in headless Chromium. Run by `./dev test-report`:
//   node report_test.mjs PROGRAM
// Ends with "N passed, N failed", and exit code 1 if one failed.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, statSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {lookAt, openReport, placeOf, settle, startBrowser} from "./browser.mjs";

const program = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), "cocoon-report-"));
const cocoon = (...words) => execFileSync(program, [...words, "--quiet"]);
const report = join(folder, "report.html");
const desktop = {width: 1280, height: 800};
const red = [340, 375], orange = [15, 40], yellow = [40, 60], green = [80, 160], blue = [195, 250];

const tests = [];
const test = (name, body) => tests.push({name, body});
const cardText = page => page.textContent("#selection");

test("every view shows something of its own", async browser => {
  const {page, complaints} = await openReport(browser, report, desktop);
  const seen = new Set();
  for (let pane = 0; pane < 6; ++pane) {
    const {drawn, hash} = await lookAt(page, pane);
    assert.ok(drawn > 0.1 && drawn < 0.8, `pane ${pane}: ${drawn} of its pixels drawn`);
    seen.add(hash);
  }
  assert.equal(seen.size, 6);
  assert.deepEqual(complaints, []);
});

test("colors are those of the captions", async browser => {
  const {page} = await openReport(browser, report, desktop);
  const expected = [[0, orange], [2, green], [2, blue], [2, yellow], [3, [340, 360]], [4, orange], [5, [340, 360]]];
  for (const [pane, hue] of expected) {
    const {hues: [share]} = await lookAt(page, pane, [hue]);
    assert.ok(share > 0.002, `pane ${pane}, hue ${hue}: ${share}`);
  }
  const loops = await lookAt(page, 1, [[0, 15], [340, 360]]);
  assert.ok(loops.hues[0] + loops.hues[1] > 0.001, "boundary loops are red");
  const plain = await lookAt(page, 0, [green]);
  assert.equal(plain.hues[0], 0);
});

test("cameras move together, and go back", async browser => {
  const {page, complaints} = await openReport(browser, report, desktop);
  const views = async () => [await lookAt(page, 0), await lookAt(page, 4)].map(({hash}) => hash);
  const before = await views();
  await page.mouse.move(150, 250);
  await page.mouse.down();
  await page.mouse.move(190, 265, {steps: 4});
  await page.mouse.up();
  const rotated = await views();
  await page.mouse.wheel(0, -240);
  const zoomed = await views();
  await page.keyboard.down("Shift");
  await page.mouse.down();
  await page.mouse.move(230, 300, {steps: 4});
  await page.mouse.up();
  await page.keyboard.up("Shift");
  const moved = await views();
  for (let k = 0; k < 2; ++k) assert.equal(new Set([before, rotated, zoomed, moved].map(view => view[k])).size, 4);
  assert.equal(await page.isVisible("#selection"), false, "a drag is no click");
  await page.click("#home");
  assert.deepEqual(await views(), before);
  assert.deepEqual(complaints, []);
});

// A picture taken just then would be stretched.
test("no frame shows the canvas in another size than its own", async browser => {
  const {page} = await openReport(browser, report, desktop);
  const sizes = await page.evaluate(() => new Promise(resolve => {
    const grid = document.getElementById("panes"), canvas = document.getElementById("canvas");
    let calls = 0;
    new ResizeObserver(() => {
      if (++calls === 1) grid.style.width = `${grid.clientWidth - 200}px`;  // the first call tells today's size
      else resolve([canvas.width / devicePixelRatio, grid.clientWidth]);
    }).observe(grid);
  }));
  assert.equal(sizes[0], sizes[1]);
});

test("layers go off and on", async browser => {
  const {page} = await openReport(browser, report, desktop);
  const before = await lookAt(page, 0), other = await lookAt(page, 1);
  await page.uncheck("[data-layer=model]");
  const without = await lookAt(page, 0);
  assert.ok(without.drawn < 0.5 * before.drawn && without.drawn > 0.01, `${without.drawn} of ${before.drawn}`);
  assert.deepEqual(await lookAt(page, 1), other, "only the active pane changes");
  await page.check("[data-layer=cloud-1-surface]");
  assert.ok((await lookAt(page, 0)).hash !== without.hash);
  await page.click("#restore");
  assert.deepEqual(await lookAt(page, 0), before);
});

test("picking says which facet, vertex and group", async browser => {
  const {page, complaints} = await openReport(browser, report, {...desktop, hash: "#stage=4"});
  await settle(page);
  // A facet of the replaced group, by its label; the region is seen from above, so nothing hides it.
  const wanted = await page.evaluate(() => {
    const geometry = window.cocoonPage.report.geometries.find(({id}) => id === "model");
    const label = geometry.texts.findIndex(text => text.includes("replaced"));
    const facets = [...geometry.labels.keys()].filter(t => geometry.labels[t] === label);
    const facet = facets[Math.floor(facets.length / 2)];
    return {facet, corners: [...geometry.indices.subarray(3 * facet, 3 * facet + 3)], text: geometry.texts[label]};
  });
  const corners = await Promise.all(wanted.corners.map(corner => placeOf(page, 3, corner)));
  const inside = [0, 1, 2].map(k => k === 0 ? 0.5 : 0.25);  // nearest to the first corner
  const at = axis => corners.reduce((sum, corner, k) => sum + inside[k] * corner[axis], 0);
  await page.mouse.click(at("x"), at("y"));
  const text = await cardText(page);
  assert.ok(text.includes(`facet${wanted.facet.toLocaleString("en-US")} of initial model`), text);
  assert.ok(text.includes(wanted.text) && /mean angle \d/.test(text), text);
  const vertices = wanted.corners.map(corner => `vertex${corner.toLocaleString("en-US")} of initial model`);
  assert.ok(vertices.some(vertex => text.includes(vertex)), text);
  await page.keyboard.press("Escape");
  assert.equal(await page.isVisible("#selection"), false);
  assert.deepEqual(complaints, []);
});

test("picking finds points of the cloud, and nothing beside the model", async browser => {
  const {page} = await openReport(browser, report, {...desktop, hash: "#stage=1"});
  await settle(page);
  const top = await page.evaluate(() => {
    const {positions, parts} = window.cocoonPage.report.points;
    let best = parts[1].first;
    for (let i = best; i < best + parts[1].count; ++i) if (positions[3 * i + 2] > positions[3 * best + 2]) best = i;
    return {index: best, first: parts[1].first, z: positions[3 * best + 2] + window.cocoonPage.report.origin[2]};
  });
  const before = await lookAt(page, 0);
  const place = await placeOf(page, 0, top.index);
  await page.mouse.click(place.x, place.y);
  const text = await cardText(page);
  const [, number] = text.match(/point([\d,]+) of cloud/) ?? [];
  assert.ok(number, text);
  const picked = await placeOf(page, 0, top.first + Number(number.replaceAll(",", "")));
  assert.ok(Math.hypot(picked.x - place.x, picked.y - place.y) < 7, "the point is under the pointer");
  assert.notEqual((await lookAt(page, 0)).hash, before.hash, "the point is marked");
  await page.mouse.click(30, 700);
  assert.equal(await page.isVisible("#selection"), false);
  assert.deepEqual(await lookAt(page, 0), before);
});

test("keys choose views, rotate, show edges", async browser => {
  const {page} = await openReport(browser, report, desktop);
  await page.keyboard.press("5");
  assert.equal(await page.locator(".pane:visible").count(), 1);
  const before = await lookAt(page, 4);
  await page.keyboard.press("e");
  const edges = await lookAt(page, 4);
  await page.keyboard.press("ArrowLeft");
  const rotated = await lookAt(page, 4);
  assert.equal(new Set([before.hash, edges.hash, rotated.hash]).size, 3);
  await page.keyboard.press("e");
  await page.keyboard.press("r");
  assert.deepEqual(await lookAt(page, 4), before);
  await page.keyboard.press("a");
  assert.equal(await page.locator(".pane:visible").count(), 6);
});

test("text is complete: counts, angles, times", async browser => {
  const {page} = await openReport(browser, report, desktop);
  const text = await page.textContent("aside");
  for (const part of ["closed", "manifold", "5,991", "11,488", "17,", "kept", "replaced", "boundary detection",
                      "reconstruction", "Woo & Dey"]) {
    assert.ok(text.includes(part), part);
  }
  assert.equal(JSON.parse(await page.textContent("#json")).command, "demo");
});

test("fits windows from a telephone to a wide screen", async browser => {
  for (const [width, height] of [[1920, 1080], [1280, 800], [1000, 700], [760, 900], [390, 844], [320, 568]]) {
    const {page, complaints} = await openReport(browser, report, {width, height});
    await settle(page);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    assert.ok(overflow <= 0, `${width} x ${height}: ${overflow} pixels too wide`);
    const {drawn} = await lookAt(page, 0);
    assert.ok(drawn > 0.1, `${width} x ${height}: ${drawn}`);
    assert.ok(await page.locator("#home").isVisible());
    assert.deepEqual(complaints, []);
    await page.context().close();
  }
});

test("fingers rotate, pinch and pick", async browser => {
  const {page, complaints} = await openReport(browser, report, {width: 390, height: 844, hasTouch: true, isMobile: true, deviceScaleFactor: 2});
  const before = await lookAt(page, 0);
  await page.touchscreen.tap(200, 380);
  assert.ok((await cardText(page)).includes("of "), "a tap picks");
  await page.click("#selection-close");
  assert.deepEqual(await lookAt(page, 0), before);
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...places) => session.send("Input.dispatchTouchEvent", {
    type, touchPoints: places.map(([x, y], id) => ({x, y, id}))});
  await touch("touchStart", [200, 380]);
  await touch("touchMove", [240, 390]);
  await touch("touchEnd");
  const rotated = await lookAt(page, 0);
  assert.notEqual(rotated.hash, before.hash);
  await touch("touchStart", [150, 380], [250, 380]);
  await touch("touchMove", [170, 380], [230, 380]);
  await touch("touchEnd");
  const pinched = await lookAt(page, 0);
  assert.ok(pinched.drawn < 0.8 * rotated.drawn, `${pinched.drawn} of ${rotated.drawn}`);
  assert.equal(await page.isVisible("#selection"), false);
  assert.deepEqual(complaints, []);
});

test("without WebGL the text remains", async () => {
  const browser = await startBrowser(["--disable-3d-apis"]);
  try {
    const {page, complaints} = await openReport(browser, report, desktop);
    assert.ok(await page.isVisible("#text-only"));
    assert.ok((await page.textContent("#text-stages")).includes("Updated model"));
    assert.equal(await page.isVisible("#view"), false);
    assert.ok((await page.textContent("aside")).includes("11,488"));
    assert.deepEqual(complaints, []);
  } finally {
    await browser.close();
  }
});

test("sizes that are no floats, and names that look like markup", async browser => {
  const at = name => join(folder, name);
  const huge = (from, to) => writeFileSync(at(to), readFileSync(at(from), "utf8").trim().split("\n")
    .map(line => line.split(" ").map(x => x * 1e42).join(" ")).join("\n") + "\n");
  cocoon("sample", "block", "-o", folder);
  huge("initial.xyz", "<!--<script>.xyz");
  huge("cloud-1.xyz", "huge.xyz");
  cocoon("update", at("<!--<script>.xyz"), at("huge.xyz"), "-o", at("huge.ply"), "--html", at("huge.html"));
  const {page, complaints} = await openReport(browser, at("huge.html"), {...desktop, hash: "#stage=5"});
  const {drawn} = await lookAt(page, 4);
  assert.ok(drawn > 0.1, `${drawn} of the pixels drawn`);
  await page.mouse.click(450, 400);
  assert.match(await cardText(page), /(,\d{3}){13}/);
  assert.ok((await page.textContent("body")).includes("<!--<script>.xyz"));
  assert.deepEqual(complaints, []);
});

test("200,000 triangles: one file of moderate size that shows and picks", async browser => {
  const at = name => join(folder, name);
  cocoon("sample", "block", "--points", "50000", "--cloud-points", "60000", "-o", folder);
  cocoon("update", at("initial.xyz"), at("cloud-1.xyz"), "-o", at("large.ply"), "--html", at("large.html"));
  assert.ok(statSync(at("large.html")).size < 12e6, `${statSync(at("large.html")).size} bytes`);
  const {page, complaints} = await openReport(browser, at("large.html"), {...desktop, hash: "#stage=5"});
  const triangles = await page.evaluate(() => {
    const {geometries} = window.cocoonPage.report;
    return geometries.find(({id}) => id === "updated").indices.length / 3;
  });
  assert.ok(triangles > 200000, `${triangles} triangles`);
  assert.ok((await lookAt(page, 4)).drawn > 0.1);
  await page.mouse.click(450, 400);
  assert.ok((await cardText(page)).includes("of updated model"));
  assert.deepEqual(complaints, []);
});

let failed = 0;
cocoon("demo", "-o", folder);
const browser = await startBrowser();
for (const {name, body} of tests) {
  const begin = Date.now();
  try {
    await body(browser);
    console.log(`ok      ${name} (${((Date.now() - begin) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
  for (const context of browser.contexts()) await context.close();
}
await browser.close();
rmSync(folder, {recursive: true});
console.log(`${tests.length - failed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
