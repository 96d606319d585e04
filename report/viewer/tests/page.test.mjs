// The page in a real browser: what it shows, what a hand and keys do, and what it never does.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { PNG } from "pngjs";
import { close, differing, folder, golden, meshmend, near, open, root, settled, view } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const HOSTILE = "<img src=x onerror=alert(1)>&amp;'\u202e.obj";

before(() => {
  copyFileSync(join(root, "examples/broken.obj"), join(folder, "broken.obj"));
  copyFileSync(join(root, "examples/broken.obj"), join(folder, HOSTILE));
  writeFileSync(join(folder, "bad.ply"), "this is no mesh\n");
  meshmend("make", "klein-bottle", "-o", "klein.obj");
  meshmend("make", "surface", "--genus", "4", "-o", "four.obj");
  // A cube with a hole, and another one beside it.
  const cube = "f 1 2 4 3\nf 1 3 7 5\nf 1 5 6 2\nf 2 6 8 4\nf 3 4 8 7\nf 5 7 8 6\n";
  const points = [0, 3].flatMap(x => Array.from({ length: 8 }, (_, i) => `v ${x + (i & 1)} ${(i >> 1) & 1} ${i >> 2}\n`)).join("");
  writeFileSync(join(folder, "two.obj"), points + cube.replace("f 5 7 8 6\n", "") + cube.replace(/\d+/g, v => Number(v) + 8));
  meshmend("report", "two.obj", "-o", "holed.html", "--check-only");
  meshmend("report", "broken.obj", "-o", "broken.html", "--geometry");
  meshmend("report", "klein.obj", "-o", "klein.html", "--check-only");
  meshmend("report", "four.obj", "-o", "four.html");
  meshmend("report", HOSTILE, "-o", "hostile.html", "--title", "</title><script>alert(2)</script>");
  meshmend("report", "broken.obj", "klein.obj", "four.obj", "bad.ply", HOSTILE, "-o", "several.html");
});
after(close);

test("a page opens from a disk without an error and asks for nothing", async () => {
  for (const name of ["broken", "klein", "four", "several"]) {
    const { page, errors, requests, close } = await open(`${name}.html`);
    assert.deepEqual(errors, [], name);
    assert.deepEqual(requests.length, 1, `${name}: only itself: ${requests}`);
    assert.equal(await page.evaluate(async () => {
      try { await fetch("https://example.org/"); return "asked"; } catch { return "refused"; }
    }), "refused", "the page's policy forbids requests");
    await close();
  }
});

test("the same meshes give the same page", () => {
  meshmend("report", "broken.obj", "-o", "again.html", "--geometry");
  assert.equal(readFileSync(join(folder, "again.html"), "utf8"), readFileSync(join(folder, "broken.html"), "utf8"));
});

test("the header tells the verdict and the counts before and after", async () => {
  const { page, close } = await open("broken.html");
  assert.match(await page.locator(".verdict").innerText(), /Mended: \d+ defects before, none left; one face was removed\./);
  const cells = await page.locator(".counts tbody tr").allInnerTexts();
  assert.match(cells[0], /before\s+20\s+28\s+13\s+3/);
  assert.match(cells[1], /after\s+16\s+24\s+12\s+2\s+2 × sphere/);
  await close();
});

test("each layer of what is seen switches pixels on and off", async () => {
  const { page, close } = await open("broken.html");
  for (const kind of ["non-manifold-edge", "boundary-edge", "inconsistent-edge", "singular-vertex"]) {
    const box = page.locator(`[data-layer="${kind}"]`);
    await box.check();
    await settled(page);
    const on = await view(page);
    await box.uncheck();
    await settled(page);
    assert.ok(differing(on, await view(page)) > 60, kind);
  }
  await page.getByRole("button", { name: "See-through" }).click();
  await settled(page);
  await close();
});

test("the switches of the view change what is seen", async () => {
  const { page, close } = await open("four.html");
  for (const name of ["Edges", "See-through", "Parallel", "Cut", "Top", "Left"]) {
    const was = await view(page);
    await page.getByRole("button", { name, exact: true }).click();
    await settled(page);
    assert.ok(differing(was, await view(page)) > 200, name);
  }
  await close();
});

test("the n-th defect is marked, named in the address, and the camera goes there", async () => {
  const { page, close } = await open("broken.html");
  const was = await view(page);
  const details = page.locator("details", { hasText: "non-manifold edges" }).last();
  await details.locator("summary").click();
  await details.locator(".item").nth(2).click();
  await settled(page);
  assert.match(await page.locator(".info p").innerText(), /has 3 sides/);
  const edge = (await details.locator(".item").nth(2).innerText()).match(/^e\d+/)[0];
  assert.equal(new URL(page.url()).hash, `#${edge}`);
  assert.equal(await details.locator(".item").nth(2).getAttribute("aria-current"), "true");
  assert.ok(near(await view(page), "#ffd60a", 60) > 100, "the mark is seen");
  assert.ok(differing(was, await view(page)) > 5000, "the camera moved");
  await close();
});

