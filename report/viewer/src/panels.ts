// What the page says beside the list of defects: what the repair did, the figures, and what else there is to know.

import { Entry, Json, PageData, figures } from "./data.js";
import { counted, h, replace, shown } from "./dom.js";
import { FIGURES, INSTIGATORS } from "./figures.js";
import { Where, linked, prose } from "./links.js";

export interface PanelAsked { showLayer(name: string): void }

const named = (page: PageData, kind: string): string => page.kinds[kind]?.title ?? kind;

/** What the repair did: a row a pass, what went, what was lost, and what is left. */
export function repairPanel(root: HTMLElement, page: PageData, entry: Entry, where: Where): void {
  const report = entry.report;
  const passes: Json[] = report.passes ?? [];
  const before: Where = { ...where, state: "before" };
  const after: Where = { ...where, state: "after" };
  const delta = (value: number | null | undefined) => value === null || value === undefined ? "–" : value > 0 ? `+${value}` : String(value).replace("-", "−");
  const rows = passes.map(pass => {
    const mended = Object.entries(pass.mended ?? {}).map(([kind, list]) => `${named(page, kind)}: ${shown((list as Json).count)}`);
    const left = Object.entries(pass.left ?? {}).map(([kind, list]) => `left: ${named(page, kind)}: ${shown((list as Json).count)}`);
    const extra: string[] = [];
    if (pass.loops) extra.push(counted(pass.loops.count, "boundary loop") + " judged");
    if (pass.t_junctions) extra.push(`${shown(pass.t_junctions.healed.count)} healed, ${shown(pass.t_junctions.left.count)} left`);
    if (pass.slivers) extra.push(`${counted(pass.slivers.steps.count, "step")}, ${shown(pass.slivers.left.count)} left`);
    if (pass.dropped) extra.push(`${counted(pass.dropped.components.count, "component")} dropped`);
    if (pass.seam) extra.push("cut open along a seam");
    if (pass.looked) extra.push("looked at the result");
    const said = [...mended, ...left, ...extra];
    return h("tr", { class: pass.changed ? "" : "idle" },
      h("th", { scope: "row" }, pass.pass), h("td", {}, said.length > 0 ? said.join("; ") : "nothing to do"),
      h("td", { class: "number" }, delta(pass.delta?.euler_characteristic)),
      h("td", { class: "number" }, delta(pass.delta?.components)), h("td", { class: "number" }, delta(pass.delta?.boundary_loops)));
  });
  const removed = report.removed_faces ?? { count: 0, by_reason: {}, items: [] };
  const left: Json[] = (report.after?.defects ?? []);
  replace(root,
    h("h2", {}, "Passes"),
    h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "passes" }, h("table", { class: "passes" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Pass"), h("th", { scope: "col" }, "What it did"),
        h("th", { scope: "col", class: "number", title: "change of the Euler characteristic" }, "Δχ"),
        h("th", { scope: "col", class: "number", title: "change of the number of components" }, "Δs"),
        h("th", { scope: "col", class: "number", title: "change of the number of boundary loops" }, "Δb"))),
      h("tbody", {}, ...rows))),
    h("h2", {}, "Removed faces"),
    removed.count === 0 ? h("p", {}, "No face was removed.") : h("p", {},
      Object.entries(removed.by_reason).map(([kind, count]) => `${named(page, kind)}: ${shown(count as number)}`).join("; "), "."),
    removed.count > 0 && elements(removed.items.map((face: Json) => `f${face.face}`), removed.count, before),
    ...listing("Turned faces", (report.flipped_faces?.items ?? []).map((face: number) => `f${face}`), report.flipped_faces?.count ?? 0, after),
    ...listing("Created faces", (report.created_faces?.items ?? []).map((face: Json) => `f${face.face}`), report.created_faces?.count ?? 0, after),
    ...listing("Created vertices", (report.created_vertices?.items ?? []).map((vertex: number) => `v${vertex}`), report.created_vertices?.count ?? 0, after),
    report.stitched > 0 && h("p", {}, `${counted(report.stitched, "vertex", "vertices")} that had been joined are apart again, each in its place.`),
    report.rounding && h("p", {}, `Rounding to the format's precision moved ${counted(report.rounding.moved, "vertex", "vertices")}.`),
    ...messages("Names of which nothing is left", (report.emptied_names?.items ?? []).map((name: Json) => name.message)),
    ...messages("What the format does not hold", (report.losses ?? []).map((loss: Json) => loss.message)),
    h("h2", {}, "What is left"),
    left.length === 0 ? h("p", { class: "good" }, "Nothing: no defect, and nothing worth knowing.") : h("ul", {},
      ...left.map(group => h("li", {}, `${named(page, group.kind)}: ${shown(group.count)}`,
        h("p", { class: "explanation" }, ...prose(page.kinds[group.kind]?.explanation ?? ""))))),
    ...geometry(page, report.geometry_changes),
    ...messages("Notes of the reader", (report.notes ?? []).map((note: Json) => note.message)),
  );
}

