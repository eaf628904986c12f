// Reports in headless Chromium: opened from disk, with everything noted that must not happen.
import {pathToFileURL} from "node:url";
import {chromium} from "../../../app/viewer/node_modules/playwright-core/index.mjs";

export async function startBrowser(extraArguments = []) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...extraArguments],
  });
}

// Result: {page, complaints}: console errors and warnings, exceptions, requests to a network.
export async function openReport(browser, file, {width, height, hash = "", ...options}) {
  const context = await browser.newContext({viewport: {width, height}, ...options});
  const page = await context.newPage();
  const complaints = [];
  page.on("console", message => {
    // The software renderer of the test remarks on its own speed when pixels are read back.
    const remark = message.text().includes("GPU stall due to ReadPixels");
    if (["error", "warning"].includes(message.type()) && !remark) complaints.push(message.text());
  });
  page.on("pageerror", error => complaints.push(error.stack));
  page.on("request", request => {
    if (!request.url().startsWith("file:") && !request.url().startsWith("data:")) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForSelector("body.ready", {timeout: 120000});
  return {page, complaints};
}

// Waits until all that is to be drawn is drawn.
export async function settle(page) {
  await page.evaluate(async () => {
    const frame = () => new Promise(requestAnimationFrame);
    const {panes} = window.cocoonPage;
    do await frame(); while (panes.pending || panes.moving);
    await frame();
  });
}

// What a pane shows, counted: share of pixels that are drawn, and of those with hue in [low, high)
// degrees and a saturation of at least 0.3; a number that changes with the picture.
export async function lookAt(page, pane, hues = []) {
  await settle(page);
  return page.evaluate(([pane, hues]) => {
    const {panes} = window.cocoonPage, {canvas} = panes;
    const whole = canvas.getBoundingClientRect(), box = panes.panes[pane].node.getBoundingClientRect();
    const ratio = canvas.width / whole.width;
    const width = Math.floor(box.width * ratio), height = Math.floor(box.height * ratio);
    const copy = new OffscreenCanvas(width, height).getContext("2d");
    copy.drawImage(canvas, (box.left - whole.left) * ratio, (box.top - whole.top) * ratio, width, height, 0, 0, width, height);
    const {data} = copy.getImageData(0, 0, width, height);
    let drawn = 0, hash = 0;
    const inHue = hues.map(() => 0);
    for (let i = 0; i < data.length; i += 4) {
      hash = (Math.imul(hash, 31) + data[i] + 256 * data[i + 1] + 65536 * data[i + 2]) | 0;
      if (data[i + 3] < 128) continue;
      ++drawn;
      const [r, g, b] = [data[i], data[i + 1], data[i + 2]], most = Math.max(r, g, b), range = most - Math.min(r, g, b);
      if (range < 0.3 * most || most === 0) continue;
      const sixth = most === r ? (g - b) / range : most === g ? 2 + (b - r) / range : 4 + (r - g) / range;
      const hue = (60 * sixth + 360) % 360;
      hues.forEach(([low, high], k) => { if (hue >= low && hue < high) ++inHue[k]; });
    }
    const pixels = data.length / 4;
    return {drawn: drawn / pixels, hues: inHue.map(count => count / pixels), hash};
  }, [pane, hues]);
}

// Where a point of the report is in the window, as pane `pane` shows it.
export async function placeOf(page, pane, point) {
  return page.evaluate(([pane, point]) => {
    const {panes, turntable, report} = window.cocoonPage;
    const box = panes.panes[pane].node.getBoundingClientRect();
    const camera = turntable.lookThrough(box.width / box.height);
    const p = camera.position.clone().fromArray(report.points.positions, 3 * point).project(camera);
    return {x: box.left + (p.x + 1) * box.width / 2, y: box.top + (1 - p.y) * box.height / 2};
  }, [pane, point]);
}
