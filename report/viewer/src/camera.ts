// From where the mesh is seen: a direction and a distance about a point, moved by hand or by keys.

import { OrthographicCamera, PerspectiveCamera, Vector3 } from "three";
import { Point } from "./mesh.js";

const FIELD = 32;

/** The six sides, with the key that shows each: azimuth and elevation in degrees. */
export const SIDES: [string, number, number][] = [
  ["front", -90, 0], ["back", 90, 0], ["left", 180, 0], ["right", 0, 0], ["top", -90, 90], ["bottom", -90, -90],
];

/** Azimuth and elevation in degrees. */
export type Direction = [number, number];

/** The direction towards an eye. */
export function towards([azimuth, elevation]: Direction): Vector3 {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return new Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
}

export class Camera {
  /** Degrees about the z axis, and above the plane across it. */
  azimuth = -50;
  elevation = 24;
  readonly target = new Vector3();
  distance = 5;
  isParallel = false;
  private radius = 1;
  private middle: Point = [0, 0, 0];
  /** What is to be within the view, about the middle. */
  private corners: Vector3[] = [];
  private flight = 0;
  private readonly perspective = new PerspectiveCamera(FIELD, 1, 0.01, 100);
  private readonly parallel = new OrthographicCamera();

  constructor(private readonly changed: () => void) {}

  /** What there is to see. */
  around({ middle, radius, low, high }: { middle: Point; radius: number; low: Point; high: Point }, points: Point[]): void {
    this.middle = middle;
    this.radius = radius;
    const seen = points.length > 0 ? points : [low, high];
    this.corners = seen.map(point => new Vector3(...point).sub(new Vector3(...middle)));
  }

  get camera(): PerspectiveCamera | OrthographicCamera { return this.isParallel ? this.parallel : this.perspective; }

  fit(aspect: number): void {
    this.land();
    this.target.set(...this.middle);
    const [across, upward] = this.axes();
    const [eye, half] = [this.towardsEye(), Math.tan((FIELD * Math.PI) / 360) * 0.86];
    // So far away that all of it is within the view.
    this.distance = Math.max(...this.corners.map(corner => {
      const depth = this.isParallel ? 0 : corner.dot(eye);
      return depth + Math.max(Math.abs(corner.dot(across)) / (half * aspect), Math.abs(corner.dot(upward)) / half);
    }), this.radius * 0.1);
    this.changed();
  }

  side(azimuth: number, elevation: number): void {
    this.land();
    [this.azimuth, this.elevation] = [azimuth, elevation];
    this.changed();
  }

  turn(right: number, up: number): void {
    this.land();
    this.azimuth -= right;
    this.elevation = Math.max(-90, Math.min(90, this.elevation + up));
    this.changed();
  }

  /** Moves the target, in shares of the view's height. */
  pan(right: number, up: number): void {
    this.land();
    const [across, upward] = this.axes();
    const size = 2 * this.distance * Math.tan((FIELD * Math.PI) / 360);
    this.target.addScaledVector(across, -right * size).addScaledVector(upward, -up * size);
    this.changed();
  }

  zoom(factor: number): void {
    this.land();
    this.distance = Math.max(this.radius * 1e-4, Math.min(this.radius * 60, this.distance * factor));
    this.changed();
  }

  /** Goes to where a place of some size fills a part of the view, seen from a direction. */
  flyTo(place: Point, size: number, [azimuth, elevation]: Direction): void {
    const from = { target: this.target.clone(), distance: this.distance, azimuth: this.azimuth, elevation: this.elevation };
    const to = { target: new Vector3(...place), distance: this.closeUp(size), azimuth, elevation };
    const turn = ((((to.azimuth - from.azimuth) % 360) + 540) % 360) - 180;
    const at = (t: number) => {
      this.target.lerpVectors(from.target, to.target, t);
      this.distance = from.distance * Math.pow(to.distance / from.distance, t);
      this.azimuth = from.azimuth + turn * t;
      this.elevation = from.elevation + (to.elevation - from.elevation) * t;
      this.changed();
    };
    this.land();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) { at(1); return; }
    const begin = performance.now();
    const flight = ++this.flight;
    const step = (now: number) => {
      if (flight !== this.flight) return;
      const t = Math.min(1, Math.max(0, (now - begin) / 280));
      at(t * t * (3 - 2 * t));
      if (t < 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  /** Sets the camera up for a view of this shape. */
  place(aspect: number): PerspectiveCamera | OrthographicCamera {
    const camera = this.camera;
    const eye = this.towardsEye();
    const far = this.distance + this.target.distanceTo(new Vector3(...this.middle)) + this.radius * 1.1;
    camera.position.copy(this.target).addScaledVector(eye, this.distance);
    const [, up] = this.axes();
    camera.up.copy(up);
    camera.lookAt(this.target);
    if (camera instanceof PerspectiveCamera) {
      camera.aspect = aspect;
      camera.near = Math.max(this.distance - (far - this.distance), this.distance / 500);
      camera.far = far;
    } else {
      const half = this.distance * Math.tan((FIELD * Math.PI) / 360);
      [camera.left, camera.right, camera.top, camera.bottom] = [-half * aspect, half * aspect, half, -half];
      camera.near = this.distance - far - this.radius;
      camera.far = far;
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return camera;
  }

  /** From how far a place of some size is looked at. */
  closeUp(size: number): number {
    const near = Math.max(size, this.radius * 0.02) * 3.2 / Math.tan((FIELD * Math.PI) / 360);
    return Math.min(near, this.radius * 3.8);
  }

  /** Directions from which something may be seen better, the present one and those near it first. */
  directions(): Direction[] {
    const all: Direction[] = [[this.azimuth, this.elevation]];
    for (const turn of [0, 40, -40, 80, -80, 120, -120, 160, -160]) {
      for (const elevation of [24, 60, -24, -60]) all.push([this.azimuth + turn, elevation]);
    }
    const eye = this.towardsEye();
    const nearness = new Map(all.map(direction => [direction, towards(direction).dot(eye)]));
    return all.sort((a, b) => nearness.get(b)! - nearness.get(a)!);
  }

  towardsEye(): Vector3 { return towards([this.azimuth, this.elevation]); }

  private axes(): [Vector3, Vector3] {
    const a = (this.azimuth * Math.PI) / 180;
    const across = new Vector3(-Math.sin(a), Math.cos(a), 0);
    return [across, new Vector3().crossVectors(this.towardsEye(), across)];
  }

  /** Ends a flight where it is. */
  private land(): void { this.flight++; }
}
