// A million faces: how long the page takes to open and to turn. The figures are told; only nonsense fails.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { close, meshmend, open, settled } from "./browser.mjs";

after(close);

test("a million faces open and turn", { skip: process.env.LARGE === "0" && "LARGE=0" }, async () => {
  meshmend("make", "torus", "--resolution", "707", "-o", "large.ply");
  meshmend("report", "large.ply", "-o", "large.html", "--check-only");
  const began = performance.now();
  const { page, errors, close } = await open("large.html");
  const opened = performance.now() - began;
  assert.deepEqual(errors, []);
  await page.locator("canvas").first().focus();
  const turning = performance.now();
  for (let i = 0; i < 5; i++) {
    const was = await page.evaluate(() => document.querySelector("canvas").dataset.frames);
    await page.keyboard.press("ArrowLeft");
    await page.waitForFunction(was => document.querySelector("canvas").dataset.frames !== was, was);
  }
  const turned = (performance.now() - turning) / 5;
  await settled(page);
  const faces = await page.locator(".counts tbody td").nth(2).innerText();
  console.log(`${faces} faces: opened in ${(opened / 1000).toFixed(1)} s, ${turned.toFixed(0)} ms a turn, without a graphics card`);
  assert.ok(opened < 60_000);
  await close();
});