test("numbers of edges are those of the report, also where vertices are welded", async () => {
  meshmend("make", "klein-bottle", "-o", "klein.stl");
  for (const input of ["broken.obj", "klein.stl"]) {
    meshmend("report", input, "-o", "edges.html", "--check-only");
    const checked = JSON.parse(meshmend("check", input, "--json", "--limit", "100"));
    const items = checked.defects.flatMap(group => group.items).filter(item => item.edge !== undefined);
    assert.ok(items.length > 4, input);
    const { page, close } = await open("edges.html");
    for (const { edge, ends } of items.slice(0, 8)) {
      await page.getByLabel("go to a vertex, an edge or a face").fill(`e${edge}`);
      await page.keyboard.press("Enter");
      assert.match(await page.locator(".info p").innerText(), new RegExp(`^e${edge} from v${ends[0]} to v${ends[1]},`));
    }
    await close();
  }
});

test("an address leads to its element, before and after", async () => {
  for (const [hash, says] of [["#f3", /^f3: v/], ["#after/v5", /^v5 at/], ["#e7", /^e7 from/], ["#f99", /There is no f99/]]) {
    const { page, close } = await open("broken.html", { hash });
    assert.match(await page.locator(".info p").innerText(), says);
    assert.equal(await page.getByRole("button", { name: "After", exact: true }).getAttribute("aria-pressed"), String(hash.includes("after")));
    await close();
  }
});

test("what is picked in the view is told", async () => {
  const { page, close } = await open("four.html");
  const box = await page.locator("canvas").first().boundingBox();
  await page.mouse.click(box.x + box.width * 0.35, box.y + box.height * 0.42);
  await settled(page);
  assert.match(await page.locator(".info p").innerText(), /^f\d+: v\d+/);
  assert.match(new URL(page.url()).hash, /^#f\d+$/);
  await close();
});

test("what is copied says what is selected", async () => {
  const { page, close } = await open("broken.html", { context: { permissions: ["clipboard-read", "clipboard-write"] } });
  await page.getByRole("button", { name: "Next", exact: true }).click();
  await page.getByRole("button", { name: "Copy as JSON" }).click();
  await page.getByRole("button", { name: "Copied" }).waitFor();
  const copied = JSON.parse(await page.evaluate(() => navigator.clipboard.readText()));
  assert.deepEqual([copied.file, copied.state, copied.kind], ["broken.obj", "before", "duplicate-face"]);
  await close();
});

test("keys alone reach everything", async () => {
  const { page, close } = await open("broken.html");
  const reached = new Set();
  for (let i = 0; i < 80; i++) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => {
      const at = document.activeElement;
      return at === document.body ? "" : at.getAttribute("data-layer") ?? at.getAttribute("aria-label") ?? at.textContent.trim().slice(0, 24);
    }));
  }
  for (const name of ["the mesh in 3D", "Before", "Both", "After", "Edges", "Fit", "Cut", "Top", "Defects", "Go to", "Next", "non-manifold-edge"]) {
    assert.ok(reached.has(name), `${name}: ${[...reached].join(" | ")}`);
  }
  const seen = async key => {
    await page.locator("canvas").first().focus();
    const was = await view(page);
    await page.keyboard.press(key);
    await settled(page);
    return differing(was, await view(page));
  };
  for (const key of ["e", "ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "f", "5", "t", "p", "c", "b", "n"]) {
    assert.ok((await seen(key)) > 50, key);
  }
  assert.match(await page.locator(".info p").innerText(), /f6 is f5 again/);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".info p").count(), 0);
  await page.locator("[data-item='0']").focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("data-item")), "2");
  await page.locator("#tab-defects").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.locator("#tab-repair").getAttribute("aria-selected"), "true");
  await close();
});

test("before, after and both are seen, with a border that moves", async () => {
  const { page, close } = await open("broken.html");
  const pictures = {};
  for (const name of ["Before", "Both", "After"]) {
    await page.getByRole("button", { name, exact: true }).click();
    await settled(page);
    pictures[name] = await view(page);
  }
  assert.ok(differing(pictures.Before, pictures.After) > 500 && differing(pictures.Before, pictures.Both) > 200);
  await page.getByRole("button", { name: "Both", exact: true }).click();
  await page.locator(".border").fill("0.9");
  await settled(page);
  assert.ok(differing(pictures.Both, await view(page)) > 500, "the border moved");
  await page.getByRole("button", { name: "After", exact: true }).click();
  assert.match(await page.locator("#panel-defects").innerText(), /No defect is left\./);
  await close();
});

