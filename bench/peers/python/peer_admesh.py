"""ADMesh, a program of its own: the whole process is measured, start and all."""

import subprocess

import numpy as np

from meshes import edge_counts


def version():
    said = subprocess.run(["admesh", "--version"], capture_output=True, text=True, check=True).stdout
    return "ADMesh " + said.split("version")[1].split()[0]


def process(file, scratch):
    path = f"{scratch}/admesh.off"
    yield
    # Exact welds alone; nothing is removed or filled.
    options = ["--exact", "--normal-directions", f"--write-off={path}"]
    subprocess.run(["admesh", *options, file], capture_output=True, check=True)
    yield
    with open(path) as rows:
        next(rows)
        vertices, faces, _ = map(int, next(rows).split())
        numbers = np.loadtxt(rows, usecols=(0, 1, 2, 3), skiprows=vertices, max_rows=faces, dtype=np.int64)
    counts = edge_counts(numbers[:, 1:])
    names = ["inconsistent_edges", "non_manifold_edges"]
    return {"vertices": vertices, "faces": faces} | {name: counts[name] for name in names}


OPERATIONS = {"process-stl": process}
