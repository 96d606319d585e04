"""ADMesh, a program of its own: the whole process is measured, start and all."""

import subprocess

import numpy as np

from meshes import edge_counts

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("bytes", "<u2")])


def version():
    said = subprocess.run(["admesh", "--version"], capture_output=True, text=True, check=True).stdout
    return "ADMesh " + said.split("version")[1].split()[0]


def process(file, scratch):
    path = f"{scratch}/admesh.stl"
    yield
    # Exact welds alone; nothing is removed or filled.
    options = ["--exact", "--normal-directions", f"--write-binary-stl={path}"]
    subprocess.run(["admesh", *options, file], capture_output=True, check=True)
    yield
    corners = np.fromfile(path, FACET, offset=84)["corners"].reshape(-1, 3)
    places, numbers = np.unique(corners, axis=0, return_inverse=True)
    vertices, faces = len(places), len(corners) // 3
    counts = edge_counts(numbers.reshape(-1, 3))
    names = ["inconsistent_edges", "non_manifold_edges"]
    return {"vertices": vertices, "faces": faces} | {name: counts[name] for name in names}


OPERATIONS = {"process-stl": process}