test("the repair is told pass by pass, and what went is shown as a ghost", async () => {
  const { page, close } = await open("broken.html");
  await page.locator("#tab-repair").click();
  const rows = await page.locator(".passes tbody tr").allInnerTexts();
  assert.deepEqual(rows.map(row => row.split(/\s/)[0]), ["weld", "clean", "orient", "split", "triangulate", "compact", "verify"]);
  assert.match(rows[0], /6\s+−1\s+−2\s+–/);
  await page.locator("#panel-repair a", { hasText: "f6" }).click();
  assert.match(await page.locator(".info p").innerText(), /^f6: v2 v0 v4 v6/);
  await page.locator("#tab-defects").click();
  const ghost = page.locator('[data-layer="removed:duplicate-face"]');
  assert.ok(await ghost.isChecked());
  await close();
});

test("figures of the topology stand with a sentence each and lead to what they count", async () => {
  const { page, close } = await open("four.html");
  await page.locator("#tab-topology").click();
  const text = await page.locator("#panel-topology").innerText();
  assert.match(text, /Genus\s+4\s+4/);
  assert.match(text, /Betti numbers mod 2\s+1 8 1/);
  assert.match(text, /Instigators/);
  await page.locator("#panel-topology tr", { hasText: /^Genus/ }).first().locator("button").first().click();
  assert.equal(await page.locator("#tab-defects").getAttribute("aria-selected"), "true");
  assert.ok(await page.locator('[data-layer="generators"]').isChecked());
  await close();
});

test("boundary loops and components are listed and gone to", async () => {
  const { page, close } = await open("holed.html");
  for (const [title, says] of [["boundary loops", /^\d+ edges from v\d+/], ["components", /^2 × sphere|sphere|disc/]]) {
    const details = page.locator("details", { hasText: title }).last();
    await details.locator("summary").click();
    await details.locator(".item").first().click();
    await settled(page);
    assert.match(await page.locator(".info p").innerText(), says);
  }
  await page.locator("canvas").first().press("Escape");
  await page.locator("canvas").first().press("f");
  await settled(page);
  const was = await view(page);
  // Whoever goes to a component sees which faces are it.
  assert.ok(await page.locator('[data-layer="components"]').isChecked());
  await page.locator('[data-layer="components"]').uncheck();
  await settled(page);
  assert.ok(differing(was, await view(page), 0.05) > 3000, "components have colours");
  await close();
});

test("a defect is gone to where it is seen", async () => {
  const { page, close } = await open("broken.html");
  for (const item of await page.locator("details", { hasText: "inconsistently oriented" }).last().locator("summary").all()) await item.click();
  await page.locator("details", { hasText: "inconsistently oriented" }).last().locator(".item").nth(1).click();
  await settled(page);
  const picture = await view(page);
  let bright = 0;
  for (let y = picture.height * 0.4 | 0; y < picture.height * 0.6; y++) for (let x = picture.width * 0.4 | 0; x < picture.width * 0.6; x++) {
    const i = 4 * (y * picture.width + x);
    if (picture.data[i] > 240 && picture.data[i + 1] > 190 && picture.data[i + 2] < 60) bright++;
  }
  assert.ok(bright > 60, `${bright} pixels of the mark in the middle`);
  await close();
});

test("a Klein bottle shows the strip that comes back mirrored", async () => {
  const { page, close } = await open("klein.html");
  const box = page.locator('[data-layer="non-orientable-patch"]');
  assert.ok(await box.isChecked());
  const on = await view(page);
  await box.uncheck();
  await settled(page);
  const count = differing(on, await view(page));
  assert.ok(count > 1000, `${count} pixels`);
  await close();
});

test("names of files stay text", async () => {
  for (const name of ["hostile.html", "several.html"]) {
    const { page, errors, close } = await open(name, { init: () => { window.alert = () => { window.wasAlerted = true; }; } });
    if (name === "several.html") await page.locator(`[data-entry="4"]`).click();
    assert.equal(await page.evaluate(() => window.wasAlerted ?? false), false);
    assert.equal(await page.locator("img[onerror]").count(), 0);
    assert.ok((await page.locator("header").innerText()).includes(HOSTILE));
    assert.deepEqual(errors, []);
    await close();
  }
});

