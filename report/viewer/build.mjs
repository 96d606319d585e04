// Bundles the viewer into the one script that is put into pages. The same sources give the same bytes.
import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";

const outfile = "../../crates/meshmend-report/assets/viewer.js";
const result = await build({
  entryPoints: ["src/main.ts"], bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8",
  legalComments: "none", write: false, logLevel: "warning",
});
const license = "/*! three.js: Copyright (c) 2010-2026 three.js authors, MIT licence. meshmend: MIT or Apache-2.0. */\n";
// Nothing in a script element may look like its end, or like a comment of HTML.
const text = license + result.outputFiles[0].text.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const old = await readFile(outfile, "utf8").catch(() => "");
if (process.argv.includes("--check")) {
  if (old !== text) { console.error(`${outfile} is not what the sources give: npm run build`); process.exit(1); }
} else {
  await writeFile(outfile, text);
  console.log(`${outfile}: ${text.length} characters`);
}
