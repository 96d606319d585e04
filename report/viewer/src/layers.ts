// The layers of a state: what each shows, how it looks, and whether it is on.

import { Entry, Item, StateData, StateName, figures, groups, numbers } from "./data.js";
import { Shown } from "./drawing.js";
import { Mesh, NOWHERE } from "./mesh.js";
import { Look, looks } from "./palette.js";
import { boundaryLoops, componentItems } from "./pieces.js";

export interface Layer {
  name: string;
  title: string;
  /** How many things it shows, and of how many. */
  count: number;
  of: number;
  look: Look;
  isOn: boolean;
  /** Where it stands among the others. */
  section: "defect" | "note" | "other";
  /** What of it can be gone to. */
  items: Item[];
  hint: string;
  shown(): Shown;
  options: { fill?: number; order?: number };
}

const nothing = (): Shown => ({ vertices: [], ends: [], faces: [] });

/** The layers of a state. Defects are on; notes are on where they are few; what shows how a mesh hangs together is off. */
export function layers(entry: Entry, state: StateName, data: StateData, mesh: Mesh, kinds: Record<string, { title: string; explanation: string }>, all: string[]): Layer[] {
  const found: Layer[] = [];
  const look = looks(all);
  for (const group of groups(entry, state)) {
    const mark = data.marks[group.kind];
    found.push({
      name: group.kind, title: kinds[group.kind]?.title ?? group.kind, count: mark?.drawn ?? 0, of: group.count,
      look: look.get(group.kind)!, isOn: group.severity === "defect" || group.kind === "boundary-edge", section: group.severity, items: group.items,
      hint: kinds[group.kind]?.explanation ?? "", options: { order: group.severity === "defect" ? 3 : 2, ...(mark?.strips === undefined ? {} : { fill: 0.5 }) },
      shown: () => {
        if (mark === undefined) return nothing();
        const shown: Shown = {
          vertices: vertexPlaces(mesh, numbers(mark.vertices)), ends: pairs(mesh, numbers(mark.edges)),
          faces: facePlaces(mesh, numbers(mark.faces)),
        };
        for (const strip of mark.strips ?? []) {
          shown.faces.push(...facePlaces(mesh, strip.faces));
          shown.ends.push(...pairs(mesh, strip.edges.flat()));
        }
        if (shown.faces.length > 0 && shown.ends.length === 0) shown.ends = outlineOf(mesh, shown.faces);
        return shown;
      },
    });
  }
  return found.concat(further(entry, state, data, mesh, look, kinds));
}

/** The defects of an entry whose mesh is not in the page: they are counted, and nothing is drawn. */
export function countedOnly(entry: Entry, kinds: Record<string, { title: string; explanation: string }>): Layer[] {
  const look = looks(layerNames(entry));
  return groups(entry, "before").map(group => ({
    name: group.kind, title: kinds[group.kind]?.title ?? group.kind, count: 0, of: group.count, look: look.get(group.kind)!, isOn: false,
    section: group.severity, items: [], hint: kinds[group.kind]?.explanation ?? "", shown: nothing, options: {},
  }));
}

