// A mesh with the ids that reports name: what is asked of it to draw it, to pick in it and to find elements.

import { MeshData, floats, numbers } from "./data.js";

export type Point = [number, number, number];

export interface Element { kind: "v" | "e" | "f"; id: number }

export const NOWHERE = 0xffffffff;

export class Mesh {
  readonly positions: Float32Array;
  readonly corners: Uint32Array;
  readonly vertexCount: number;
  readonly faceCount: number;
  readonly origin: Point;
  private readonly offsets: Uint32Array | null;
  private readonly vertexIds: Uint32Array | null;
  private readonly faceIds: Uint32Array | null;
  readonly looseEdges: Uint32Array;
  private cut: { vertices: Uint32Array; faces: Uint32Array } | null = null;
  private ends: Uint32Array | null = null;
  private box: { middle: Point; radius: number; low: Point; high: Point } | null = null;

  constructor(data: MeshData) {
    this.origin = data.origin;
    this.vertexCount = data.vertices;
    this.faceCount = data.faces;
    this.positions = floats(data.positions);
    this.corners = numbers(data.corners);
    this.offsets = data.offsets === undefined ? null : numbers(data.offsets);
    this.vertexIds = data.vertex_ids === undefined ? null : numbers(data.vertex_ids);
    this.faceIds = data.face_ids === undefined ? null : numbers(data.face_ids);
    this.looseEdges = data.loose_edges === undefined ? new Uint32Array() : numbers(data.loose_edges);
  }

  /** Whether all faces are here. */
  get isWhole(): boolean { return this.faceIds === null; }

  /** How many faces are here. */
  get shownFaces(): number { return this.offsets === null ? this.corners.length / 3 : this.offsets.length - 1; }

  faceId(place: number): number { return this.faceIds === null ? place : this.faceIds[place]; }
  vertexId(place: number): number { return this.vertexIds === null ? place : this.vertexIds[place]; }
  facePlace(id: number): number { return placeOf(this.faceIds, id, this.faceCount); }
  vertexPlace(id: number): number { return placeOf(this.vertexIds, id, this.vertexCount); }

  /** The corners of a face by its place, as places of vertices. */
  face(place: number): Uint32Array {
    return this.offsets === null
      ? this.corners.subarray(3 * place, 3 * place + 3)
      : this.corners.subarray(this.offsets[place], this.offsets[place + 1]);
  }

  point(place: number): Point {
    return [this.positions[3 * place], this.positions[3 * place + 1], this.positions[3 * place + 2]];
  }

  isFinite(place: number): boolean {
    return Number.isFinite(this.positions[3 * place] + this.positions[3 * place + 1] + this.positions[3 * place + 2]);
  }

  /** The faces cut into triangles to be drawn: places of vertices, and of each triangle the place of its face. */
  triangles(): { vertices: Uint32Array; faces: Uint32Array } {
    this.cut ??= triangulated(this);
    return this.cut;
  }

  /** The ends of all edges in the order of their numbers, by ids; only where the mesh is whole. */
  edges(): Uint32Array {
    this.ends ??= edgesOf(this);
    return this.ends;
  }

  /** The faces at a vertex, by places. One walk over all corners. */
  facesAt(vertex: number): number[] {
    const found: number[] = [];
    if (this.offsets === null) {
      for (let i = 0; i < this.corners.length; i++) {
        if (this.corners[i] === vertex) { const f = (i / 3) | 0; if (found[found.length - 1] !== f) found.push(f); }
      }
      return found;
    }
    for (let f = 0; f + 1 < this.offsets.length; f++) {
      for (let i = this.offsets[f]; i < this.offsets[f + 1]; i++) {
        if (this.corners[i] === vertex) { found.push(f); break; }
      }
    }
    return found;
  }

  /** The faces with a side between two vertices, by places. */
  facesAlong(a: number, b: number): number[] {
    return this.facesAt(a).filter(place => {
      const face = this.face(place);
      return face.some((v, i) => {
        const w = face[(i + 1) % face.length];
        return (v === a && w === b) || (v === b && w === a);
      });
    });
  }