function elements(names: string[], count: number, where: Where): HTMLElement {
  const rest = count - Math.min(names.length, 60);
  return h("p", { class: "elements" }, ...linked(names.slice(0, 60).join(" "), where), rest > 0 && ` and ${shown(rest)} more`);
}

function listing(title: string, names: string[], count: number, where: Where): (HTMLElement | false)[] {
  return count > 0 ? [h("h2", {}, `${title}: ${shown(count)}`), elements(names, count, where)] : [];
}

function messages(title: string, texts: string[]): (HTMLElement | false)[] {
  return texts.length > 0 ? [h("h2", {}, title), h("ul", {}, ...texts.map(text => h("li", {}, ...prose(text))))] : [];
}

function geometry(page: PageData, changes: Json): (HTMLElement | false)[] {
  const rows = Object.entries(changes ?? {}).filter(([, change]) => change === null || Object.values(change as Json).some(x => x !== 0));
  if (rows.length === 0) return [];
  return [h("h2", {}, "Where the faces lie"), h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "where the faces lie" }, h("table", {},
    h("thead", {}, h("tr", {}, ...["Kind", "before", "mended", "new", "left"].map((name, i) => h("th", { scope: "col", class: i ? "number" : "" }, name)))),
    h("tbody", {}, ...rows.map(([kind, change]) => h("tr", {}, h("th", { scope: "row" }, named(page, kind)),
      ...["before", "mended", "new", "left"].map(key => h("td", { class: "number" }, change === null ? "–" : shown((change as Json)[key]))))))))];
}

/** What became of a file of a batch. */
export function rowPanel(root: HTMLElement, entry: Entry): void {
  const row = entry.report.row;
  const facts: [string, string | null][] = [
    ["Status", row.status], ["Message", row.message], ["Output", row.output], ["Format", [row.format_in, row.format_out].filter(Boolean).join(" → ") || null],
    ["Size", row.size === null ? null : `${shown(row.size)} bytes`], ["Took", `${shown(Number(row.seconds.toPrecision(3)))} s`],
    ["Tried", row.attempts > 1 ? `${row.attempts} times` : null], ["Faces removed", shown(row.removed_faces)], ["Faces turned", shown(row.flipped_faces)],
    ["Vertices created", shown(row.created_vertices)], ["Vertices joined", shown(row.welded_vertices)],
    ["Not carried", row.losses.length > 0 ? row.losses.map((loss: Json) => `${loss.kind}: ${shown(loss.count)}`).join(", ") : null],
  ];
  replace(root, h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "what became of the file" }, h("table", {}, h("tbody", {},
    ...facts.filter(([, value]) => value !== null && value !== "").map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)))))));
}

