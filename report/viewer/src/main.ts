// The page: reads its data, and brings the view, the lists and the address together.

import { Entry, Item, PageData, StateName, figures, groups, title } from "./data.js";
import { control } from "./controls.js";
import { DefectList } from "./defects.js";
import { h, replace, shown } from "./dom.js";
import { indexPanel } from "./index.js";
import { Layer, countedOnly, layerNames, layers } from "./layers.js";
import { linked } from "./links.js";
import { Mesh } from "./mesh.js";
import { countsTable, repairPanel, rowPanel, topologyPanel } from "./panels.js";
import { Found, Selected, find, findItem, fragment, ofFragment } from "./selection.js";
import { Tabs } from "./tabs.js";
import { Toolbar } from "./toolbar.js";
import { Seen, View } from "./view.js";

const page = JSON.parse(document.getElementById("data")!.textContent!) as PageData;
/** From so many faces on a mesh is drawn plainly, so that it turns where there is no graphics card. */
const LARGE = 300_000;
/** Whether there is no mesh at all: the page is on a batch. */
const isOfRows = page.entries.length > 0 && page.entries.every(entry => entry.command === "batch");
const several = page.entries.length > 1;

class Report {
  private entry = -1;
  private states = new Map<StateName, { mesh: Mesh; seen: Seen; layers: Layer[] }>();
  private listed: StateName = "before";
  private ownFragment = "";

  private readonly header = h("header", {});
  private readonly info = h("div", { class: "info", role: "status", "aria-live": "polite" });
  private readonly canvas = h("canvas", {
    tabindex: 0, role: "application", "aria-label": "the mesh in 3D",
    "aria-describedby": "keys",
  });
  private readonly border = h("input", { type: "range", class: "border", min: 0, max: 1, step: 0.002, value: 0.5, "aria-label": "border between before and after", hidden: true });
  private readonly stage = h("div", { class: "stage" });
  private readonly note = h("p", { class: "note" });
  private readonly list = h("section", {});
  private readonly repair = h("section", {});
  private readonly topology = h("section", {});
  private readonly files = h("section", {});
  private readonly paper = h("div", { class: "paper" });
  private readonly defects: DefectList;
  private readonly tabs: Tabs;
  private readonly index: { current(entry: number): void } | null;
  private readonly view: View | null;
  private readonly toolbar: Toolbar | null;

  constructor() {
    const listPanel = h("section", { class: "list" });
    this.defects = new DefectList(this.list, {
      toggled: layer => this.drawLayer(this.listed, layer),
      chosen: (_, item) => this.choose(item),
    });
    listPanel.append(this.jump(), this.list);
    this.tabs = new Tabs([
      ...(several ? [{ name: "files", title: `Files (${shown(page.entries.length)})`, panel: this.files }] : []),
      { name: "defects", title: "Defects", panel: listPanel },
      { name: "repair", title: "Repair", panel: this.repair },
      { name: "topology", title: "Topology", panel: this.topology },
    ]);
    this.view = webgl(this.canvas, page.entries.some(entry => (entry.before?.mesh.faces ?? 0) > LARGE));
    this.toolbar = this.view === null ? null : new Toolbar(this.view, () => this.modeChanged());
    if (this.view !== null) this.control(this.view);
    this.stage.append(this.canvas, this.border, this.info);
    document.body.append(
      this.header,
      h("main", {}, h("section", { class: "seen", "aria-label": "the mesh" }, this.toolbar?.element ?? null, this.stage, this.note, this.paper, help()),
        h("aside", { "aria-label": "the report" }, this.tabs.bar, this.tabs.panels)),
      h("footer", {}, `${page.program}${page.date === null ? "" : `, ${page.date}`}. This page is whole: it asks no network for anything.`));
    this.index = several ? indexPanel(this.files, page, entry => {
      this.goTo({ entry, state: "before", element: "" });
      if (isOfRows) this.tabs.open("repair");
    }) : null;
    document.body.classList.toggle("rows", isOfRows);
    addEventListener("hashchange", () => { if (location.hash !== this.ownFragment) this.follow(); });
    addEventListener("beforeprint", () => this.print());
    this.follow();
  }

  /** Does what the address says. */
  private follow(): void {
    const selected = ofFragment(location.hash, page.entries.length) ?? { entry: 0, state: "before" as const, element: "" };
    this.goTo(selected);
  }

  private goTo(selected: Selected): void {
    if (selected.entry !== this.entry) this.open(selected.entry);
    if (selected.element !== "") this.select(selected);
    else this.address({ ...selected });
  }

