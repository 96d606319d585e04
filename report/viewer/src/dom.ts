// Elements of the page. Texts are always text nodes: nothing is ever read as HTML.

type Child = Node | string | number | null | undefined | false;
type Value = string | number | boolean | null | undefined | ((event: never) => void);

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, Value> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value as unknown as EventListener);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  put(element, ...children);
  return element;
}

export function put(element: Element, ...children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    element.append(child instanceof Node ? child : String(child));
  }
}

export function replace(element: Element, ...children: Child[]): void {
  element.replaceChildren();
  put(element, ...children);
}

const SEPARATED = new Intl.NumberFormat("en", { useGrouping: true });

/** A number as people read it. */
export const shown = (value: number): string =>
  Number.isInteger(value) && Math.abs(value) < 10000 ? String(value) : SEPARATED.format(value).replaceAll(",", "\u202f");

export const counted = (count: number, one: string, many = one + "s"): string =>
  `${shown(count)} ${count === 1 ? one : many}`;