function further(entry: Entry, state: StateName, data: StateData, mesh: Mesh, look: Map<string, Look>, kinds: Record<string, { title: string }>): Layer[] {
  const found: Layer[] = [];
  const add = (name: string, title: string, count: number, hint: string, of: string, shown: () => Shown, isOn = false, options: Layer["options"] = {}, items: Item[] = []) => {
    if (count > 0) found.push({ name, title, count, of: count, look: { ...look.get(of)! }, isOn, section: "other", items, hint, shown, options });
  };
  const { loops } = data;
  const report = figures(entry, state);
  const components = componentItems(report, mesh);
  if (loops.components !== undefined) {
    add("components", "components", report?.components ?? 0, "Pieces that share no vertex with each other; its box colours the faces by them.", "components", nothing, false, {}, components);
  }
  const boundary = data.marks["boundary-edge"];
  if (boundary !== undefined && boundary.drawn === boundary.count && typeof report?.boundary_loops === "number") {
    const found = boundaryLoops(mesh, numbers(boundary.edges));
    const ends = found.flatMap(loop => (loop.edge_ends ?? []).flat());
    add("boundary-loops", "boundary loops", found.length, "Closed paths of boundary edges: each is a hole, or the outer border of a sheet. The longest come first.", "boundary-edge",
      () => ({ vertices: [], faces: [], ends: pairs(mesh, ends) }), false, {}, found);
  }
  for (const [reason, faces] of state === "before" ? entry.changes?.removed ?? [] : []) {
    const ids = numbers(faces);
    add(`removed:${reason}`, `removed: ${kinds[reason]?.title ?? reason}`, ids.length, "Faces that the repair took away, for this reason.", "removed", () => {
      const places = facePlaces(mesh, ids);
      return { vertices: [], ends: outlineOf(mesh, places), faces: places };
    }, true, { fill: 0.28 });
  }
  if (state === "after" && entry.changes !== undefined) {
    const { flipped, created } = entry.changes;
    const face = (text: string) => (): Shown => ({ vertices: [], ends: [], faces: facePlaces(mesh, numbers(text)) });
    add("flipped", "turned faces", numbers(flipped).length, "Faces that run the other way round than they were stored.", "flipped", face(flipped));
    add("created", "created faces", numbers(created).length, "Faces that the repair made, to close holes.", "created", face(created), true);
  }
  const generators = loops.generators ?? [];
  add("generators", "generators", generators.length, "Closed paths round handles and holes that can't be shrunk to a point.", "generators", () => ({
    vertices: [], faces: [],
    ends: generators.flatMap(path => path.flatMap((v, i) => pairs(mesh, [v, path[(i + 1) % path.length]]))),
  }), generators.length > 0 && generators.length <= 16);
  const edges = (text: string | undefined, name: string, title: string, hint: string) => {
    if (text === undefined) return;
    const ends = numbers(text);
    add(name, title, ends.length / 2, hint, name, () => ({ vertices: [], faces: [], ends: pairs(mesh, ends) }));
  };
  edges(loops.seam, "seam", "seam", "Where a surface with one side can be cut to have two.");
  edges(loops.tree, "tree", "tree", "Shortest paths from one vertex to all others; the generators come from it.");
  edges(loops.cotree, "cotree", "co-tree", "A tree of the faces, across the edges that it passes.");
  return found;
}

/** The names of all layers that may need a look of their own. */
export function layerNames(entry: Entry): string[] {
  const kinds = [...groups(entry, "before"), ...groups(entry, "after")].map(group => group.kind);
  return [...new Set(kinds), "removed", "components", "generators", "flipped", "created", "seam", "tree", "cotree"];
}

function facePlaces(mesh: Mesh, ids: ArrayLike<number>): number[] {
  return Array.from(ids, id => mesh.facePlace(id)).filter(place => place !== NOWHERE);
}

function vertexPlaces(mesh: Mesh, ids: ArrayLike<number>): number[] {
  return Array.from(ids, id => mesh.vertexPlace(id)).filter(place => place !== NOWHERE && mesh.isFinite(place));
}

function pairs(mesh: Mesh, ids: ArrayLike<number>): number[] {
  const ends: number[] = [];
  for (let i = 0; i + 1 < ids.length; i += 2) {
    const [a, b] = [mesh.vertexPlace(ids[i]), mesh.vertexPlace(ids[i + 1])];
    if (a !== NOWHERE && b !== NOWHERE && mesh.isFinite(a) && mesh.isFinite(b)) ends.push(a, b);
  }
  return ends;
}

function outlineOf(mesh: Mesh, faces: number[]): number[] {
  const ends: number[] = [];
  for (const place of faces) {
    const face = Array.from(mesh.face(place)).filter(v => mesh.isFinite(v));
    face.forEach((v, i) => ends.push(v, face[(i + 1) % face.length]));
  }
  return ends;
}
