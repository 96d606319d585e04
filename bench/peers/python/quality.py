"""What answers are worth, beside other programs: which faces cross, and what becomes of holes. Prints tables.

    quality.py --program MESHMEND --cases DIR --reference DIR [--corpus DIR]

Faces that cross or overlap are those of the executable reference (`intersections.py`, exact). `missed` are crossing faces
that a program does not name, `touching` those that it names and that only touch others, `false` those that it names and that
meet all others properly. Faces that coincide are left out of it, as some count them and some do not. Fills are judged by
the reference likewise: open edges that are left, whether faces cross that did not before, the greatest fold (1 − cos
between the normals of two faces, one of which is new, 0 to 2), and the new area as a part of all.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
from collections import Counter

import numpy as np

# The reference is slow.
MOST_FACES = 2000
MOST_BYTES = 300_000
ENDINGS = {"off", "obj", "ply", "stl"}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    parser.add_argument("--cases", type=pathlib.Path, required=True)
    parser.add_argument("--reference", required=True)
    parser.add_argument("--corpus", type=pathlib.Path)
    options = parser.parse_args()
    sys.path.insert(0, options.reference)
    expected = json.loads((options.cases / "expected.json").read_text())
    cases = {question: [options.cases / case["file"] for case in expected if case["question"] == question]
             for question in ("intersections", "holes")}
    inputs = {"cases": (meshes(cases["intersections"]), meshes(cases["holes"]))}
    if options.corpus:
        of_corpus = meshes(welded(options.program, options.corpus))
        inputs["corpus"] = (of_corpus, [mesh for mesh in of_corpus if is_open(mesh[1])])
    peers = [peer for peer in map(had, [MeshLab, MeshLib]) if peer]
    programs = [Meshmend(options.program), *peers]
    for name, (crossing, holes) in inputs.items():
        compare_crossings(name, crossing, programs)
        compare_fills(name, holes, programs)


def had(peer):
    try:
        return peer()
    except ImportError as error:
        print(f"not had: {error}", file=sys.stderr)
        return None


def welded(program, corpus):
    """The files of the corpus as OFF: welded exactly, cleaned and cut into triangles."""
    folder = pathlib.Path(tempfile.mkdtemp())
    files = sorted(path for path in corpus.glob("real/**/*") if path.suffix[1:].lower() in ENDINGS)
    for at, file in enumerate(files):
        if file.stat().st_size < MOST_BYTES:
            command = [program, "repair", file, "-o", folder / f"{at:04}.off", "--triangulate", "all", "-q"]
            subprocess.run([*command, "--orient", "off", "--split", "off"], capture_output=True)
    return sorted(folder.glob("*.off"))


def meshes(files):
    """Points and triangles of those files that have nothing but triangles of finite, moderate corners."""
    import geo

    found = []
    for file in files:
        try:
            mesh = geo.read(str(file))
        except Exception:
            continue
        if not mesh.faces or len(mesh.faces) > MOST_FACES or any(len(set(face)) != 3 for face in mesh.faces):
            continue
        if any(at is None for at in mesh.at):
            continue
        points = np.array([mesh.real(at) for at in mesh.at], np.float64)
        # Programs of single precision get what they can hold.
        if (points.astype(np.float32) == points).all():
            found.append((points, np.array(mesh.faces, np.int64)))
    return found


def reference(points, triangles):
    import geo
    import intersections

    return intersections.intersections(geo.Mesh(points.tolist(), triangles.tolist()))


def compare_crossings(name, inputs, programs):
    totals = {program.name: Counter() for program in programs}
    truth = Counter()
    for points, triangles in inputs:
        found = reference(points, triangles)["pairs"]
        faces = {contact: {face for pair in found if is_of(pair, contact) for face in pair[:2]}
                 for contact in ("crossing", "coincident", "touching")}
        crossing = faces["crossing"] - faces["coincident"]
        touching = faces["touching"] - crossing - faces["coincident"]
        truth.update(meshes=1, crossing=len(crossing), touching=len(touching))
        for program in programs:
            named = program.crossing(points, triangles)
            if named is None:
                totals[program.name]["refused"] += 1
                continue
            named -= faces["coincident"]
            totals[program.name].update(missed=len(crossing - named), touching=len(named & touching),
                                        false=len(named - crossing - touching))
    print(f"\nCrossing faces, {name}: {truth['meshes']} meshes, {truth['crossing']} faces that cross, "
          f"{truth['touching']} that only touch\n")
    print("| program | missed | touching | false | refused meshes |\n|---|--:|--:|--:|--:|")
    for program, total in totals.items():
        print(f"| {program} | {total['missed']} | {total['touching']} | {total['false']} | {total['refused']} |")


def is_of(pair, contact):
    named = {"face-face": "crossing", "coincident": "coincident"}
    return named.get(pair[2], "touching") == contact


def compare_fills(name, inputs, programs):
    """Folds and areas are told of the meshes that every program closes, so that they are of the same holes."""
    filled = {program.name: [program.filled(*mesh) for mesh in inputs] for program in programs}
    closed = [at for at in range(len(inputs))
              if all(result[at] is not None and not open_edges(result[at][1]) for result in filled.values())]
    crossings = [crossing_count(*mesh) for mesh in inputs]
    print(f"\nFills, {name}: {len(inputs)} meshes, {sum(open_edges(mesh[1]) for mesh in inputs)} open edges; "
          f"all programs close {len(closed)} meshes\n")
    print("| program | meshes closed | open edges left | greatest fold, mean | area added, mean "
          "| meshes with new crossings | refused meshes |\n|---|--:|--:|--:|--:|--:|--:|")
    for program, results in filled.items():
        had = [result for result in results if result is not None]
        left = sum(open_edges(result[1]) for result in had)
        whole = sum(not open_edges(result[1]) for result in had)
        before = [known(*inputs[at]) for at in closed]
        folds = [greatest_fold(*results[at], old) for at, old in zip(closed, before)]
        areas = [added_area(*results[at], old) for at, old in zip(closed, before)]
        crossed = sum(crossing_count(*result) > count
                      for result, count in zip(results, crossings) if result is not None)
        print(f"| {program} | {whole} | {left} | {np.mean(folds or [0]):.3f} | {np.mean(areas or [0]):.4g} "
              f"| {crossed} | {len(results) - len(had)} |")


def crossing_count(points, triangles):
    return reference(points, triangles)["crossing_faces"]


def edges(triangles):
    sides = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return np.unique(sides, axis=0, return_inverse=True, return_counts=True)


def open_edges(triangles):
    return int((edges(np.asarray(triangles))[2] == 1).sum())


def is_open(triangles):
    return open_edges(triangles) > 0


def known(points, triangles):
    return Counter(frozenset(map(tuple, points[triangle])) for triangle in triangles)


def are_new(corners, before):
    """Which triangles are there more often than before."""
    left, new = before.copy(), []
    for triangle in corners:
        key = frozenset(map(tuple, triangle))
        new.append(left[key] == 0)
        left[key] -= left[key] > 0
    return np.array(new, bool)


def greatest_fold(points, triangles, before):
    """Over all edges of new faces that two faces share."""
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    is_new = are_new(corners, before)
    of_side = edges(triangles)[1].ravel()
    order = np.argsort(of_side, kind="stable")
    greatest = 0.0
    for one, other in zip(order[:-1], order[1:]):
        f, g = one // 3, other // 3
        if of_side[one] == of_side[other] and (is_new[f] or is_new[g]) and lengths[f] * lengths[g] > 0:
            greatest = max(greatest, 1 - normals[f] @ normals[g] / (lengths[f] * lengths[g]))
    return greatest


def added_area(points, triangles, before):
    """Of the new faces, as a part of the area of all."""
    corners = points[triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    return areas[are_new(corners, before)].sum() / areas.sum()


def write_off(path, points, triangles):
    rows = [f"OFF\n{len(points)} {len(triangles)} 0"]
    rows += [" ".join(map(repr, point)) for point in points.tolist()]
    rows += ["3 " + " ".join(map(str, face)) for face in triangles.tolist()]
    path.write_text("\n".join(rows) + "\n")


def read_off(path):
    rows = [line.split() for line in path.read_text().splitlines() if line and not line.startswith("#")]
    count = int(rows[1][0])
    points = np.array([list(map(float, row[:3])) for row in rows[2 : 2 + count]])
    return points, np.array([list(map(int, row[1:4])) for row in rows[2 + count :]], np.int64)


class Meshmend:
    name = "meshmend"

    def __init__(self, program):
        self.program = program
        self.folder = pathlib.Path(tempfile.mkdtemp())

    def crossing(self, points, triangles):
        file = self.folder / "mesh.off"
        write_off(file, points, triangles)
        command = [self.program, "check", "--geometry=crossings", "--limit", "1000000", "--json", file]
        said = subprocess.run(command, capture_output=True, text=True)
        pairs = json.loads(said.stdout)["geometry"]["intersections"]["pairs"]
        return {face for pair in pairs if pair[2] == "face-face" for face in pair[:2]}

    def filled(self, points, triangles):
        file, filled = self.folder / "mesh.off", self.folder / "filled.off"
        write_off(file, points, triangles)
        # Alone, so that all programs fill the same mesh.
        command = [self.program, "repair", "--fill", "all", "--fill-rims", "-q", "-o", filled, file]
        filled.unlink(missing_ok=True)
        subprocess.run(command, capture_output=True, text=True)
        return read_off(filled) if filled.exists() else None


class MeshLab:
    def __init__(self):
        import pymeshlab

        self.library = pymeshlab
        self.name = "MeshLab"

    def mesh_set(self, points, triangles):
        meshes = self.library.MeshSet(verbose=False)
        meshes.add_mesh(self.library.Mesh(points, triangles))
        return meshes

    def crossing(self, points, triangles):
        meshes = self.mesh_set(points, triangles)
        meshes.compute_selection_by_self_intersections_per_face()
        return set(np.flatnonzero(meshes.current_mesh().face_selection_array()).tolist())

    def filled(self, points, triangles):
        meshes = self.mesh_set(points, triangles)
        try:
            meshes.meshing_close_holes(maxholesize=100000)
        except self.library.PyMeshLabException:
            return None
        mesh = meshes.current_mesh()
        return mesh.vertex_matrix(), mesh.face_matrix().astype(np.int64)


class MeshLib:
    def __init__(self):
        import meshlib.mrmeshnumpy as arrays
        import meshlib.mrmeshpy as library

        self.arrays, self.library, self.name = arrays, library, "MeshLib"

    def mesh(self, points, triangles):
        return self.arrays.meshFromFacesVerts(triangles.astype(np.int32), points, duplicateNonManifoldVertices=True)

    def crossing(self, points, triangles):
        mesh = self.mesh(points, triangles)
        if mesh.topology.numValidFaces() != len(triangles):
            return None
        found = self.library.findSelfCollidingTrianglesBS(mesh)
        return {face for face in range(len(triangles)) if found.test(self.library.FaceId(face))}

    def filled(self, points, triangles):
        mesh = self.mesh(points, triangles)
        if mesh.topology.numValidFaces() != len(triangles):
            return None
        for edge in mesh.topology.findHoleRepresentiveEdges():
            parameters = self.library.FillHoleParams()
            parameters.metric = self.library.getUniversalMetric(mesh)
            self.library.fillHole(mesh, edge, parameters)
        return self.arrays.getNumpyVerts(mesh), self.arrays.getNumpyFaces(mesh.topology).astype(np.int64)


if __name__ == "__main__":
    main()
