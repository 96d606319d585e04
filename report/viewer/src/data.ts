// What the page's data holds; the names are those of the crate `meshmend-report` and of docs/json.md.

export interface PageData {
  form: number;
  program: string;
  title: string;
  date: string | null;
  kinds: Record<string, Kind>;
  entries: Entry[];
}

export interface Kind { title: string; severity: "defect" | "note"; explanation: string }

export interface Entry {
  name: string;
  part?: string;
  verdict: { state: string; sentence: string };
  command: "check" | "repair" | "batch" | null;
  report: Json;
  before?: StateData;
  after?: StateData;
  changes?: { removed: [string, string][]; flipped: string; created: string };
}

export interface StateData {
  mesh: MeshData;
  shape?: MeshData;
  marks: Record<string, MarkData>;
  loops: LoopData;
  pictures: string[];
}

export interface MeshData {
  origin: [number, number, number];
  vertices: number;
  faces: number;
  positions: string;
  offsets?: string;
  corners: string;
  vertex_ids?: string;
  face_ids?: string;
  loose_edges?: string;
}

export interface MarkData {
  count: number;
  drawn: number;
  vertices: string;
  edges: string;
  faces: string;
  strips?: { faces: number[]; edges: [number, number][] }[];
}

export interface LoopData {
  components?: string;
  generators?: number[][];
  more_generators: number;
  tree?: string;
  cotree?: string;
  seam?: string;
}

/** A document of a check or a repair: plain JSON, read with care. */
// eslint-disable-next-line @typescript-eslint/no-explicit-any
export type Json = any;

export interface Item {
  element: string;
  message: string;
  vertices: number[];
  positions: (number | null)[][];
  vertex?: number;
  edge?: number;
  face?: number;
  /** The kind of defect. */
  kind?: string;
  ends?: [number, number];
  faces?: number[];
  edge_ends?: [number, number][];
  beside?: { element: string; face?: number; vertex?: number; edge?: number; ends?: [number, number] };
}

export interface Group { kind: string; severity: "defect" | "note"; count: number; items: Item[] }

/** The defects of a state, group by group. */
export function groups(entry: Entry, state: StateName): Group[] {
  const report = hasStates(entry) ? entry.report?.[state] : state === "before" ? entry.report : null;
  return report?.defects ?? [];
}

const hasStates = (entry: Entry): boolean => entry.command === "repair" || entry.command === "batch";

/** The figures of a state. */
export function figures(entry: Entry, state: StateName): Json {
  return hasStates(entry) ? entry.report?.[state] ?? null : state === "before" ? entry.report : null;
}

export type StateName = "before" | "after";

export function title(entry: Entry): string {
  return entry.part === undefined ? entry.name : `${entry.name}, ${entry.part}`;
}

const fromBase64: ((text: string) => Uint8Array) | undefined =
  (Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array }).fromBase64?.bind(Uint8Array);

function bytes(text: string): ArrayBuffer {
  if (fromBase64 !== undefined) return fromBase64(text).buffer as ArrayBuffer;
  const binary = atob(text);
  const array = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) array[i] = binary.charCodeAt(i);
  return array.buffer;
}

export const numbers = (text: string): Uint32Array => new Uint32Array(bytes(text));
export const floats = (text: string): Float32Array => new Float32Array(bytes(text));
