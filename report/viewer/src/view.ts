// The view in 3D: one canvas that shows the mesh before, after, or both with a border that can be moved.

import { Color, Group, Plane, Scene, Vector3, WebGLRenderer } from "three";
import { Camera, Direction, towards } from "./camera.js";
import { Mesh, NOWHERE, Point } from "./mesh.js";
import { Surface, outlines } from "./surface.js";
import { Shown, dispose, overlay } from "./drawing.js";
import { StateName } from "./data.js";
import { Look } from "./palette.js";

/** From so many faces on, a walk over all of them is felt. */
const LONG_WALK = 200_000;

export type Mode = StateName | "both";

/** A state that can be seen. */
export interface Seen { mesh: Mesh; shape: Mesh | null; components: string | undefined }

interface Stage { scene: Scene; seen: Seen; surfaces: Surface[]; layers: Map<string, Group>; marked: Group | null }

export interface ViewLook {
  smooth: boolean; edges: boolean; transparent: boolean; backs: boolean; components: boolean;
  clip: { axis: 0 | 1 | 2; share: number; flipped: boolean } | null;
}

export class View {
  readonly look: ViewLook = { smooth: false, edges: true, transparent: false, backs: true, components: false, clip: null };
  mode: Mode = "before";
  border = 0.5;
  readonly camera = new Camera(() => this.draw());
  private readonly renderer: WebGLRenderer;
  private readonly stages = new Map<StateName, Stage>();
  private readonly plane = new Plane(new Vector3(-1, 0, 0), Infinity);
  private isWaiting = false;
  private size = "";
  private radius = 1;
  /** How often the view was drawn; tests wait for it. */
  frames = 0;

