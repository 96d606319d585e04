// The switches above the view. All have a key too, when the view has the focus.

import { SIDES } from "./camera.js";
import { h, replace } from "./dom.js";
import { Mode, View } from "./view.js";

export class Toolbar {
  readonly element = h("div", { class: "toolbar", role: "toolbar", "aria-label": "how the mesh is shown" });
  private readonly modes = new Map<Mode, HTMLButtonElement>();
  private readonly toggles = new Map<string, HTMLButtonElement>();
  private readonly clip = h("div", { class: "clip" });
  private readonly modeGroup = h("div", { class: "segments", role: "group", "aria-label": "which state" });

  constructor(private readonly view: View, private readonly changed: (mode: Mode) => void) {
    const { camera } = view;
    for (const [mode, title] of [["before", "Before"], ["both", "Both"], ["after", "After"]] as const) {
      const button = h("button", { type: "button", click: () => this.setMode(mode) }, title);
      this.modes.set(mode, button);
      this.modeGroup.append(button);
    }
    const toggle = (name: string, title: string, key: string) => {
      const button = h("button", { type: "button", "aria-pressed": "false", title: `key ${key}`, click: () => this.toggle(name) }, title);
      this.toggles.set(name, button);
      return button;
    };
    const sides = h("div", { class: "segments", role: "group", "aria-label": "seen from" }, ...SIDES.map(([name, azimuth, elevation], i) =>
      h("button", { type: "button", title: `from the ${name}, key ${i + 1}`, click: () => camera.side(azimuth, elevation) },
        { front: "Front", back: "Back", left: "Left", right: "Right", top: "Top", bottom: "Below" }[name])));
    replace(this.element, this.modeGroup,
      h("div", { class: "segments", role: "group", "aria-label": "the faces" },
        toggle("edges", "Edges", "e"), toggle("smooth", "Smooth", "s"), toggle("transparent", "See-through", "t"),
        toggle("backs", "Backs", "k"), toggle("components", "Components", "g")),
      sides,
      h("div", { class: "segments", role: "group", "aria-label": "the camera" },
        h("button", { type: "button", title: "key f", click: () => view.fit() }, "Fit"),
        toggle("projection", "Parallel", "p"), toggle("clip", "Cut", "c")),
      this.clip);
    this.showClip();
    this.refresh();
  }

  toggle(name: string): void {
    const { look, camera } = this.view;
    switch (name) {
      case "smooth": look.smooth = !look.smooth; break;
      case "edges": look.edges = !look.edges; break;
      case "transparent": look.transparent = !look.transparent; break;
      case "backs": look.backs = !look.backs; break;
      case "components": look.components = !look.components; break;
      case "projection": camera.isParallel = !camera.isParallel; break;
      case "clip": look.clip = look.clip === null ? { axis: 0, share: 0.5, flipped: false } : null; this.showClip(); break;
    }
    this.refresh();
    this.view.draw();
  }

  /** Which states there are to see. */
  states(hasBefore: boolean, hasAfter: boolean, hasComponents: boolean): void {
    this.modeGroup.hidden = !(hasBefore && hasAfter);
    // The view has chosen which state is seen, and whether edges can be told apart.
    this.toggles.get("components")!.hidden = !hasComponents;
    if (!hasComponents) this.view.look.components = false;
    this.refresh();
  }

  setMode(mode: Mode): void {
    if (this.modeGroup.hidden) return;
    this.view.mode = mode;
    this.refresh();
    this.view.draw();
    this.changed(mode);
  }

  nextMode(): void {
    const all: Mode[] = ["before", "both", "after"];
    this.setMode(all[(all.indexOf(this.view.mode) + 1) % 3]);
  }

  refresh(): void {
    const { look, camera, mode } = this.view;
    for (const [name, button] of this.modes) button.setAttribute("aria-pressed", String(name === mode));
    const on: Record<string, boolean> = {
      smooth: look.smooth, edges: look.edges, transparent: look.transparent, backs: look.backs, components: look.components,
      projection: camera.isParallel, clip: look.clip !== null,
    };
    for (const [name, button] of this.toggles) button.setAttribute("aria-pressed", String(on[name]));
  }

  private showClip(): void {
    const { clip } = this.view.look;
    this.clip.hidden = clip === null;
    if (clip === null) { replace(this.clip); return; }
    const axis = h("select", { "aria-label": "axis of the cut", change: () => { clip.axis = Number(axis.value) as 0 | 1 | 2; this.view.draw(); } },
      ...["x", "y", "z"].map((name, i) => h("option", { value: i }, name)));
    const share = h("input", {
      type: "range", min: 0, max: 1, step: 0.005, value: clip.share, "aria-label": "where it is cut",
      input: () => { clip.share = Number(share.value); this.view.draw(); },
    });
    const flip = h("button", { type: "button", "aria-pressed": "false", click: () => {
      clip.flipped = !clip.flipped;
      flip.setAttribute("aria-pressed", String(clip.flipped));
      this.view.draw();
    } }, "Other half");
    replace(this.clip, axis, share, flip);
  }
}
