"""A check within a bound of memory, against DuckDB: the same counts from SQL, which shares nothing with it.

    against_duckdb.py [FACES]

Meshes are tori on a grid with one face in 509 missing, a third of the others turned, and some repeated: in the order of the grid and in
random order as PLY, and as a soup in STL. `MESHMEND` is the program.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import duckdb
import numpy as np


def torus(faces: int) -> tuple[np.ndarray, np.ndarray]:
    """Positions, and faces with all that is wrong with them."""
    around = int((faces / 4) ** 0.5)
    across = 2 * around
    vertex = np.arange(around * across)
    a, b = vertex // across * (2 * np.pi / around), vertex % across * (2 * np.pi / across)
    points = np.stack([(3 + np.cos(b)) * np.cos(a), (3 + np.cos(b)) * np.sin(a), np.sin(b)], 1).astype("<f4")
    face = np.arange(2 * len(vertex))
    i, j = face // 2 // across, face // 2 % across
    right, up = (j + 1) % across, (i + 1) % around
    corner = i * across + j, i * across + right, up * across + right, up * across + j
    even = (face % 2 == 0)[:, None]
    triangles = np.where(even, np.stack(corner[:3], 1), np.stack([corner[0], corner[2], corner[3]], 1))
    turned = face * 2654435761 % 3 == 0
    triangles[turned] = triangles[turned][:, [0, 2, 1]]
    kept = triangles[face % 509 != 5]
    return points, np.concatenate([kept, kept[::1009], kept[::2003][:, ::-1]]).astype("<i4")


def write_ply(path: Path, points: np.ndarray, faces: np.ndarray) -> None:
    rows = np.empty(len(faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    rows["n"], rows["v"] = 3, faces
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    path.write_bytes(header.encode() + points.tobytes() + rows.tobytes())


def write_stl(path: Path, points: np.ndarray, faces: np.ndarray) -> None:
    rows = np.zeros(len(faces), dtype=[("n", "<f4", 3), ("p", "<f4", (3, 3)), ("a", "<u2")])
    rows["p"] = points[faces]
    path.write_bytes(bytes(80) + np.uint32(len(faces)).tobytes() + rows.tobytes())


def expected(points: np.ndarray, faces: np.ndarray) -> dict[str, object]:
    """The counts, by SQL."""
    db = duckdb.connect()
    db.execute("SET threads = 2")
    # DuckDB finds arrays by the name of what holds them.
    columns = {"f": np.arange(len(faces)), **dict(zip("abc", faces.T.astype(np.int64).copy()))}  # noqa: F841
    db.execute("CREATE TABLE face AS SELECT * FROM columns")
    db.execute(
        """
        CREATE TABLE side AS
        SELECT least(u, v) AS low, greatest(u, v) AS high, u < v AS forward FROM (
            SELECT a AS u, b AS v FROM face UNION ALL SELECT b, c FROM face UNION ALL SELECT c, a FROM face)
        """
    )
    counts = "count(*) AS degree, count(*) FILTER (forward) AS along"
    db.execute(f"CREATE TABLE edge AS SELECT low, high, {counts} FROM side GROUP BY ALL")

    def one(query: str) -> int:
        return db.execute(query).fetchone()[0]

    smallest = "least(a, b, c)"
    # The cycle from its least vertex: the next vertex, then the other; reversed it is the other way round.
    db.execute(
        f"""
        CREATE TABLE cycle AS SELECT f, {smallest} AS v,
            CASE {smallest} WHEN a THEN b WHEN b THEN c ELSE a END AS w,
            CASE {smallest} WHEN a THEN c WHEN b THEN a ELSE b END AS x FROM face
        """
    )
    same = one("SELECT sum(n - 1) FROM (SELECT count(*) AS n FROM cycle GROUP BY v, w, x)")
    opposite = one(
        """
        SELECT count(*) FROM (SELECT v, w, x, min(f) AS f FROM cycle GROUP BY ALL) one
        JOIN (SELECT v, w, x, min(f) AS f FROM cycle GROUP BY ALL) other
        ON one.v = other.v AND one.w = other.x AND one.x = other.w AND other.f < one.f
        """
    )
    corners = "SELECT a AS u FROM face UNION ALL SELECT b FROM face UNION ALL SELECT c FROM face"
    vertices = one(f"SELECT count(DISTINCT u) FROM ({corners})")
    edges = one("SELECT count(*) FROM edge")
    return {
        "vertices": vertices,
        "edges": edges,
        "faces": len(faces),
        "euler_characteristic": vertices - edges + len(faces),
        "boundary_edges": one("SELECT count(*) FROM edge WHERE degree = 1"),
        "interior_edges": one("SELECT count(*) FROM edge WHERE degree = 2"),
        "non_manifold_edges": one("SELECT count(*) FROM edge WHERE degree > 2"),
        "inconsistent_edges": one("SELECT count(*) FROM edge WHERE degree = 2 AND along <> 1"),
        "duplicate_faces": {"same": same, "opposite": opposite},
        "unreferenced_vertices": len(points) - vertices,
    }


def check(path: Path, *options: str) -> dict[str, object]:
    program = os.environ.get("MESHMEND", "meshmend")
    run = subprocess.run([program, "check", "--json", *options, str(path)], capture_output=True, check=False)
    if run.returncode not in (0, 1):
        raise SystemExit(run.stderr.decode())
    return json.loads(run.stdout)


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 300_000
    points, faces = torus(count)
    wanted = expected(points, faces)
    order = np.random.default_rng(7).permutation(len(points)).astype("<i4")
    shuffled = np.empty_like(points)
    shuffled[order] = points
    mixed = order[faces][np.random.default_rng(8).permutation(len(faces))]
    with tempfile.TemporaryDirectory() as folder:
        meshes = {"grid.ply": (points, faces), "random.ply": (shuffled, mixed), "soup.stl": (points, faces)}
        for name, mesh in meshes.items():
            path = Path(folder, name)
            (write_stl if name.endswith("stl") else write_ply)(path, *mesh)
            found = check(path, "--memory", os.environ.get("MEMORY", "48MiB"))
            wrong = {key: (found[key], value) for key, value in wanted.items() if found[key] != value}
            if wrong:
                raise SystemExit(f"{name}: found, and wanted: {wrong}")
            print(f"{name}: {len(wanted)} figures of {len(faces)} faces are those of DuckDB")


if __name__ == "__main__":
    main()
