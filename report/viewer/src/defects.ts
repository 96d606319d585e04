// The list of defects: a group for each kind, which is also the switch of its layer. Arrow keys walk through all of them.

import { Item } from "./data.js";
import { counted, h, put, replace, shown } from "./dom.js";
import { Layer } from "./layers.js";
import { prose } from "./links.js";
import { symbolPicture } from "./palette.js";

const CHUNK = 200;

export interface ListAsked {
  toggled(layer: Layer): void;
  chosen(layer: Layer, item: Item): void;
}

export class DefectList {
  private readonly items: { layer: Layer; item: Item }[] = [];
  private readonly details = new Map<string, HTMLDetailsElement>();
  private readonly more = new Map<string, () => void>();
  private readonly places = new Map<string, HTMLElement>();
  private current = -1;

  constructor(private readonly root: HTMLElement, private readonly asked: ListAsked) {}

  show(layers: Layer[], isEmptySaying: string): void {
    this.items.length = 0;
    this.details.clear();
    this.more.clear();
    this.places.clear();
    this.current = -1;
    const defects = layers.filter(layer => layer.section === "defect");
    const notes = layers.filter(layer => layer.section === "note");
    const others = layers.filter(layer => layer.section === "other");
    const open = (defects[0] ?? notes[0])?.name;
    replace(this.root,
      defects.length === 0 && h("p", { class: "good" }, isEmptySaying),
      ...defects.map(layer => this.group(layer, layer.name === open)),
      notes.length > 0 && h("h2", {}, "Worth knowing"),
      ...notes.map(layer => this.group(layer, layer.name === open)),
      others.length > 0 && h("h2", {}, "How it hangs together, and what was done"),
      ...others.map(layer => layer.items.length > 0 ? this.group(layer, false) : h("div", { class: "group plain" }, this.box(layer), h("div", { class: "summary" }, ...this.head(layer)))),
    );
  }

  /** Goes to the next defect, or the one before. */
  walk(step: 1 | -1): void {
    if (this.items.length === 0) return;
    const next = Math.max(0, Math.min(this.items.length - 1, this.current + step));
    this.choose(next);
  }

  /** Takes the mark away. */
  clear(): void {
    this.root.querySelector("[aria-current]")?.removeAttribute("aria-current");
    this.current = -1;
  }

  private box(layer: Layer): HTMLInputElement {
    const box = h("input", {
      type: "checkbox", "aria-label": `show ${layer.title}`, "data-layer": layer.name,
      change: () => { layer.isOn = box.checked; this.asked.toggled(layer); },
    });
    box.checked = layer.isOn;
    return box;
  }

  private head(layer: Layer): Node[] {
    const swatch = symbolPicture(layer.look, 32);
    swatch.className = "swatch";
    swatch.setAttribute("aria-hidden", "true");
    const count = layer.count < layer.of && layer.count > 0 ? `${shown(layer.of)}, first ${shown(layer.count)} drawn` : shown(layer.of);
    return [swatch, h("span", { class: "title", title: layer.hint }, layer.title), h("span", { class: "count" }, count)];
  }

  private group(layer: Layer, isOpen: boolean): HTMLElement {
    const list = h("ol", { class: "items", "aria-label": layer.title });
    const base = this.items.length;
    const { items } = layer;
    items.forEach(item => this.items.push({ layer, item }));
    let filled = 0;
    const more = () => {
      const to = Math.min(items.length, filled + CHUNK);
      list.querySelector(".more")?.remove();
      for (; filled < to; filled++) put(list, this.row(base + filled, items[filled]));
      if (filled < items.length) {
        put(list, h("li", { class: "more" }, h("button", { type: "button", click: more }, `${counted(items.length - filled, "more", "more")}`)));
      } else if (layer.name !== "components" && items.length > 0 && items.length < layer.of) {
        put(list, h("li", { class: "more" }, `and ${shown(layer.of - items.length)} more that this page does not list`));
      }
    };
    const details = h("details", {},
      h("summary", {}, ...this.head(layer)),
      h("p", { class: "explanation" }, ...prose(layer.hint)),
      list);
    details.addEventListener("toggle", () => { if (details.open && filled === 0) more(); });
    this.more.set(layer.name, more);
    this.details.set(layer.name, details);
    if (isOpen) { details.open = true; more(); }
    return h("div", { class: "group" }, this.box(layer), details);
  }

  private row(index: number, item: Item): HTMLElement {
    const button = h("button", {
      type: "button", class: "item", "data-item": index, click: () => this.choose(index),
      keydown: (event: KeyboardEvent) => {
        if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
        event.preventDefault();
        this.current = index;
        this.walk(event.key === "ArrowDown" ? 1 : -1);
        this.places.get(String(this.current))?.focus();
      },
    }, item.message, place(item));
    this.places.set(String(index), button);
    return h("li", {}, button);
  }

  private choose(index: number): void {
    const { layer, item } = this.items[index];
    const details = this.details.get(layer.name);
    if (details !== undefined && !details.open) details.open = true;
    while (!this.places.has(String(index))) {
      const before = this.places.size;
      this.more.get(layer.name)?.();
      if (this.places.size === before) break;
    }
    this.root.querySelector("[aria-current]")?.removeAttribute("aria-current");
    this.current = index;
    const row = this.places.get(String(index));
    row?.setAttribute("aria-current", "true");
    row?.scrollIntoView({ block: "nearest" });
    if (!layer.isOn) {
      layer.isOn = true;
      const box = details?.parentElement?.querySelector<HTMLInputElement>("input[type=checkbox]");
      if (box) box.checked = true;
      this.asked.toggled(layer);
    }
    this.asked.chosen(layer, item);
  }
}

function place(item: Item): HTMLElement | null {
  const first = item.positions?.[0];
  if (first === undefined) return null;
  const number = (x: number | null) => (x === null ? "?" : String(Number(x.toPrecision(5))));
  return h("span", { class: "place" }, `(${first.map(number).join(", ")})`);
}
