// The index of a page on several meshes: a row each, sorted as asked, filtered by what is wrong.

import { Entry, PageData, figures, groups, title } from "./data.js";
import { h, replace, shown } from "./dom.js";

interface Row { entry: number; cells: (string | number)[] }

const COLUMNS = ["File", "Verdict", "Faces", "Defects", "Left"];

export function indexPanel(root: HTMLElement, page: PageData, open: (entry: number) => void): { current(entry: number): void } {
  const kinds = [...new Set(page.entries.flatMap(entry => wrong(entry).map(group => group.kind)))].sort();
  let sorted = 0;
  let isDown = false;
  let only = "";
  let text = "";
  let current = 0;
  const folder = common(page.entries.map(entry => entry.name));
  const rows: Row[] = page.entries.map((entry, number) => ({
    entry: number,
    cells: [title(entry).slice(folder.length), entry.verdict.state.replace("-", " "), figures(entry, "before")?.faces ?? 0, total(entry, "before"), entry.command === "repair" ? total(entry, "after") : entry.verdict.state === "mended" || entry.verdict.state === "sound" ? 0 : "–"],
  }));
  const body = h("tbody", {});
  const heads = COLUMNS.map((name, column) => h("th", { scope: "col", class: column >= 2 ? "number" : "" },
    h("button", { type: "button", class: "sort", click: () => { isDown = sorted === column ? !isDown : column >= 2; sorted = column; fill(); } }, name)));
  const fill = () => {
    const kept = rows.filter(row => String(row.cells[0]).toLowerCase().includes(text) &&
      (only === "" || wrong(page.entries[row.entry]).some(group => group.kind === only)));
    kept.sort((a, b) => {
      const [x, y] = [a.cells[sorted], b.cells[sorted]];
      const order = typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y), "en");
      return (isDown ? -order : order) || a.entry - b.entry;
    });
    heads.forEach((head, column) => head.setAttribute("aria-sort", column !== sorted ? "none" : isDown ? "descending" : "ascending"));
    replace(body, ...kept.map(row => h("tr", { class: row.entry === current ? "current" : "" },
      h("th", { scope: "row" }, h("button", { type: "button", class: "open", "data-entry": row.entry, click: () => open(row.entry) }, String(row.cells[0]))),
      h("td", { class: `state ${page.entries[row.entry].verdict.state}`, title: page.entries[row.entry].verdict.sentence }, String(row.cells[1])),
      ...row.cells.slice(2).map(cell => h("td", { class: "number" }, typeof cell === "number" ? shown(cell) : cell)))));
    if (kept.length === 0) body.append(h("tr", {}, h("td", { colspan: COLUMNS.length }, "No file is like that.")));
  };
  const choice = h("select", { "aria-label": "only files with", change: () => { only = choice.value; fill(); } },
    h("option", { value: "" }, "all files"), ...kinds.map(kind => h("option", { value: kind }, `with ${page.kinds[kind]?.title ?? kind}`)));
  const search = h("input", { type: "search", placeholder: "name", "aria-label": "part of the name", input: () => { text = search.value.toLowerCase(); fill(); } });
  replace(root,
    h("div", { class: "filters" }, search, choice),
    h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "files" },
      h("table", { class: "files" }, h("thead", {}, h("tr", {}, ...heads)), body)));
  fill();
  return { current(entry: number) { current = entry; fill(); } };
}

/** The folder that all names begin with. */
function common(names: string[]): string {
  const [first = "", ...others] = names;
  const parts = first.split(/(?<=[/\\])/).slice(0, -1);
  while (parts.length > 0 && !others.every(name => name.startsWith(parts.join("")))) parts.pop();
  return parts.join("");
}

const wrong = (entry: Entry) => groups(entry, "before").filter(group => group.severity === "defect");

function total(entry: Entry, state: "before" | "after"): number {
  return groups(entry, state).filter(group => group.severity === "defect").reduce((sum, group) => sum + group.count, 0);
}
