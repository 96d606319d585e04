// The faces of a mesh: lit from the eye, with backs that are bluish and hatched, flat or smooth, and their edges.

import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh as Drawn, Plane, Points,
  PointsMaterial, ShaderMaterial,
} from "three";
import { Mesh, sides } from "./mesh.js";
import { COMPONENTS } from "./palette.js";
import { numbers } from "./data.js";

const VERTEX = `
#include <clipping_planes_pars_vertex>
attribute vec3 tint;
uniform bool tinted;
varying vec3 vEye;
varying vec3 vNormalAt;
varying vec3 vTint;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vEye = mvPosition.xyz;
  vNormalAt = normalMatrix * normal;
  vTint = tinted ? tint : vec3(0.874, 0.855, 0.816);
  #include <clipping_planes_vertex>
  gl_Position = projectionMatrix * mvPosition;
}`;

const FRAGMENT = `
#include <clipping_planes_pars_fragment>
uniform bool smoothly;
uniform bool hatched;
uniform float opacity;
varying vec3 vEye;
varying vec3 vNormalAt;
varying vec3 vTint;
void main() {
  #include <clipping_planes_fragment>
  vec3 flatly = cross(dFdx(vEye), dFdy(vEye));
  vec3 n = smoothly ? vNormalAt : flatly;
  float size = length(n);
  n = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
  if (n.z < 0.0) n = -n;
  float light = 0.42 + 0.50 * max(dot(n, normalize(vec3(-0.35, 0.55, 0.80))), 0.0) + 0.12 * n.z;
  vec3 colour = vTint;
  if (!gl_FrontFacing && hatched) {
    colour = mix(colour, vec3(0.56, 0.68, 0.84), 0.80);
    float stripe = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0);
    if (stripe < 1.5) colour *= 0.72;
  }
  gl_FragColor = vec4(colour * light, opacity);
}`;

export interface SurfaceLook { smooth: boolean; edges: boolean; opacity: number; backs: boolean; components: boolean }

export class Surface {
  readonly group = new Group();
  private readonly geometry = new BufferGeometry();
  private readonly material: ShaderMaterial;
  private lines: LineSegments | null = null;
  private hasNormals = false;
  private tint: Uint8Array | null;

  constructor(readonly mesh: Mesh, components: string | undefined, private readonly plane: Plane | null) {
    const cut = mesh.triangles();
    this.geometry.setAttribute("position", new BufferAttribute(finite(mesh.positions), 3));
    this.geometry.setIndex(new BufferAttribute(cut.vertices, 1));
    this.tint = components === undefined ? null : tints(mesh, numbers(components));
    if (this.tint !== null) this.geometry.setAttribute("tint", new BufferAttribute(this.tint, 3, true));
    this.material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide, clipping: true,
      clippingPlanes: plane === null ? [] : [plane],
      uniforms: {
        smoothly: { value: false }, hatched: { value: true }, opacity: { value: 1 }, tinted: { value: false },
      },
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2,
    });
    const faces = new Drawn(this.geometry, this.material);
    faces.frustumCulled = false;
    this.group.add(faces);
    this.addLoose();
  }

  look(look: SurfaceLook): void {
    if (look.smooth && !this.hasNormals) {
      this.geometry.setAttribute("normal", new BufferAttribute(normals(this.mesh), 3));
      this.hasNormals = true;
    }
    const { uniforms } = this.material;
    uniforms["smoothly"].value = look.smooth;
    uniforms["hatched"].value = look.backs;
    uniforms["opacity"].value = look.opacity;
    uniforms["tinted"].value = look.components && this.tint !== null;
    const isOpaque = look.opacity >= 1;
    if (this.material.transparent === isOpaque) {
      this.material.transparent = !isOpaque;
      this.material.depthWrite = isOpaque;
      this.material.needsUpdate = true;
    }
    if (look.edges && this.lines === null) this.addLines();
    if (this.lines !== null) this.lines.visible = look.edges;
  }

  dispose(): void {
    this.group.traverse(object => {
      const { geometry, material } = object as Partial<LineSegments>;
      geometry?.dispose();
      if (material !== undefined && !Array.isArray(material)) material.dispose();
    });
  }

  private addLines(): void {
    const { mesh } = this;
    const ends = mesh.isWhole || mesh.shownFaces < 500000 ? mesh.edges() : new Uint32Array();
    this.lines = new LineSegments(this.sharing(ends), this.ink(0x4c4a46, mesh.shownFaces < 3000 ? 0.6 : mesh.shownFaces < 20000 ? 0.3 : 0.18));
    this.group.add(this.lines);
  }

  private addLoose(): void {
    const { mesh } = this;
    if (mesh.looseEdges.length > 0) {
      this.group.add(new LineSegments(this.sharing(mesh.looseEdges), this.ink(0x464646, 1)));
    }
    if (mesh.corners.length === 0 && mesh.looseEdges.length === 0) {
      this.group.add(new Points(this.geometry.clone().setIndex(null), new PointsMaterial({ size: 3, sizeAttenuation: false, color: 0x464646 })));
    }
  }

  private sharing(index: Uint32Array): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.geometry.getAttribute("position"));
    geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
  }

  private ink(colour: number, opacity: number): LineBasicMaterial {
    return new LineBasicMaterial({
      color: new Color(colour), opacity, transparent: opacity < 1, clippingPlanes: this.plane === null ? [] : [this.plane],
    });
  }
}

/** Positions in which what is not finite is at the origin: no face that is drawn uses it. */
function finite(positions: Float32Array): Float32Array {
  return positions.every(Number.isFinite) ? positions : positions.map(x => (Number.isFinite(x) ? x : 0));
}

function normals(mesh: Mesh): Float32Array {
  const { vertices } = mesh.triangles();
  const p = mesh.positions;
  const sums = new Float32Array(p.length);
  for (let i = 0; i < vertices.length; i += 3) {
    const [a, b, c] = [3 * vertices[i], 3 * vertices[i + 1], 3 * vertices[i + 2]];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const at of [a, b, c]) { sums[at] += nx; sums[at + 1] += ny; sums[at + 2] += nz; }
  }
  for (let i = 0; i < sums.length; i += 3) {
    const size = Math.hypot(sums[i], sums[i + 1], sums[i + 2]) || 1;
    sums[i] /= size; sums[i + 1] /= size; sums[i + 2] /= size;
  }
  return sums;
}

function tints(mesh: Mesh, components: Uint32Array): Uint8Array {
  const tint = new Uint8Array(mesh.positions.length);
  for (let v = 0; v < tint.length / 3; v++) {
    const component = components[mesh.vertexId(v)];
    tint.set(COMPONENTS[(component ?? 0) % COMPONENTS.length], 3 * v);
  }
  return tint;
}

/** The segments of the sides of some faces, as places of vertices. */
export function outlines(mesh: Mesh, faces: Iterable<number>): number[] {
  const ends: number[] = [];
  for (const place of faces) {
    const kept = sides(mesh.face(place));
    kept.forEach((v, i) => ends.push(v, kept[(i + 1) % kept.length]));
  }
  return ends;
}
