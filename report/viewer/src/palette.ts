// How layers look. What differs in colour differs in a symbol and in dashes too; tests/palette.test.mjs looks at the
// colours as people with each kind of colour blindness see them.

export type Symbol = "circle" | "square" | "diamond" | "triangle" | "down" | "cross" | "plus" | "star";

export interface Look { colour: string; symbol: Symbol; dash: [number, number] | null; width: number }

/** In the order in which kinds get them; beyond these they come again with other symbols and dashes. */
export const COLOURS = ["#c1121f", "#0a58ca", "#b8860b", "#6a1b9a", "#00796b", "#111111", "#d6579b", "#6b7a8f"];
const SYMBOLS: Symbol[] = ["diamond", "circle", "triangle", "square", "cross", "plus", "down", "star"];
const DASHES: ([number, number] | null)[] = [[2.2, 1.2], null, [0.8, 0.8], [5, 2]];

/** Kinds that always look the same, so that pages can be compared. */
const FIXED: Record<string, number> = {
  "non-manifold-edge": 0, "boundary-edge": 1, "inconsistent-edge": 2, "non-orientable-patch": 3,
  "singular-vertex": 5, "pinched-vertex": 5, "coincident-vertex": 4, "duplicate-face": 6, "crossing-faces": 0,
  "t-junction": 2, "sliver-face": 6, "zero-area-face": 6, "degenerate-face": 6, "unreferenced-vertex": 7,
  removed: 7, generators: 4, seam: 5, tree: 6, cotree: 7, flipped: 2, created: 4,
};

/** The looks of some kinds, no two the same. */
export function looks(kinds: string[]): Map<string, Look> {
  const found = new Map<string, Look>();
  const taken = new Set<string>();
  let next = 0;
  for (const kind of kinds) {
    let colour = FIXED[kind] ?? next++ % COLOURS.length;
    let turn = 0;
    let look: Look;
    do {
      const round = Math.floor(turn / COLOURS.length);
      look = {
        colour: COLOURS[colour % COLOURS.length], symbol: SYMBOLS[(colour + round) % SYMBOLS.length],
        dash: DASHES[(colour + round) % DASHES.length], width: kind === "non-manifold-edge" ? 5 : 3.5,
      };
      if (taken.has(look.colour + look.symbol)) { turn++; colour++; } else break;
    } while (turn < COLOURS.length * SYMBOLS.length);
    taken.add(look.colour + look.symbol);
    found.set(kind, look);
  }
  return found;
}

/** The faces of components, as in the pictures of `render`. */
export const COMPONENTS = [
  [240, 196, 110], [126, 178, 214], [156, 206, 150], [222, 150, 132], [196, 176, 222], [232, 224, 140], [140, 200, 196],
  [214, 178, 150],
] as const;

const PATHS: Record<Symbol, (g: CanvasPath, r: number) => void> = {
  circle: (g, r) => g.arc(0, 0, r * 0.85, 0, 2 * Math.PI),
  square: (g, r) => g.rect(-r * 0.75, -r * 0.75, r * 1.5, r * 1.5),
  diamond: (g, r) => polygon(g, [[0, -r], [r, 0], [0, r], [-r, 0]]),
  triangle: (g, r) => polygon(g, [[0, -r], [r * 0.95, r * 0.75], [-r * 0.95, r * 0.75]]),
  down: (g, r) => polygon(g, [[0, r], [r * 0.95, -r * 0.75], [-r * 0.95, -r * 0.75]]),
  cross: (g, r) => bars(g, r, Math.PI / 4),
  plus: (g, r) => bars(g, r, 0),
  star: (g, r) => polygon(g, Array.from({ length: 10 }, (_, i) => {
    const [angle, far] = [(i * Math.PI) / 5 - Math.PI / 2, i % 2 ? r * 0.45 : r];
    return [far * Math.cos(angle), far * Math.sin(angle)];
  })),
};

function polygon(g: CanvasPath, points: number[][]): void {
  points.forEach(([x, y], i) => (i ? g.lineTo(x, y) : g.moveTo(x, y)));
  g.closePath();
}

function bars(g: CanvasPath, r: number, turn: number): void {
  const t = r * 0.32;
  const shape = [[-t, -r], [t, -r], [t, -t], [r, -t], [r, t], [t, t], [t, r], [-t, r], [-t, t], [-r, t], [-r, -t], [-t, -t]];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  polygon(g, shape.map(([x, y]) => [c * x - s * y, s * x + c * y]));
}

/** A picture of a symbol with a pale rim, so that it stands out of any face. */
export function symbolPicture(look: Look, size: number): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const g = canvas.getContext("2d")!;
  g.translate(size / 2, size / 2);
  g.beginPath();
  PATHS[look.symbol](g, size * 0.38);
  g.lineJoin = "round";
  g.lineWidth = size * 0.16;
  g.strokeStyle = "#fff";
  g.stroke();
  g.fillStyle = look.colour;
  g.fill();
  return canvas;
}
