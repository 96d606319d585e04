// The hand on the view: pointer, wheel and keys.

import { SIDES } from "./camera.js";
import { View } from "./view.js";

export interface Asked {
  picked(x: number, y: number): void;
  toggle(what: "smooth" | "edges" | "transparent" | "backs" | "components" | "projection" | "clip"): void;
  nextMode(): void;
  walk(step: 1 | -1): void;
  clear(): void;
}

export function control(view: View, asked: Asked): void {
  const { canvas, camera } = view;
  const pointers = new Map<number, { x: number; y: number }>();
  let moved = 0;
  canvas.addEventListener("pointerdown", event => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    moved = 0;
    event.preventDefault();
  });
  canvas.addEventListener("pointermove", event => {
    const last = pointers.get(event.pointerId);
    if (last === undefined) return;
    const [dx, dy] = [event.offsetX - last.x, event.offsetY - last.y];
    moved += Math.abs(dx) + Math.abs(dy);
    const height = canvas.clientHeight;
    if (pointers.size === 2) {
      const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      const before = Math.hypot(last.x - other.x, last.y - other.y);
      const now = Math.hypot(event.offsetX - other.x, event.offsetY - other.y);
      if (before > 0 && now > 0) camera.zoom(before / now);
      camera.pan(dx / height / 2, -dy / height / 2);
    } else if (moved > 3) {
      if (event.buttons & 2 || event.buttons & 4 || event.shiftKey) camera.pan(dx / height, -dy / height);
      else camera.turn((dx * 220) / height, (dy * 220) / height);
    }
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
  });
  const up = (event: PointerEvent) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && moved <= 3 && event.button === 0) asked.picked(event.offsetX, event.offsetY);
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("dblclick", () => view.fit());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    camera.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 400))));
  }, { passive: false });
  canvas.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (key(event.key, event.shiftKey)) event.preventDefault();
  });

  function key(name: string, shift: boolean): boolean {
    const arrows: Record<string, [number, number]> =
      { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const arrow = arrows[name];
    if (arrow !== undefined) {
      if (shift) camera.pan(arrow[0] * 0.08, arrow[1] * 0.08);
      else camera.turn(arrow[0] * -10, arrow[1] * 10);
      return true;
    }
    const side = SIDES[Number(name) - 1];
    if (side !== undefined) { camera.side(side[1], side[2]); return true; }
    switch (name) {
      case "+": case "=": camera.zoom(0.8); return true;
      case "-": camera.zoom(1.25); return true;
      case "f": case "0": view.fit(); return true;
      case "s": asked.toggle("smooth"); return true;
      case "e": asked.toggle("edges"); return true;
      case "t": asked.toggle("transparent"); return true;
      case "k": asked.toggle("backs"); return true;
      case "g": asked.toggle("components"); return true;
      case "p": asked.toggle("projection"); return true;
      case "c": asked.toggle("clip"); return true;
      case "b": asked.nextMode(); return true;
      case "n": asked.walk(1); return true;
      case "N": asked.walk(-1); return true;
      case "Escape": asked.clear(); return true;
      default: return false;
    }
  }
}