  /** Some of the vertices that are seen, spread over all of them. */
  sample(): Point[] {
    const { vertices } = this.triangles();
    const step = Math.max(1, Math.floor(vertices.length / 6000));
    const points: Point[] = [];
    for (let i = 0; i < vertices.length; i += step) points.push(this.point(vertices[i]));
    return points;
  }

  bounds(): { middle: Point; radius: number; low: Point; high: Point } {
    if (this.box === null) {
      const low: Point = [Infinity, Infinity, Infinity];
      const high: Point = [-Infinity, -Infinity, -Infinity];
      // Vertices that no face uses may lie anywhere; they count only where there is nothing else to see.
      const used: ArrayLike<number> = this.triangles().vertices.length > 0 ? this.triangles().vertices
        : this.looseEdges.length > 0 ? this.looseEdges : Array.from({ length: this.positions.length / 3 }, (_, v) => v);
      for (let i = 0; i < used.length; i++) {
        const v = used[i];
        if (!this.isFinite(v)) continue;
        for (let axis = 0; axis < 3; axis++) {
          const x = this.positions[3 * v + axis];
          if (x < low[axis]) low[axis] = x;
          if (x > high[axis]) high[axis] = x;
        }
      }
      if (low[0] > high[0]) { low.fill(-1); high.fill(1); }
      const middle: Point = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2];
      const radius = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 || 1;
      this.box = { middle, radius, low, high };
    }
    return this.box;
  }
}

function placeOf(ids: Uint32Array | null, id: number, count: number): number {
  if (ids === null) return id < count ? id : NOWHERE;
  let [low, high] = [0, ids.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ids[middle] < id) low = middle + 1; else high = middle;
  }
  return ids[low] === id ? low : NOWHERE;
}

function triangulated(mesh: Mesh): { vertices: Uint32Array; faces: Uint32Array } {
  const vertices: number[] | Uint32Array = new Uint32Array(3 * Math.max(0, mesh.corners.length - 2 * mesh.shownFaces) + 3);
  const faces = new Uint32Array(vertices.length / 3);
  let [count, total] = [0, 0];
  const grown = { vertices: vertices as Uint32Array, faces };
  for (let f = 0; f < mesh.shownFaces; f++) {
    const face = mesh.face(f);
    if (face.length < 3 || !areFinite(mesh, face)) continue;
    const cut = face.length === 3 ? face : face.length === 4 ? quadCut(mesh, face) : polygonCut(mesh, face);
    for (let i = 0; i + 2 < cut.length; i += 3) {
      if (count >= grown.faces.length) {
        const [v, t] = [new Uint32Array(6 * count + 6), new Uint32Array(2 * count + 2)];
        v.set(grown.vertices); t.set(grown.faces); grown.vertices = v; grown.faces = t;
      }
      grown.vertices[total++] = cut[i]; grown.vertices[total++] = cut[i + 1]; grown.vertices[total++] = cut[i + 2];
      grown.faces[count++] = f;
    }
  }
  return { vertices: grown.vertices.subarray(0, total), faces: grown.faces.subarray(0, count) };
}

function areFinite(mesh: Mesh, face: Uint32Array): boolean {
  for (let i = 0; i < face.length; i++) if (!mesh.isFinite(face[i])) return false;
  return true;
}

/** Two triangles of a quad, along the diagonal on whose sides both look the same way. */
function quadCut(mesh: Mesh, [a, b, c, d]: Uint32Array): number[] {
  const p = mesh.positions;
  const [x, y, z] = [3 * a, 3 * a + 1, 3 * a + 2];
  const [bx, by, bz] = [p[3 * b] - p[x], p[3 * b + 1] - p[y], p[3 * b + 2] - p[z]];
  const [cx, cy, cz] = [p[3 * c] - p[x], p[3 * c + 1] - p[y], p[3 * c + 2] - p[z]];
  const [dx, dy, dz] = [p[3 * d] - p[x], p[3 * d + 1] - p[y], p[3 * d + 2] - p[z]];
  const agree = (by * cz - bz * cy) * (cy * dz - cz * dy) + (bz * cx - bx * cz) * (cz * dx - cx * dz) +
    (bx * cy - by * cx) * (cx * dy - cy * dx);
  return agree >= 0 ? [a, b, c, a, c, d] : [a, b, d, b, c, d];
}

