// Texts in which the numbers of elements are links to their places.

import { StateName } from "./data.js";
import { h } from "./dom.js";
import { fragment } from "./selection.js";

export interface Where { entry: number; state: StateName; several: boolean }

/** A text with a link for each `v12`, `e7` or `f3` in it. */
export function linked(text: string, where: Where): Node[] {
  return text.split(/\b([vef]\d+)\b/).filter(piece => piece !== "").map(piece =>
    /^[vef]\d+$/.test(piece) ? link(piece, where) : document.createTextNode(piece));
}

export function link(element: string, where: Where): HTMLAnchorElement {
  return h("a", { href: fragment({ ...where, element }, where.several), class: "element" }, element);
}

/** A text in which what stands between back quotes is a word of the command line. */
export function prose(text: string): Node[] {
  return text.split("`").map((piece, i) => (i % 2 ? h("code", {}, piece) : document.createTextNode(piece)));
}
