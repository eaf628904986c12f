// Bundles src/ and three.js to viewer.min.js, which is committed: `./dev viewer` runs this.
import {readFileSync} from "node:fs";
import {build} from "esbuild";

const licence = readFileSync("node_modules/three/LICENSE", "utf8").replaceAll("\u00a9", "(c)").trim();

await build({
  entryPoints: ["src/main.js"],
  outfile: "viewer.min.js",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "ascii",
  legalComments: "none",
  banner: {js: `/* The viewer of Cocoon's reports, source in app/viewer. It contains three.js:\n\n${licence}\n*/`},
  logLevel: "warning",
});
