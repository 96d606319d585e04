"""What the tests share: shapes as arrays, the command, and the files of ../shared where they exist."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
SHARED = ROOT.parent / "shared"
EXAMPLES = ROOT / "examples"


@pytest.fixture
def tetrahedron():
    """A closed mesh of four vertices and four faces."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=np.float64)
    return vertices, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


@pytest.fixture
def book():
    """Three triangles on one edge."""
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0], [0.5, 0, 1]])
    return vertices, np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]])


@pytest.fixture
def grid():
    """A plane of many triangles, n squares a side."""

    def make(n):
        x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0), indexing="ij")
        vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
        low = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
        faces = np.concatenate([
            np.stack([low, low + n + 1, low + 1], axis=1),
            np.stack([low + 1, low + n + 1, low + n + 2], axis=1),
        ])
        return vertices, faces

    return make


@pytest.fixture(scope="session")
def command():
    """Runs the command that was built beside the package; skips where there is none."""
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    program = os.environ.get("MESHMEND") or target / "debug" / "meshmend"
    if not Path(program).is_file():
        pytest.skip("the command is not built: cargo build --package meshmend-cli")

    def run(*arguments):
        return subprocess.run([str(program), *map(str, arguments)], capture_output=True, cwd=ROOT)

    return run


def corpus():
    """Each mesh of the corpus; none where there is no ../shared."""
    folder = SHARED / "corpus"
    endings = {".obj", ".ply", ".stl", ".off", ".glb", ".gltf", ".3mf"}
    return sorted(path for path in folder.rglob("*") if path.suffix.lower() in endings) if folder.is_dir() else []