/** Triangles of a polygon: ears in the plane of its area vector, a fan where there are none. */
function polygonCut(mesh: Mesh, face: Uint32Array): Uint32Array | number[] {
  const n = face.length;
  const points = Array.from(face, v => mesh.point(v));
  const area: Point = [0, 0, 0];
  for (let i = 0; i < n; i++) {
    const [a, b] = [points[i], points[(i + 1) % n]];
    area[0] += (a[1] - b[1]) * (a[2] + b[2]);
    area[1] += (a[2] - b[2]) * (a[0] + b[0]);
    area[2] += (a[0] - b[0]) * (a[1] + b[1]);
  }
  const drop = [0, 1, 2].reduce((best, axis) => Math.abs(area[axis]) > Math.abs(area[best]) ? axis : best, 0);
  const [x, y] = [(drop + 1) % 3, (drop + 2) % 3];
  const sign = area[drop] < 0 ? -1 : 1;
  const cross = (a: Point, b: Point, c: Point) =>
    sign * ((b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]));
  const left = Array.from({ length: n }, (_, i) => i);
  const cut: number[] = [];
  while (left.length > 3 && n <= 2000) {
    const ear = left.findIndex((_, i) => {
      const [a, b, c] = [left[(i + left.length - 1) % left.length], left[i], left[(i + 1) % left.length]];
      if (cross(points[a], points[b], points[c]) <= 0) return false;
      return left.every(p => p === a || p === b || p === c ||
        cross(points[a], points[b], points[p]) < 0 || cross(points[b], points[c], points[p]) < 0 ||
        cross(points[c], points[a], points[p]) < 0);
    });
    if (ear < 0) break;
    const m = left.length;
    cut.push(face[left[(ear + m - 1) % m]], face[left[ear]], face[left[(ear + 1) % m]]);
    left.splice(ear, 1);
  }
  for (let i = 1; i + 1 < left.length; i++) cut.push(face[left[0]], face[left[i]], face[left[i + 1]]);
  return cut;
}

/** The sides of a face in normal form: repeats of a vertex one after another count once, and a face of fewer than three
 * different vertices has none. */
export function sides(face: Uint32Array): number[] {
  const kept: number[] = [];
  for (const v of face) if (kept[kept.length - 1] !== v) kept.push(v);
  while (kept.length > 1 && kept[0] === kept[kept.length - 1]) kept.pop();
  return new Set(kept).size < 3 ? [] : kept;
}

function edgesOf(mesh: Mesh): Uint32Array {
  const keys = new Float64Array(mesh.corners.length);
  let count = 0;
  const size = mesh.positions.length / 3;
  for (let f = 0; f < mesh.shownFaces; f++) {
    const face = mesh.face(f);
    const [a, b, c] = face;
    const isPlain = face.length === 3 && a !== b && b !== c && c !== a;
    const kept = isPlain ? face : sides(face);
    for (let i = 0; i < kept.length; i++) {
      const [v, w] = [kept[i], kept[i + 1 === kept.length ? 0 : i + 1]];
      keys[count++] = v < w ? v * size + w : w * size + v;
    }
  }
  const sorted = keys.subarray(0, count).sort();
  const ends = new Uint32Array(2 * count);
  let [total, last] = [0, -1];
  for (const key of sorted) {
    if (key === last) continue;
    last = key;
    ends[total++] = Math.floor(key / size);
    ends[total++] = key % size;
  }
  return ends.slice(0, total);
}