  private open(number: number): void {
    this.entry = number;
    const entry = page.entries[number];
    this.states = new Map();
    const names = layerNames(entry);
    for (const state of ["before", "after"] as const) {
      const data = entry[state];
      if (data === undefined) continue;
      const mesh = new Mesh(data.mesh);
      const seen: Seen = { mesh, shape: data.shape === undefined ? null : new Mesh(data.shape), components: data.loops.components };
      this.states.set(state, { mesh, seen, layers: layers(entry, state, data, mesh, page.kinds, names) });
    }
    this.listed = this.states.has("before") ? "before" : "after";
    replace(this.info);
    this.say(entry);
    this.index?.current(number);
    this.tabs.hide("repair", entry.command !== "repair" && entry.command !== "batch");
    this.tabs.hide("topology", entry.command === null);
    if (entry.command === "repair") repairPanel(this.repair, page, entry, { entry: number, state: "before", several });
    if (entry.command === "batch") rowPanel(this.repair, entry);
    if (entry.command !== null) topologyPanel(this.topology, entry, { showLayer: name => this.showLayer(name) });
    this.showStates();
    this.showList();
    this.showPaper(entry);
  }

  private say(entry: Entry): void {
    const report = entry.report;
    const format = figures(entry, "before")?.format ?? report?.format ?? null;
    replace(this.header,
      h("div", { class: "naming" },
        h("h1", {}, page.title),
        h("p", { class: "file" }, several || title(entry) !== page.title ? title(entry) : null, format === null ? null : ` (${format})`),
        h("p", { class: `verdict ${entry.verdict.state}` }, entry.verdict.sentence)),
      countsTable(entry));
    document.title = page.title;
  }

  private showStates(): void {
    const part = [...this.states.values()].find(state => !state.mesh.isWhole)?.mesh;
    replace(this.note, part === undefined ? null :
      `The mesh has ${shown(part.faceCount)} faces, more than this page holds: it shows the ${shown(part.shownFaces)} at and round the defects, and the shape of all of it, thinned.`);
    this.note.hidden = part === undefined;
    this.stage.classList.toggle("empty", this.states.size === 0);
    if (this.view === null) return;
    this.view.show(new Map([...this.states].map(([name, { seen }]) => [name, seen])));
    this.toolbar!.states(this.states.has("before"), this.states.has("after"), [...this.states.values()].some(state => state.seen.components !== undefined));
    for (const [name, state] of this.states) for (const layer of state.layers) if (layer.isOn) this.drawLayer(name, layer);
    this.border.hidden = this.view.mode !== "both";
  }

  private showList(): void {
    const state = this.states.get(this.listed);
    if (state === undefined && page.entries[this.entry].command === "batch") {
      this.defects.show(countedOnly(page.entries[this.entry], page.kinds), "No defect was found.");
      return;
    }
    const sound = this.listed === "after" ? "No defect is left." : "No defect was found.";
    this.defects.show(state?.layers ?? [], state === undefined ? "There is no mesh to look at." : sound);
  }

  private drawLayer(state: StateName, layer: Layer): void {
    if (layer.name === "components") {
      if (this.view !== null && this.view.look.components !== layer.isOn) this.toolbar?.toggle("components");
      return;
    }
    this.view?.layer(state, layer.name, layer.isOn ? layer.shown() : null, layer.look, layer.options);
  }

  private modeChanged(): void {
    const { view } = this;
    if (view === null) return;
    this.border.hidden = view.mode !== "both";
    const listed: StateName = view.mode === "after" ? "after" : "before";
    if (listed !== this.listed && this.states.has(listed)) { this.listed = listed; this.showList(); }
  }

  private see(state: StateName): void {
    if (!this.states.has(state)) return;
    if (this.view !== null && this.view.mode !== "both" && this.view.mode !== state) this.toolbar!.setMode(state);
    else if (this.view === null && this.listed !== state) { this.listed = state; this.showList(); }
  }

  /** Shows a defect of the list. */
  private choose(item: Item): void {
    const state = this.states.get(this.listed);
    if (state === undefined) return;
    const name = item.face !== undefined ? `f${item.face}` : item.edge !== undefined ? `e${item.edge}` : item.vertex !== undefined ? `v${item.vertex}` : "";
    this.address({ entry: this.entry, state: this.listed, element: name });
    this.mark(this.listed, findItem(state.mesh, item), item);
  }

  /** Shows an element by its number. */
  private select(selected: Selected): void {
    this.see(selected.state);
    const state = this.states.get(selected.state);
    if (state === undefined) return;
    const found = find(state.mesh, selected.element);
    if (typeof found === "string") { this.view?.mark(selected.state, null); replace(this.info, h("p", {}, found)); return; }
    this.address(selected);
    this.mark(selected.state, found, { element: selected.element, says: found.says });
  }

  private mark(state: StateName, found: Found, data: object, flies = true): void {
    this.view?.mark(state, found.shown);
    if (flies) this.view?.flyTo(state, found);
    const where = { entry: this.entry, state, several };
    const copy = h("button", { type: "button", class: "copy", click: () => {
      const text = JSON.stringify({ file: title(page.entries[this.entry]), state, ...data });
      void copyText(text).then(isDone => replace(copy, isDone ? "Copied" : "Not copied"));
    } }, "Copy as JSON");
    const faces = found.shown.faces.length > 0 && found.shown.faces.length <= 12
      ? found.shown.faces.map(place => `f${this.states.get(state)!.mesh.faceId(place)}`).join(" ") : "";
    const says = [...linked(found.says, where)];
    replace(this.info, h("p", {}, ...says, faces !== "" && !found.says.startsWith("f") && h("span", { class: "faces" }, " faces ", ...linked(faces, where))), copy,
      h("button", { type: "button", class: "close", "aria-label": "take the mark away", click: () => this.clear() }, "×"));
  }

