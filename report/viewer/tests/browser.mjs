// What the tests share: a browser, pages that the program makes, and pictures that are compared.
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import pixelmatch from "pixelmatch";
import { chromium } from "playwright-core";
import { PNG } from "pngjs";

const here = dirname(fileURLToPath(import.meta.url));
export const root = join(here, "../../..");
export const folder = mkdtempSync(join(tmpdir(), "meshmend-report-"));

const program = process.env.MESHMEND ?? join(root, "target/debug/meshmend");
const browserPath = [process.env.CHROMIUM, "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"]
  .find(path => path !== undefined && existsSync(path));

/** Runs the program; a check that fails is no failure of the test. */
export function meshmend(...words) {
  try {
    return execFileSync(program, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"], maxBuffer: 1 << 28 });
  } catch (error) {
    if (error.status === undefined || ![1, 3].includes(error.status)) throw error;
    return error.stdout;
  }
}

let launched = null;

export async function browser() {
  launched ??= await chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
      "--force-color-profile=srgb", "--font-render-hinting=none"],
  });
  return launched;
}

export async function close() { await launched?.close(); }

/** A page that is open, with all that it complained of and asked for. */
export async function open(name, { hash = "", context = {}, init = null } = {}) {
  const at = await (await browser()).newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...context });
  const page = await at.newPage();
  const [errors, requests] = [[], []];
  page.on("console", message => { if (message.type() === "error") errors.push(message.text()); });
  page.on("pageerror", error => errors.push(error.message));
  page.on("request", request => { if (!/^(data|blob):/.test(request.url())) requests.push(request.url()); });
  if (init !== null) await page.addInitScript(init);
  await page.goto(`file://${join(folder, name)}${hash}`);
  await settled(page);
  return { page, errors, requests, close: () => at.close() };
}

/** Waits until nothing was drawn for a while. */
export async function settled(page) {
  let last = null;
  for (let i = 0; i < 100; i++) {
    await page.waitForTimeout(60);
    const now = await page.evaluate(() => document.querySelector("canvas")?.dataset.frames ?? "none");
    if (now === last) return;
    last = now;
  }
}

/** The view as pixels. */
export async function view(page) { return PNG.sync.read(await page.locator(".stage").screenshot()); }

/** How many pixels are near a colour. */
export function near(picture, colour, tolerance = 40) {
  const [r, g, b] = [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16));
  let count = 0;
  for (let i = 0; i < picture.data.length; i += 4) {
    const [x, y, z] = [picture.data[i] - r, picture.data[i + 1] - g, picture.data[i + 2] - b];
    if (x * x + y * y + z * z < tolerance * tolerance) count++;
  }
  return count;
}

/** How many pixels of two pictures differ. */
export function differing(a, b, threshold = 0.15) {
  if (a.width !== b.width || a.height !== b.height) return a.width * a.height;
  return pixelmatch(a.data, b.data, null, a.width, a.height, { threshold });
}

/** Compares with the picture that is kept, or keeps it where UPDATE=1. */
export function golden(name, picture, share = 0.02, path = join(here, "golden", `${name}.png`)) {
  if (process.env.UPDATE === "1" || !existsSync(path)) {
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, PNG.sync.write(picture));
    return;
  }
  const count = differing(PNG.sync.read(readFileSync(path)), picture);
  if (count > share * picture.width * picture.height) {
    const seen = join(folder, `${name}.png`);
    writeFileSync(seen, PNG.sync.write(picture));
    throw new Error(`${name}: ${count} pixels differ from ${path}; what was seen is ${seen}`);
  }
}