/** The figures with a sentence each. */
export function topologyPanel(root: HTMLElement, entry: Entry, asked: PanelAsked): void {
  const [before, after] = [figures(entry, "before"), figures(entry, "after")];
  const value = (text: string | null, layer: string | undefined): Node | string => {
    if (text === null) return "–";
    if (layer === undefined) return text;
    return h("button", { type: "button", class: "value", title: "show it", click: () => asked.showLayer(layer) }, text);
  };
  const row = (figure: (typeof FIGURES)[number]) => {
    const [was, is] = [figure.of(before), figure.of(after)];
    if (was === null && is === null) return null;
    return [
      h("tr", {}, h("th", { scope: "row" }, figure.title), h("td", {}, value(was, figure.layer)),
        after !== null && h("td", { class: was === is ? "" : "changed" }, value(is, figure.layer))),
      h("tr", { class: "sentence" }, h("td", { colspan: after === null ? 2 : 3, class: "explanation" }, figure.sentence)),
    ];
  };
  const report = before ?? after;
  const instigators = report?.instigators;
  const undefinedFigures: Json[] = report?.undefined ?? [];
  const kernels: Json[] = report?.kernels ?? [];
  const number = (key: string) => typeof instigators?.[key] === "number" ? shown(instigators[key]) : "–";
  replace(root,
    h("div", { class: "wide", tabindex: 0, role: "region", "aria-label": "figures" }, h("table", { class: "figures" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "Figure"), h("th", { scope: "col" }, after === null ? "Value" : "Before"),
        after !== null && h("th", { scope: "col" }, "After"))),
      h("tbody", {}, ...FIGURES.flatMap(figure => row(figure) ?? [])))),
    undefinedFigures.length > 0 && h("p", { class: "explanation" },
      `Not defined here: ${undefinedFigures.map(one => `${String(one.figure).replaceAll("_", " ")} (${String(one.reason).replaceAll("-", " ")})`).join(", ")}.`),
    instigators && h("h2", {}, "Instigators"),
    instigators && h("p", { class: "explanation" }, "Elements added one after another: each creates a topological feature, or negates one. Their differences are the Betti numbers."),
    instigators && h("table", { class: "instigators" },
      h("thead", {}, h("tr", {}, h("td", {}), h("th", { scope: "col", class: "number" }, "create"), h("th", { scope: "col", class: "number" }, "negate"))),
      h("tbody", {}, ...INSTIGATORS.map(([title, c, n]) => h("tr", {}, h("th", { scope: "row" }, title),
        h("td", { class: "number" }, number(c)), h("td", { class: "number" }, number(n)))))),
    kernels.length > 0 && h("h2", {}, "Which structures hold it"),
    kernels.length > 0 && h("ul", { class: "kernels" }, ...kernels.map(kernel => h("li", {}, h("b", {}, kernel.name), kernel.holds ? ": yes" :
      `: no, ${Object.entries(kernel.refusals).map(([kind, count]) => `${kind} ${shown(count as number)}`).join(", ")}`))),
  );
}

/** Counts before and after, side by side. */
export function countsTable(entry: Entry): HTMLElement | null {
  const [before, after] = [figures(entry, "before"), figures(entry, "after")];
  if (before === null && after === null) return null;
  const keys: [string, string][] = [["vertices", "vertices"], ["edges", "edges"], ["faces", "faces"], ["components", "components"]];
  const cell = (report: Json, key: string) => h("td", { class: "number" }, typeof report?.[key] === "number" ? shown(report[key]) : "–");
  return h("table", { class: "counts" },
    h("thead", {}, h("tr", {}, h("td", {}), ...keys.map(([, name]) => h("th", { scope: "col", class: "number" }, name)), h("th", { scope: "col" }, "which"))),
    h("tbody", {},
      h("tr", {}, h("th", { scope: "row" }, after === null ? "stored" : "before"), ...keys.map(([key]) => cell(before, key)), h("td", {}, FIGURES[0].of(before) ?? "–")),
      after !== null && h("tr", {}, h("th", { scope: "row" }, "after"), ...keys.map(([key]) => cell(after, key)), h("td", {}, FIGURES[0].of(after) ?? "–"))));
}