test("the index sorts, filters and opens", async () => {
  const { page, close } = await open("several.html");
  const names = () => page.locator(".files tbody th").allInnerTexts();
  assert.equal((await names()).length, 5);
  await page.getByRole("button", { name: "Faces", exact: true }).click();
  assert.equal((await names())[0], "four.obj");
  await page.getByLabel("only files with").selectOption("non-orientable-patch");
  assert.deepEqual(await names(), ["klein.obj"]);
  await page.getByRole("button", { name: "klein.obj" }).click();
  await settled(page);
  assert.match(await page.locator(".counts").innerText(), /Klein bottle/);
  assert.equal(new URL(page.url()).hash, "#2");
  await page.getByLabel("only files with").selectOption("");
  await page.getByRole("button", { name: "bad.ply" }).click();
  assert.match(await page.locator(".verdict").innerText(), /PLY/);
  await page.goto("about:blank");
  await close();
});

test("a batch has a page of rows", async () => {
  meshmend("batch", "broken.obj", "klein.obj", "bad.ply", "-o", "mended", "--html", "batch.html");
  const { page, errors, close } = await open("batch.html");
  assert.deepEqual(errors, []);
  assert.ok(!(await page.locator("canvas").first().isVisible()));
  const rows = await page.locator(".files tbody tr").allInnerTexts();
  assert.deepEqual(rows.map(row => row.split(/\s+/)[0]), ["bad.ply", "broken.obj", "klein.obj"]);
  await page.getByRole("button", { name: "broken.obj" }).click();
  assert.match(await page.locator("#panel-repair").innerText(), /Output\s+mended\/broken.obj/);
  await page.locator("#tab-defects").click();
  assert.match(await page.locator("#panel-defects").innerText(), /non-manifold edges\s+4/);
  await close();
});

test("without WebGL there are still pictures, and all else", async () => {
  const { page, errors, close } = await open("broken.html", {
    init: () => { HTMLCanvasElement.prototype.getContext = new Proxy(HTMLCanvasElement.prototype.getContext, {
      apply: (target, at, [kind, ...rest]) => (String(kind).startsWith("webgl") ? null : Reflect.apply(target, at, [kind, ...rest])) }); },
  });
  assert.equal(await page.locator("img.still").count(), 2);
  assert.ok(await page.locator("img.still").first().evaluate(image => image.complete && image.naturalWidth > 100));
  await page.getByRole("button", { name: "Next", exact: true }).click();
  assert.match(await page.locator(".info p").innerText(), /f6 is f5 again/);
  assert.deepEqual(errors.filter(error => !/WebGL/.test(error)), []);
  await close();
});

test("on paper all is there, with pictures", async () => {
  const { page, close } = await open("broken.html");
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator("img.still").first().isVisible());
  assert.ok(await page.locator("#panel-repair").isVisible() && await page.locator("#panel-topology").isVisible());
  assert.ok(!(await page.locator(".toolbar").isVisible()));
  const pdf = await page.pdf({ path: join(folder, "broken.pdf") });
  assert.ok(pdf.length > 20_000);
  await close();
});

test("a mesh of more faces than a page holds is shown by its defects and its shape", async () => {
  writeFileSync(join(folder, "holed.obj"), readFileSync(join(folder, "four.obj"), "utf8").replace(/^f .*\n/m, ""));
  meshmend("report", "holed.obj", "-o", "thin.html", "--check-only", "--max-faces", "60");
  const { page, errors, close } = await open("thin.html");
  assert.match(await page.locator(".note").innerText(), /The mesh has 343 faces, more than this page holds/);
  assert.deepEqual(errors, []);
  await page.locator(".item").first().click();
  await settled(page);
  assert.ok(near(await view(page), "#ffd60a", 60) > 100);
  await close();
});

test("a rule book of accessibility finds nothing", async () => {
  for (const [name, tabs] of [["broken", ["defects", "repair", "topology"]], ["several", ["files", "defects"]]]) {
    const { page, close } = await open(`${name}.html`, { hash: "" });
    for (const tab of tabs) {
      await page.locator(`#tab-${tab}`).click();
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      assert.deepEqual(violations.map(one => `${one.id}: ${one.nodes.map(node => node.html).slice(0, 3).join(" ")}`), [], `${name}, ${tab}`);
    }
    await close();
  }
});

test("pages look as they did", async () => {
  for (const name of ["broken", "klein", "four"]) {
    const { page, close } = await open(`${name}.html`);
    golden(name, await view(page));
    await close();
  }
});

test("the README's picture is what is seen", async () => {
  const { page, close } = await open("broken.html", { context: { viewport: { width: 1180, height: 720 } } });
  await page.locator("summary", { hasText: "inconsistently oriented edges" }).click();
  await page.locator("details", { hasText: "inconsistently oriented edges" }).last().locator(".item").nth(1).click();
  await settled(page);
  // Texts look different with other fonts.
  golden("report", PNG.sync.read(await page.screenshot()), 0.08, join(root, "docs/report.png"));
  await close();
});
