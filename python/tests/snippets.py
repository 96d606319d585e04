"""Fragments of use, each the body of a typed function whose inputs a fixture makes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import meshmend as mm
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def arrays_in_arrays_out(V: Floats, F: Ints) -> tuple[NDArray[Any], NDArray[Any]]:
    """1: in the types that came in."""
    V2, F2 = mm.mend(V, F)
    return V2, F2


def a_file_and_the_record(folder: Path) -> None:
    """2."""
    r = mm.repair(folder / "broken.stl", orient="outward")
    r.write(folder / "mended.ply")
    print(r)


def a_gate_in_ci(folder: Path) -> None:
    """3."""
    mm.check(folder / "asset.obj").require("non-manifold-edge", "pinched-vertex", closed=True)


def where_is_it_wrong(V_F_pair: tuple[Floats, Ints]) -> tuple[NDArray[np.int32], NDArray[Any]]:
    """4."""
    edges = mm.check(V_F_pair).defects["non-manifold-edge"]
    return edges.vertices, edges.data["degree"]


def carry_values_through(V: Floats, F: Ints, heat: Floats, label: Ints) -> tuple[NDArray[Any], NDArray[Any]]:
    """5: a scalar of each vertex, and a label of each face."""
    r = mm.repair((V, F))
    heat2 = r.vertices.carry(heat)
    label2 = r.faces.carry(label)
    return heat2, label2


def which_vertex_is_this(r: mm.Repair, v: int) -> tuple[int, list[int]]:
    """6: and what became of vertex 17?"""
    return int(r.vertices.old_of_new[v]), r.vertices.all_new_of(17).tolist()


def trimesh_in_trimesh_out(tm: Any) -> Any:
    """7: nothing is merged on the way."""
    tm2 = mm.Mesh.of(tm).repair().mesh.to_trimesh()
    return tm2


def polygons_stay_polygons(poly: Any) -> Any:
    """8."""
    poly2 = mm.Mesh.of(poly).repair(triangulate="off").mesh.to_pyvista()
    return poly2


def quads_and_triangles(V: Floats, quads_and_triangles: Ints, corners: Ints, offsets: Ints) -> tuple[mm.Mesh, mm.Mesh, mm.Mesh]:
    """9: in one table, padded by -1; or lists; or flat and offsets."""
    return (
        mm.Mesh(V, quads_and_triangles, pad=-1),
        mm.Mesh(V, [[0, 1, 2], [0, 2, 3, 4]]),
        mm.Mesh(V, (corners, offsets)),
    )


def bytes_from_anywhere(content: bytes) -> mm.Mesh:
    """10: the name only serves errors and the format."""
    return mm.read(content, name="upload.stl", max_faces=5_000_000)


def a_bar_that_can_be_stopped(folder: Path) -> mm.Repair:
    """11: by Ctrl-C too."""
    return mm.repair(folder / "scan.ply", progress=True)


def policies_as_a_file(folder: Path) -> str:
    """12: shared with the command line."""
    mm.repair(folder / "asset.obj", plan=folder / "print.toml")
    return mm.Plan(weld="0.001%", non_orientable="cut").to_toml()


def many_files_on_this_machine(paths: Sequence[Path]) -> list[dict[str, Any]]:
    """13: threads are enough, the GIL is free."""
    from concurrent.futures import ThreadPoolExecutor

    def told(path: Path) -> dict[str, Any]:
        return mm.check(path, threads=1).to_dict()

    with ThreadPoolExecutor() as pool:
        return list(pool.map(told, paths))


def in_a_notebook(folder: Path) -> mm.Check:
    """14: the last line shows a table and a picture with the defects marked."""
    return mm.check(folder / "bunny.ply")


def a_lake_of_files(plan: Path) -> dict[str, int]:
    """15: one row a file, outputs beside, resumable."""
    from meshmend import fleet

    return fleet.mend(
        "s3://lake/raw/**/*.obj", to="s3://lake/mended/", table="s3://lake/rows/", plan=plan, timeout=120, memory="4GiB"
    )
