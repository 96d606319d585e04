// The colours of layers as people see them who lack a kind of cone: each two are told apart by colour, or by their symbol.
import assert from "node:assert/strict";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const source = join(dirname(fileURLToPath(import.meta.url)), "../src/palette.ts");
const { outputFiles } = await build({ entryPoints: [source], write: false, bundle: true, format: "esm", logLevel: "error" });
const { COLOURS, looks } = await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);

// Machado, Oliveira and Fernandes 2009, severity 1, on linear RGB.
const SIGHT = {
  "all cones": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  protanopia: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  deuteranopia: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
  tritanopia: [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
};

const linear = colour => [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16) / 255)
  .map(x => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
const seen = (matrix, colour) => matrix.map(row => Math.min(1, Math.max(0, row.reduce((sum, x, i) => sum + x * colour[i], 0))));

/** CIE L*a*b* of linear RGB. */
function lab([r, g, b]) {
  const f = t => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);
  const x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

const distance = (a, b) => Math.hypot(...a.map((x, i) => x - b[i]));

test("each two colours are told apart with any cones", () => {
  for (const [name, matrix] of Object.entries(SIGHT)) {
    const all = COLOURS.map(colour => lab(seen(matrix, linear(colour))));
    all.forEach((a, i) => all.slice(i + 1).forEach((b, j) =>
      assert.ok(distance(a, b) >= 9, `${name}: ${COLOURS[i]} and ${COLOURS[i + 1 + j]} are ${distance(a, b).toFixed(1)} apart`)));
  }
});

test("colours stand out of the faces and of paper", () => {
  for (const matrix of Object.values(SIGHT)) {
    for (const ground of ["#ffffff", "#dfdad0", "#8fadd6"]) {
      for (const colour of COLOURS) {
        const apart = distance(lab(seen(matrix, linear(colour))), lab(seen(matrix, linear(ground))));
        assert.ok(apart >= 20, `${colour} on ${ground}: ${apart.toFixed(1)}`);
      }
    }
  }
});

test("no two layers look the same, and what is of one colour differs in its symbol", () => {
  const kinds = Array.from({ length: 40 }, (_, i) => `kind-${i}`).concat(["non-manifold-edge", "crossing-faces", "boundary-edge", "generators"]);
  const all = [...looks(kinds).values()];
  assert.equal(new Set(all.map(look => look.colour + look.symbol)).size, kinds.length);
});