  private clear(): void {
    this.view?.mark(this.listed, null);
    this.defects.clear();
    replace(this.info);
    this.address({ entry: this.entry, state: this.listed, element: "" });
  }

  private address(selected: Selected): void {
    const text = fragment(selected, several);
    this.ownFragment = text === "#" ? "" : text;
    history.replaceState(null, "", text === "#" ? location.pathname + location.search : text);
  }

  /** Opens the group of a layer, switches it on, and shows all of it. */
  private showLayer(name: string): void {
    if (name === "components") { if (!this.view?.look.components) this.toolbar?.toggle("components"); this.view?.fit(); return; }
    for (const [state, { layers }] of this.states) {
      const layer = layers.find(layer => layer.name === name);
      if (layer === undefined) continue;
      this.see(state);
      layer.isOn = true;
      this.drawLayer(state, layer);
      this.tabs.open("defects");
      this.showList();
      this.view?.fit();
      return;
    }
  }

  private jump(): HTMLElement {
    const field = h("input", { type: "text", placeholder: "v12, e7 or f3", "aria-label": "go to a vertex, an edge or a face", size: 12, autocomplete: "off", spellcheck: "false" });
    return h("form", { class: "jump", submit: (event: Event) => {
      event.preventDefault();
      const name = field.value.trim().toLowerCase();
      if (/^[vef]\d+$/.test(name)) this.select({ entry: this.entry, state: this.listed, element: name });
      else replace(this.info, h("p", {}, "A vertex, an edge or a face has a name such as v12, e7 or f3."));
    } }, field, h("button", { type: "submit" }, "Go to"), h("button", { type: "button", click: () => this.defects.walk(-1) }, "Previous"),
      h("button", { type: "button", click: () => this.defects.walk(1) }, "Next"));
  }

  private control(view: View): void {
    this.border.addEventListener("input", () => { view.border = Number(this.border.value); this.placeBorder(); view.draw(); });
    this.placeBorder();
    control(view, {
      picked: (x, y) => {
        const hit = view.pick(x, y);
        if (hit === null) { this.clear(); return; }
        const mesh = this.states.get(hit.state)!.mesh;
        const selected: Selected = { entry: this.entry, state: hit.state, element: `f${mesh.faceId(hit.face)}` };
        const found = find(mesh, selected.element);
        if (typeof found === "string") return;
        this.address(selected);
        // What is picked by hand is seen already: the camera stays.
        this.mark(hit.state, found, { element: selected.element, says: found.says }, false);
      },
      toggle: what => this.toolbar!.toggle(what), nextMode: () => this.toolbar!.nextMode(),
      walk: step => this.defects.walk(step), clear: () => this.clear(),
    });
  }

  private placeBorder(): void { this.stage.style.setProperty("--border", `${(this.view?.border ?? 0.5) * 100}%`); }

  /** Still pictures: what there is to see without WebGL, and on paper. */
  private showPaper(entry: Entry): void {
    const picture = (state: StateName) => (entry[state]?.pictures ?? []).map(uri =>
      h("figure", {}, h("img", { src: uri, alt: `the mesh ${state === "after" ? "after the repair" : "as it is stored"}`, class: "still" }),
        h("figcaption", {}, entry.after === undefined ? "as stored" : state)));
    replace(this.paper, ...picture("before"), ...picture("after"));
    document.body.classList.toggle("still", this.view === null);
  }

  private print(): void {
    for (const details of document.querySelectorAll("aside details")) (details as HTMLDetailsElement).open ||= groups(page.entries[this.entry], this.listed).length < 8;
  }
}

function webgl(canvas: HTMLCanvasElement, isLarge: boolean): View | null {
  try { return new View(canvas, isLarge); } catch { return null; }
}

async function copyText(text: string): Promise<boolean> {
  try { await navigator.clipboard.writeText(text); return true; } catch { /* a page from a disk may not be allowed to */ }
  const field = h("textarea", { "aria-hidden": "true", class: "copying" });
  field.value = text;
  document.body.append(field);
  field.select();
  const isDone = document.execCommand("copy");
  field.remove();
  return isDone;
}

function help(): HTMLElement {
  const keys: [string, string][] = [
    ["arrows", "turn"], ["Shift + arrows", "move"], ["+ −", "zoom"], ["f", "fit"], ["1 – 6", "sides"], ["e s t k g", "edges, smooth, see-through, backs, components"],
    ["p", "parallel"], ["c", "cut"], ["b", "before, both, after"], ["n N", "next, previous defect"], ["Esc", "take the mark away"],
  ];
  return h("details", { class: "keys" }, h("summary", {}, "Keys"),
    h("p", { id: "keys" }, ...keys.flatMap(([key, what]) => [h("kbd", {}, key), ` ${what}  `]), "Drag turns, right drag moves, the wheel zooms, a click tells which face it is."));
}

new Report();
