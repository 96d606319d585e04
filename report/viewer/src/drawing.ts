// What is drawn over the faces: points with symbols, wide lines with dashes, and tinted faces. Each is drawn twice: plainly
// where it is seen, and faintly where faces are before it.

import {
  BufferAttribute, BufferGeometry, CanvasTexture, DoubleSide, GreaterDepth, Group, LessEqualDepth, Mesh as Drawn,
  MeshBasicMaterial, Plane, Points, PointsMaterial,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { Mesh } from "./mesh.js";
import { Look, symbolPicture } from "./palette.js";

/** What a layer shows, as places of vertices and faces of its mesh. */
export interface Shown { vertices: number[]; ends: number[]; faces: number[] }

export interface OverlayOptions { plane: Plane | null; unit: number; fill?: number; faint?: number; order?: number; pointSize?: number }

export function overlay(mesh: Mesh, shown: Shown, look: Look, options: OverlayOptions): Group {
  const group = new Group();
  const order = options.order ?? 1;
  const add = (make: (behind: boolean) => Points | LineSegments2 | Drawn) => {
    for (const behind of [true, false]) {
      const object = make(behind);
      object.frustumCulled = false;
      object.renderOrder = 10 * order + (behind ? 0 : 1);
      group.add(object);
    }
  };
  const planes = options.plane === null ? [] : [options.plane];
  const common = (behind: boolean, opacity: number) => ({
    transparent: true, depthWrite: false, depthFunc: behind ? GreaterDepth : LessEqualDepth,
    opacity: behind ? opacity * (options.faint ?? 0.25) : opacity, clippingPlanes: planes,
  } as const);
  if (shown.faces.length > 0) {
    const geometry = faceGeometry(mesh, shown.faces);
    add(behind => new Drawn(geometry, new MeshBasicMaterial({
      color: look.colour, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1,
      ...common(behind, options.fill ?? 0.34),
    })));
  }
  if (shown.ends.length > 0) {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(points(mesh, shown.ends));
    add(behind => {
      const dash = look.dash;
      const material = new LineMaterial({
        color: look.colour, linewidth: behind ? look.width * 0.6 : look.width, dashed: dash !== null,
        dashSize: (dash?.[0] ?? 1) * options.unit, gapSize: (dash?.[1] ?? 1) * options.unit, ...common(behind, 1),
      });
      const lines = new LineSegments2(geometry, material);
      if (dash !== null && !behind) lines.computeLineDistances();
      return lines;
    });
  }
  if (shown.vertices.length > 0) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(points(mesh, shown.vertices), 3));
    const map = new CanvasTexture(symbolPicture(look, 64));
    add(behind => new Points(geometry, new PointsMaterial({
      map, size: options.pointSize ?? (shown.vertices.length < 100 ? 15 : 10), sizeAttenuation: false, alphaTest: 0.05, ...common(behind, 1),
    })));
  }
  return group;
}

function points(mesh: Mesh, places: number[]): Float32Array {
  const found = new Float32Array(3 * places.length);
  places.forEach((place, i) => found.set(mesh.positions.subarray(3 * place, 3 * place + 3), 3 * i));
  return found;
}

function faceGeometry(mesh: Mesh, faces: number[]): BufferGeometry {
  const wanted = new Set(faces);
  const cut = mesh.triangles();
  const index: number[] = [];
  if (mesh.shownFaces === cut.faces.length && mesh.corners.length === 3 * mesh.shownFaces) {
    for (const f of wanted) index.push(cut.vertices[3 * f], cut.vertices[3 * f + 1], cut.vertices[3 * f + 2]);
  } else {
    cut.faces.forEach((f, t) => {
      if (wanted.has(f)) index.push(cut.vertices[3 * t], cut.vertices[3 * t + 1], cut.vertices[3 * t + 2]);
    });
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points(mesh, index), 3));
  return geometry;
}

export function dispose(group: Group): void {
  group.traverse(object => {
    const { geometry, material } = object as unknown as { geometry?: BufferGeometry; material?: PointsMaterial };
    geometry?.dispose();
    material?.map?.dispose();
    material?.dispose();
  });
}
