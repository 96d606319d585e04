"""Surfaces: the closed paths that generate them, cutting along these, and shapes whose every figure is known."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._files import loaded, write
from ._mesh import Mesh, mesh_as_read
from ._notes import Loss
from ._progress import watched
from ._relation import Relation

Ids = NDArray[np.int32]


class Loop(NamedTuple):
    """A closed path: each vertex is joined to the next, and the last to the first."""

    kind: str
    length: float
    two_sided: bool
    vertices: Ids


class Surface(NamedTuple):
    """A component with its paths. One that is no surface has no name and no paths, and `obstacle` says why."""

    name: str | None
    root: int | None
    system_length: float | None
    loops: Sequence[Loop]
    obstacle: str | None


class Loops(Sequence[Loop]):
    """The closed paths of a mesh's surfaces, component by component. Vertices are those of `mesh`."""

    def __init__(self, handle: Any) -> None:
        self._handle = handle
        self.components: Sequence[Surface] = tuple(_surface(entry) for entry in self.to_dict(None)["components"])
        self._all = tuple(loop for component in self.components for loop in component.loops)

    @property
    def mesh(self) -> Mesh:
        """The mesh in the view in which it was looked at: as stored, or as welded."""
        return mesh_as_read(self._handle.mesh())

    def to_dict(self, limit: int | None = 10_000) -> dict[str, Any]:
        """The document that `meshmend loops --json` prints."""
        document: dict[str, Any] = json.loads(self.to_json(limit))
        return document

    def to_json(self, limit: int | None = 10_000) -> str:
        """The same, byte for byte, without the end of the line."""
        return str(self._handle.json(limit))

    def __getitem__(self, at: Any) -> Any:
        return self._all[at]

    def __len__(self) -> int:
        return len(self._all)

    def __iter__(self) -> Iterator[Loop]:
        return iter(self._all)

    def __str__(self) -> str:
        """What the command line prints."""
        return str(self._handle.text(10_000)).rstrip("\n")

    def __repr__(self) -> str:
        return f"<Loops: {len(self)} in {len(self.components)} components>"


class Cut:
    """A mesh whose surfaces were cut open. Faces and corners are those of before; vertices on the cut are doubled."""

    def __init__(self, handle: Any) -> None:
        self._handle = handle
        self.mesh = mesh_as_read(handle.mesh())
        self.vertices = Relation._of("vertex", *handle.sources())

    @property
    def seams(self) -> Ids:
        """(k, 3, 2): of each edge that was opened its ends before, and after along each of its sides."""
        rows = [[seam["edge"], *seam["sides"]] for seam in self.to_dict(None)["seams"]["items"]]
        return np.array(rows, dtype=np.int32).reshape(-1, 3, 2)

    def to_dict(self, limit: int | None = 10) -> dict[str, Any]:
        """The document that `meshmend cut --json` prints, where nothing is written."""
        document: dict[str, Any] = json.loads(self.to_json(limit))
        return document

    def to_json(self, limit: int | None = 10) -> str:
        """The same, as a text."""
        return str(self._handle.json(limit))

    def write(self, target: Any, **options: Any) -> list[Loss]:
        """Writes the mesh as `meshmend.write` does."""
        return write(self.mesh, target, **options)

    def __str__(self) -> str:
        """What the command line prints."""
        return str(self._handle.text(10)).rstrip("\n")

    def __repr__(self) -> str:
        return f"<Cut: {self.mesh!r}>"


def loops(
    mesh: object,
    *,
    greedy: bool = False,
    root: int | None = None,
    roots: int | None = None,
    hops: bool = False,
    view: str | None = None,
    weld: float | str | None = None,
    kernel: str = "edge-use",
    threads: int | None = None,
    progress: Any = None,
) -> Loops:
    """Generators: handles, cross-caps, holes, as paths of vertices."""
    words = _words(greedy, root, roots, hops, view, weld, kernel)
    given = loaded(mesh, loops)
    with watched(threads, progress) as how:
        return Loops(_native.loops(given._handle, words, how))


def cut(
    mesh: object,
    *,
    along: str = "cut-graph",
    greedy: bool = False,
    root: int | None = None,
    roots: int | None = None,
    hops: bool = False,
    view: str | None = None,
    weld: float | str | None = None,
    threads: int | None = None,
    progress: Any = None,
) -> Cut:
    """Cuts every surface open into a disc, or `along` its `generators`."""
    words = _words(greedy, root, roots, hops, view, weld, "edge-use", along)
    given = loaded(mesh, cut)
    with watched(threads, progress) as how:
        return Cut(_native.cut(given._handle, words, how))


def make(
    shape: str,
    *,
    resolution: int | None = None,
    count: int | None = None,
    genus: int | None = None,
    cross_caps: int | None = None,
    holes: int | None = None,
    refine: int = 0,
    triangles: bool = False,
) -> Mesh:
    """A mesh whose every figure is known, by the names and sizes of `meshmend make --list`."""
    words = {
        "resolution": resolution,
        "count": count,
        "genus": genus,
        "cross_caps": cross_caps,
        "holes": holes,
        "refine": refine,
        "triangles": triangles,
    }
    with watched() as how:
        return mesh_as_read(_native.make(shape, words, how))


def _words(
    greedy: bool,
    root: int | None,
    roots: int | None,
    hops: bool,
    view: str | None,
    weld: float | str | None,
    kernel: str,
    along: str = "cut-graph",
) -> dict[str, Any]:
    return {
        "greedy": greedy,
        "root": root,
        "roots": roots,
        "hops": hops,
        "view": view,
        "weld": None if weld is None else str(weld),
        "kernel": kernel,
        "along": along,
    }


def _surface(entry: dict[str, Any]) -> Surface:
    loops = tuple(_loop(loop) for loop in entry["loops"])
    obstacle = entry["obstacle"]
    return Surface(entry["name"], entry["root"], entry["system_length"], loops, obstacle and obstacle["message"])


def _loop(entry: dict[str, Any]) -> Loop:
    vertices = np.array(entry["vertices"] or [], dtype=np.int32)
    vertices.flags.writeable = False
    return Loop(entry["kind"], entry["length"], entry["two_sided"], vertices)
