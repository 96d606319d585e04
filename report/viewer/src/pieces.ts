// What a mesh is made of, as items that can be gone to: its boundary loops and its components.

import { Item, Json } from "./data.js";
import { counted, shown } from "./dom.js";
import { Mesh, NOWHERE } from "./mesh.js";

/** The closed paths that boundary edges make, given by the ids of their ends; the longest first. Asked where the mesh is manifold:
 * two boundary edges meet at each vertex then. */
export function boundaryLoops(mesh: Mesh, ends: Uint32Array): Item[] {
  const at = new Map<number, number[]>();
  for (let i = 0; i < ends.length; i++) {
    const known = at.get(ends[i]);
    if (known === undefined) at.set(ends[i], [i >> 1]); else known.push(i >> 1);
  }
  const isDone = new Uint8Array(ends.length / 2);
  const loops: number[][] = [];
  for (let first = 0; first < isDone.length; first++) {
    if (isDone[first]) continue;
    const path = [ends[2 * first]];
    let edge: number | undefined = first;
    while (edge !== undefined) {
      isDone[edge] = 1;
      const last: number = path[path.length - 1];
      const next: number = ends[2 * edge] === last ? ends[2 * edge + 1] : ends[2 * edge];
      path.push(next);
      edge = at.get(next)?.find(other => !isDone[other]);
    }
    if (path.length > 1 && path[0] === path[path.length - 1]) path.pop();
    loops.push(path);
  }
  loops.sort((a, b) => b.length - a.length || a[0] - b[0]);
  return loops.map(path => ({
    element: "loop", message: `${counted(path.length, "edge")} from v${path[0]}`, vertices: path, positions: path.slice(0, 1).map(v => place(mesh, v)),
    edge_ends: path.map((v, i): [number, number] => [v, path[(i + 1) % path.length]]),
  }));
}

/** The kinds of component that a report lists, each by its lowest vertex. */
export function componentItems(report: Json, mesh: Mesh): Item[] {
  return (report?.component_kinds ?? []).map((kind: Json): Item => {
    const many = kind.count > 1 ? `${shown(kind.count)} \u00d7 ` : "";
    const size = `${shown(kind.vertices)} vertices, ${shown(kind.edges)} edges, ${shown(kind.faces)} faces`;
    return {
      element: "vertex", message: `${many}${kind.name ?? "not a surface"}: ${size}, from v${kind.first_vertex}`,
      vertices: [kind.first_vertex], positions: [place(mesh, kind.first_vertex)], vertex: kind.first_vertex,
    };
  });
}

function place(mesh: Mesh, id: number): (number | null)[] {
  const at = mesh.vertexPlace(id);
  if (at === NOWHERE) return [];
  return mesh.point(at).map((x, axis) => (Number.isFinite(x) ? x + mesh.origin[axis] : null));
}
