// The figures of a mesh: what each is called, what it means in a sentence, and which layer shows it.

import { Json } from "./data.js";
import { shown } from "./dom.js";

export interface Figure { key: string; title: string; sentence: string; of(report: Json): string | null; layer?: string }

const number = (key: string) => (report: Json): string | null => {
  const value = report?.[key];
  return typeof value === "number" ? shown(value) : null;
};
const yes = (key: string) => (report: Json): string | null => {
  const value = report?.[key];
  return typeof value === "boolean" ? (value ? "yes" : "no") : null;
};

/** What several components are, as `2 × sphere, torus`. */
function which(report: Json): string | null {
  const kinds: Json[] = report?.component_kinds ?? [];
  if (kinds.length === 0) return null;
  const counts = new Map<string, number>();
  for (const kind of kinds) counts.set(kind.name ?? "not a surface", (counts.get(kind.name ?? "not a surface") ?? 0) + kind.count);
  const named = [...counts].slice(0, 4).map(([name, count]) => (count > 1 ? `${shown(count)} × ` : "") + name);
  const rest = (report.component_kinds_total ?? kinds.length) - kinds.length + counts.size - named.length;
  return named.join(", ") + (rest > 0 ? ` and ${shown(rest)} more kinds` : "");
}

export const FIGURES: Figure[] = [
  { key: "component_kinds", title: "Which surfaces", sentence: "What each component is, where it is a surface: closed ones are told by their handles or cross-caps, open ones by their boundary loops too.", of: which, layer: "components" },
  { key: "vertices", title: "Vertices", sentence: "V: the vertices that faces use.", of: number("vertices") },
  { key: "edges", title: "Edges", sentence: "E: pairs of vertices that a side of a face joins, each counted once.", of: number("edges") },
  { key: "faces", title: "Faces", sentence: "F: the faces that have at least three different corners.", of: number("faces") },
  { key: "euler_characteristic", title: "Euler characteristic", sentence: "χ = V − E + F. Bending and cutting faces finer don't change it; a sphere has 2, a torus 0.", of: number("euler_characteristic") },
  { key: "components", title: "Components", sentence: "How many pieces there are that share no vertex.", of: number("components"), layer: "components" },
  { key: "boundary_edges", title: "Boundary edges", sentence: "Edges with one side: the surface is open there.", of: number("boundary_edges"), layer: "boundary-edge" },
  { key: "boundary_loops", title: "Boundary loops", sentence: "How many closed paths the boundary edges make: each is a hole or an outer border.", of: number("boundary_loops"), layer: "boundary-edge" },
  { key: "genus", title: "Genus", sentence: "How many handles there are in all: (2 − χ − b) / 2 for one orientable surface with b boundary loops.", of: number("genus"), layer: "generators" },
  { key: "cross_caps", title: "Cross-caps", sentence: "What an unorientable surface has in place of handles: 2 − χ − b of them.", of: number("cross_caps"), layer: "generators" },
  { key: "betti", title: "Betti numbers mod 2", sentence: "β₀ pieces, β₁ closed paths that bound nothing and don't make up one another, β₂ enclosed spaces.", of: report => report?.betti?.z2?.join(" ") ?? null, layer: "generators" },
  { key: "betti_q", title: "Betti numbers over ℚ", sentence: "The same with fractions as coefficients; they differ from those mod 2 where a surface has one side only.", of: report => report?.betti?.q?.join(" ") ?? null },
  { key: "manifold", title: "Manifold", sentence: "Whether it is a surface everywhere: each edge has one or two sides, and the faces at each vertex are one fan.", of: yes("manifold"), layer: "non-manifold-edge" },
  { key: "closed", title: "Closed", sentence: "Whether it has no boundary.", of: yes("closed"), layer: "boundary-edge" },
  { key: "consistently_oriented", title: "Consistently oriented", sentence: "Whether neighbouring faces agree which side is the front.", of: yes("consistently_oriented"), layer: "inconsistent-edge" },
  { key: "orientable", title: "Orientable", sentence: "Whether they could agree, if some were turned: a Möbius band can't.", of: yes("orientable"), layer: "non-orientable-patch" },
];

export const INSTIGATORS: [string, string, string][] = [
  ["Vertices", "v_c", "v_n"], ["Edges", "e_c", "e_n"], ["Faces", "f_c", "f_n"],
];
