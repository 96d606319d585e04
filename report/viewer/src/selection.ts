// What is selected: an element by its number in one of the states, as the address's fragment says it.

import { Shown } from "./drawing.js";
import { Mesh, NOWHERE, Point } from "./mesh.js";
import { Item, StateName } from "./data.js";

export interface Selected { entry: number; state: StateName; element: string }

/** `#f3`, `#after/e7`, `#2/v12`, `#2`: the entry counts from 1. */
export function fragment(selected: Selected, several: boolean): string {
  const entry = several ? `${selected.entry + 1}` : "";
  const state = selected.state === "after" ? "after" : "";
  return "#" + [entry, state, selected.element].filter(part => part !== "").join("/");
}

export function ofFragment(text: string, entries: number): Selected | null {
  const selected: Selected = { entry: 0, state: "before", element: "" };
  for (const part of text.replace(/^#/, "").split("/")) {
    if (/^\d+$/.test(part) && Number(part) >= 1 && Number(part) <= entries) selected.entry = Number(part) - 1;
    else if (part === "after" || part === "before") selected.state = part;
    else if (/^[vef]\d+$/.test(part)) selected.element = part;
    else if (part !== "") return null;
  }
  return selected;
}

/** What to show of an element, and what to say where it is not there. */
export interface Found { shown: Shown; point: Point; size: number; front: Point | null; says: string }

/** The element of a name such as `e7`. */
export function find(mesh: Mesh, name: string): Found | string {
  const id = Number(name.slice(1));
  switch (name[0]) {
    case "v": return vertex(mesh, id);
    case "e": return edge(mesh, id);
    default: return face(mesh, id);
  }
}

function vertex(mesh: Mesh, id: number): Found | string {
  if (id >= mesh.vertexCount) return `There is no v${id}: the mesh has ${mesh.vertexCount} vertices.`;
  const place = mesh.vertexPlace(id);
  if (place === NOWHERE) return `v${id} is not in this page: it shows only what is round the defects.`;
  if (!mesh.isFinite(place)) return `v${id} has a position that is not finite.`;
  const faces = mesh.facesAt(place);
  const [x, y, z] = mesh.point(place).map((x, axis) => rounded(x + mesh.origin[axis]));
  const at = `v${id} at (${x}, ${y}, ${z}), in ${faces.length === 1 ? "1 face" : `${faces.length} faces`}`;
  return found(mesh, { vertices: [place], ends: [], faces }, [place], at);
}

function edge(mesh: Mesh, id: number): Found | string {
  if (!mesh.isWhole) return `e${id} can't be looked up: the page has only a part of the mesh.`;
  const ends = mesh.edges();
  if (2 * id >= ends.length) return `There is no e${id}: the mesh has ${ends.length / 2} edges.`;
  const [a, b] = [ends[2 * id], ends[2 * id + 1]];
  const faces = mesh.facesAlong(a, b);
  return found(mesh, { vertices: [], ends: [a, b], faces }, [a, b],
    `e${id} from v${a} to v${b}, in ${faces.length === 1 ? "1 face" : `${faces.length} faces`}`);
}

function face(mesh: Mesh, id: number): Found | string {
  if (id >= mesh.faceCount) return `There is no f${id}: the mesh has ${mesh.faceCount} faces.`;
  const place = mesh.facePlace(id);
  if (place === NOWHERE) return `f${id} is not in this page: it shows only what is round the defects.`;
  const corners = Array.from(mesh.face(place));
  const names = corners.slice(0, 12).map(v => `v${mesh.vertexId(v)}`).join(" ") + (corners.length > 12 ? " …" : "");
  return found(mesh, { vertices: [], ends: [], faces: [place] }, corners, `f${id}: ${names}`);
}

/** The place of a defect that a report lists. */
export function findItem(mesh: Mesh, item: Item): Found {
  const places = item.vertices.map(v => mesh.vertexPlace(v)).filter(v => v !== NOWHERE && mesh.isFinite(v));
  const faceIds = [...(item.face === undefined ? [] : [item.face]), ...(item.faces ?? []),
    ...(item.beside?.face === undefined ? [] : [item.beside.face])];
  const faces = [...new Set(faceIds)].map(f => mesh.facePlace(f)).filter(f => f !== NOWHERE);
  const of = (ends: [number, number]) => ends.map(v => mesh.vertexPlace(v));
  const ends = [...(item.ends === undefined ? [] : of(item.ends)), ...(item.edge_ends ?? []).flatMap(of)]
    .filter(v => v !== NOWHERE);
  const isPoint = item.element === "vertex" || item.element === "loose-point" || item.element === "corner";
  const around = places.length > 0 ? places : faces.flatMap(f => Array.from(mesh.face(f)));
  return found(mesh, { vertices: isPoint ? places : [], ends, faces }, around, item.message);
}

function found(mesh: Mesh, shown: Shown, around: number[], says: string): Found {
  const finite = around.filter(v => mesh.isFinite(v));
  const point: Point = [0, 0, 0];
  for (const v of finite) mesh.point(v).forEach((x, axis) => { point[axis] += x / finite.length; });
  const wide = [...finite, ...shown.faces.slice(0, 40).flatMap(f => Array.from(mesh.face(f)))];
  const size = wide.reduce((most, v) => {
    const [x, y, z] = mesh.point(v);
    const far = Math.hypot(x - point[0], y - point[1], z - point[2]);
    return Number.isFinite(far) ? Math.max(most, far) : most;
  }, 0);
  return { shown, point, size, front: front(mesh, shown.faces), says };
}

/** The sum of the normals of some faces. */
function front(mesh: Mesh, faces: number[]): Point | null {
  const sum: Point = [0, 0, 0];
  for (const place of faces.slice(0, 200)) {
    const points = Array.from(mesh.face(place), v => mesh.point(v));
    points.forEach((a, i) => {
      const b = points[(i + 1) % points.length];
      sum[0] += (a[1] - b[1]) * (a[2] + b[2]);
      sum[1] += (a[2] - b[2]) * (a[0] + b[0]);
      sum[2] += (a[0] - b[0]) * (a[1] + b[1]);
    });
  }
  return sum.every(Number.isFinite) ? sum : null;
}

const rounded = (x: number): string => String(Number(x.toPrecision(7)));