  /** Edges are smoothed where that costs nothing to speak of: not in a mesh that is `large`. */
  constructor(readonly canvas: HTMLCanvasElement, isLarge: boolean) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !isLarge, alpha: false, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true;
    this.renderer.autoClear = false;
    // Before the browser shows the new size, so that nothing flickers.
    new ResizeObserver(() => { if (this.frames > 0 && this.resize()) this.drawNow(); }).observe(canvas);
    canvas.addEventListener("webglcontextrestored", () => this.draw());
  }

  /** Shows other meshes. */
  show(states: Map<StateName, Seen>): void {
    for (const stage of this.stages.values()) this.strike(stage);
    this.stages.clear();
    for (const [name, seen] of states) {
      const stage: Stage = { scene: new Scene(), seen, surfaces: [], layers: new Map(), marked: null };
      stage.scene.background = new Color(0xffffff);
      this.stages.set(name, stage);
    }
    const first = states.get("before") ?? states.get("after");
    const bounds = (first?.shape ?? first?.mesh)?.bounds() ?? { middle: [0, 0, 0], radius: 1, low: [-1, -1, -1], high: [1, 1, 1] };
    this.radius = bounds.radius;
    this.camera.around(bounds, (first?.shape ?? first?.mesh)?.sample() ?? []);
    this.look.edges = (first?.mesh.shownFaces ?? 0) <= 100_000;
    this.mode = states.has("before") ? "before" : "after";
    this.camera.fit(this.aspect);
  }

  get aspect(): number { return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight); }

  fit(): void { this.camera.fit(this.aspect); }

  /** Draws a layer, or another one in its place; null takes it away. */
  layer(state: StateName, name: string, shown: Shown | null, look: Look, options: Partial<{ fill: number; order: number; faint: number }> = {}): void {
    const stage = this.stages.get(state);
    if (stage === undefined) return;
    const old = stage.layers.get(name);
    if (old !== undefined) { stage.scene.remove(old); dispose(old); stage.layers.delete(name); }
    if (shown !== null) {
      const group = overlay(stage.seen.mesh, shown, look, { plane: this.plane, unit: this.radius * 0.012, ...options });
      stage.layers.set(name, group);
      stage.scene.add(group);
    }
    this.draw();
  }

  /** Marks what is selected; null marks nothing. */
  mark(state: StateName, shown: Shown | null): void {
    for (const stage of this.stages.values()) {
      if (stage.marked !== null) { stage.scene.remove(stage.marked); dispose(stage.marked); stage.marked = null; }
    }
    const stage = this.stages.get(state);
    if (stage !== undefined && shown !== null) {
      const { mesh } = stage.seen;
      const unit = this.radius * 0.012;
      const lines = shown.ends.length > 0 ? shown.ends : outlines(mesh, shown.faces);
      const group = new Group();
      group.add(overlay(mesh, { vertices: [], ends: lines, faces: [] },
        { colour: "#111111", symbol: "circle", dash: null, width: 8 }, { plane: null, unit, order: 5, faint: 0.45 }));
      group.add(overlay(mesh, { vertices: shown.vertices, ends: lines, faces: shown.faces },
        { colour: "#ffd60a", symbol: "circle", dash: null, width: 4 },
        { plane: null, unit, order: 6, fill: 0.5, faint: 0.6, pointSize: 20 }));
      stage.marked = group;
      stage.scene.add(group);
    }
    this.draw();
  }

  /** Goes to a place where it is seen: as it is looked at now, else from the nearest direction without a face between. */
  flyTo(state: StateName, { point, size, shown, front }: { point: Point; size: number; shown: Shown; front: Point | null }): void {
    const { camera } = this;
    const mesh = this.stages.get(state)?.seen.mesh;
    const place = new Vector3(...point);
    const own = new Set(shown.faces);
    const normal = front === null ? null : new Vector3(...front).normalize();
    const isSeen = (direction: Direction) => {
      if (mesh === undefined) return true;
      const eye = towards(direction);
      if (normal !== null && normal.lengthSq() > 0.5 && Math.abs(normal.dot(eye)) < 0.2) return false;
      const from = place.clone().addScaledVector(eye, camera.closeUp(size));
      const hit = nearest(mesh, from, place.clone().sub(from), null);
      return hit === null || hit.share > 0.995 || own.has(hit.face);
    };
    // Each look is a walk over all faces.
    const tried = (mesh?.shownFaces ?? 0) > LONG_WALK ? 4 : 40;
    const all = camera.directions();
    camera.flyTo(point, size, all.slice(0, tried).find(isSeen) ?? all[0]);
  }

  /** Draws once the browser is ready for it. */
  draw(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.drawNow();
    });
  }

  /** What of a state lies under a point of the canvas: the place of a face, and the point on it. */
  pick(x: number, y: number): { state: StateName; face: number; point: Point } | null {
    const width = this.canvas.clientWidth;
    const state: StateName = this.mode === "both" ? (x < this.border * width ? "before" : "after") : this.mode;
    const stage = this.stages.get(state);
    if (stage === undefined) return null;
    const camera = this.camera.place(this.aspect);
    const [u, v] = [(2 * x) / width - 1, 1 - (2 * y) / this.canvas.clientHeight];
    const from = new Vector3(u, v, -1).unproject(camera);
    const along = new Vector3(u, v, 1).unproject(camera).sub(from);
    const hit = nearest(stage.seen.mesh, from, along, this.look.clip === null ? null : this.plane);
    return hit === null ? null : { state, face: hit.face, point: hit.point };
  }

  /** The plane that cuts the view, from the share of the mesh's box that is left. */
  private clip(): void {
    const { clip } = this.look;
    const stage = this.stages.get("before") ?? this.stages.get("after");
    if (clip === null || stage === undefined) { this.plane.set(new Vector3(-1, 0, 0), 1e30); return; }
    const { low, high } = (stage.seen.shape ?? stage.seen.mesh).bounds();
    const at = low[clip.axis] + (high[clip.axis] - low[clip.axis]) * clip.share;
    const normal = new Vector3();
    normal.setComponent(clip.axis, clip.flipped ? 1 : -1);
    this.plane.set(normal, clip.flipped ? -at : at);
  }

  private drawNow(): void {
    const { renderer } = this;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (width === 0 || height === 0) return;
    this.resize();
    this.clip();
    const camera = this.camera.place(this.aspect);
    const states: StateName[] = this.mode === "both" ? ["before", "after"] : [this.mode];
    renderer.setScissorTest(true);
    for (const state of states) {
      const stage = this.stages.get(state);
      if (stage === undefined) continue;
      this.build(stage);
      const at = Math.round(width * this.border);
      const [left, right] = this.mode !== "both" ? [0, width] : state === "before" ? [0, at] : [at, width];
      renderer.setScissor(left, 0, right - left, height);
      renderer.clear();
      renderer.render(stage.scene, camera);
    }
    this.frames++;
    this.canvas.dataset["frames"] = String(this.frames);
  }

  /** Surfaces are made when they are first seen. */
  private build(stage: Stage): void {
    const { look } = this;
    if (stage.surfaces.length === 0) {
      const { mesh, shape, components } = stage.seen;
      stage.surfaces.push(new Surface(mesh, components, this.plane));
      if (shape !== null) stage.surfaces.push(new Surface(shape, undefined, this.plane));
      stage.surfaces.forEach(surface => stage.scene.add(surface.group));
    }
    stage.surfaces.forEach((surface, i) => surface.look({
      smooth: look.smooth, edges: look.edges && i === 0, backs: look.backs, components: look.components,
      opacity: look.transparent ? 0.45 : i === 1 ? 0.35 : 1,
    }));
  }

  private strike(stage: Stage): void {
    stage.surfaces.forEach(surface => surface.dispose());
    stage.layers.forEach(dispose);
    if (stage.marked !== null) dispose(stage.marked);
  }

  /** Takes over the size of the canvas; gives whether it is another one. */
  private resize(): boolean {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = Math.min(2, devicePixelRatio);
    const size = `${clientWidth} ${clientHeight} ${ratio}`;
    // A size that is set again throws away what was drawn.
    if (clientWidth === 0 || clientHeight === 0 || size === this.size) return false;
    this.size = size;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    return true;
  }
}

/** The nearest face that a ray meets, where, and at which share of the way along it. */
function nearest(mesh: Mesh, from: Vector3, along: Vector3, plane: Plane | null): { face: number; point: Point; share: number } | null {
  const { vertices, faces } = mesh.triangles();
  const p = mesh.positions;
  let [best, face] = [Infinity, NOWHERE];
  for (let t = 0; t < faces.length; t++) {
    const [a, b, c] = [3 * vertices[3 * t], 3 * vertices[3 * t + 1], 3 * vertices[3 * t + 2]];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [qx, qy, qz] = [along.y * vz - along.z * vy, along.z * vx - along.x * vz, along.x * vy - along.y * vx];
    const det = ux * qx + uy * qy + uz * qz;
    if (det === 0) continue;
    const [sx, sy, sz] = [from.x - p[a], from.y - p[a + 1], from.z - p[a + 2]];
    const u = (sx * qx + sy * qy + sz * qz) / det;
    if (u < 0 || u > 1) continue;
    const [rx, ry, rz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (along.x * rx + along.y * ry + along.z * rz) / det;
    if (v < 0 || u + v > 1) continue;
    const s = (vx * rx + vy * ry + vz * rz) / det;
    if (s <= 0 || s >= best) continue;
    if (plane !== null && plane.distanceToPoint(from.clone().addScaledVector(along, s)) < 0) continue;
    [best, face] = [s, faces[t]];
  }
  if (face === NOWHERE) return null;
  return { face, point: [from.x + along.x * best, from.y + along.y * best, from.z + along.z * best], share: best };
}
