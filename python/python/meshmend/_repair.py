"""Mending, and the record of all that was done."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._check import Check, geometry_words
from ._defects import Defects, by_kind
from ._document import Document
from ._errors import DefectError
from ._files import read_document, is_file, warned, write_words
from ._mesh import Mesh, corners_of, mesh_as_read
from ._notes import Loss
from ._plan import Plan, said, text_of
from ._progress import watched
from ._relation import Relation, by_corners

Ids = NDArray[np.int32]


class PassRecord(NamedTuple):
    """What one pass did. What it mended has ids of the mesh before the pass, what it left ids of the mesh after it."""

    name: str
    changed: bool
    mended: Mapping[str, Defects]
    left: Mapping[str, Defects]
    delta: Mapping[str, int | None]


class Removed(NamedTuple):
    """The faces of which nothing is left, the pass that removed each, and why."""

    faces: Ids
    passes: Sequence[str]
    reasons: Sequence[str]


class Repair:
    """A mended mesh and the record of all that was done.

    Of a file of several parts, each is a repair of its own in `parts`, and the whole file is `document`.
    """

    __slots__ = ("_cache", "_handle", "_number", "_seams", "_source")

    def __init__(self) -> None:
        raise TypeError("a repair comes from meshmend.repair")

    @classmethod
    def _of(cls, handle: Any, source: Mesh | Document, number: int | None = None) -> Repair:
        repair = cls.__new__(cls)
        repair._handle = handle
        repair._source = source
        repair._number = number
        repair._seams = None
        repair._cache = {}
        return repair

    @property
    def mesh(self) -> Mesh:
        """The mesh as it is now."""
        return self._once("mesh", lambda: mesh_as_read(self._record().mesh()))

    @property
    def parts(self) -> Mapping[str, Repair]:
        """The repair of each part that was repaired, by its title; none of what is one mesh."""
        return self._once("parts", self._parts)

    @property
    def kept(self) -> Mapping[str, str]:
        """The parts that are as they were, by title, and why."""
        outcomes = self._outcomes()
        return MappingProxyType({title: reason for _, title, reason in outcomes if reason is not None})

    @property
    def document(self) -> Document | None:
        """The file as it is now, where its parts were repaired each by itself."""
        handle = self._handle.document() if self._number is None else None
        return None if handle is None else Document._of(handle)

    @property
    def before(self) -> Check | None:
        """What the mesh was, unless `report=False`."""
        return self._once("before", lambda: _check(self._record().before()))

    @property
    def after(self) -> Check | None:
        """What the mesh is, unless `report=False`."""
        return self._once("after", lambda: _check(self._record().after()))

    @property
    def passes(self) -> Sequence[PassRecord]:
        """What each pass did, in order."""
        return self._once("passes", lambda: tuple(_pass(record) for record in self._record().passes()))

    @property
    def vertices(self) -> Relation:
        """Which vertices before are which now."""
        return self._once("vertices", self._of_vertices)

    @property
    def faces(self) -> Relation:
        """Which faces before are which now."""
        return self._once("faces", lambda: Relation._of("face", *self._record().sources("faces")))

    @property
    def corners(self) -> Relation:
        """Which corners before are which now."""
        return self._once("corners", lambda: Relation._of("corner", *self._record().sources("corners")))

    @property
    def flipped(self) -> Ids:
        """The faces that run the other way round than before."""
        return self._once("flipped", lambda: _fixed(self._record().flipped()))

    @property
    def removed_faces(self) -> Removed:
        """The faces of which nothing is left, and why."""
        return self._once("removed_faces", self._removed)

    @property
    def changed(self) -> bool:
        """Whether anything differs from what was given."""
        return bool(self._handle.is_changed() if self._number is None else self._record().is_changed())

    @property
    def failing(self) -> Mapping[str, int]:
        """What of `fail_on` is there, and how much."""
        return MappingProxyType(dict(self._handle.failing()))

    def to_dict(self, limit: int | None = 10, maps: bool = False) -> dict[str, Any]:
        """The document of `meshmend repair --json`; with `maps` that of `--report-maps`."""
        document: dict[str, Any] = json.loads(self.to_json(limit, maps))
        return document

    def to_json(self, limit: int | None = 10, maps: bool = False) -> str:
        """The same, byte for byte, without the end of the line. Lists are cut to `limit`; None cuts nothing."""
        return str(self._handle.json(limit, maps) if self._number is None else self._record().json(limit, maps))

    def write(self, target: Any, **options: Any) -> list[Loss]:
        """Writes the mesh as `meshmend.write` does; into the whole of its file, if that holds more and has the same format."""
        from ._files import write

        document = self.document
        seams = {} if self._seams is None else {"seams": self._seams}
        return write(self.mesh if document is None else document, target, **{**seams, **options})

    def __str__(self) -> str:
        """What the command line prints."""
        return str(self._handle.text() if self._number is None else self._record().text()).rstrip("\n")

    def __repr__(self) -> str:
        state = "changed" if self.changed else "unchanged"
        return f"<Repair of {len(self.parts)} parts: {state}>" if self._is_of_parts() else f"<Repair: {state}, {self.mesh!r}>"

    def _repr_html_(self) -> str:
        from . import _html

        return _html.of_repair(self)

    def _outcomes(self) -> list[tuple[int, str, str | None]]:
        return (self._handle.outcomes() or []) if self._number is None else []

    def _is_of_parts(self) -> bool:
        return self._number is None and self._handle.outcomes() is not None and not isinstance(self._source, Mesh)

    def _parts(self) -> Mapping[str, Repair]:
        if not self._is_of_parts():
            return MappingProxyType({})
        outcomes = enumerate(self._outcomes())
        mended = {title: at for at, (_, title, reason) in outcomes if reason is None}
        return MappingProxyType({title: Repair._of(self._handle, self._source, at) for title, at in mended.items()})

    def _record(self) -> Any:
        """What is known of the only mesh."""
        number = self._number
        if number is None:
            repaired = [at for at, (_, _, reason) in enumerate(self._outcomes()) if reason is None]
            if self._is_of_parts() and len(repaired) != 1:
                titles = ", ".join(title for _, title, _ in self._outcomes()[:8])
                raise ValueError(f"the file has {len(repaired)} parts that were repaired ({titles}): ask one of `parts`")
            number = repaired[0] if repaired else 0
        return self._once("record", lambda: self._handle.record(number))

    def _of_vertices(self) -> Relation:
        record = self._record()
        corners, _ = record.sources("corners")

        def further() -> NDArray[np.int64]:
            return by_corners(corners, corners_of(record.stored()), self.mesh.corners)

        return Relation._of("vertex", *record.sources("vertices"), further)

    def _removed(self) -> Removed:
        faces, passes, reasons = self._record().removed()
        return Removed(_fixed(faces), tuple(passes), tuple(reasons))

    def _once(self, name: str, make: Any) -> Any:
        if name not in self._cache:
            self._cache.setdefault(name, make())
        return self._cache[name]


def repair(
    mesh: object,
    *,
    plan: Plan | str | os.PathLike[str] | None = None,
    preset: str | None = None,
    report: bool = True,
    kernel: str = "edge-use",
    allow_empty: bool = False,
    geometry: bool | str | Sequence[str] = False,
    near: float | str = "exact",
    pair_budget: int | None = None,
    parts: Sequence[str | int] = (),
    by: str | None = None,
    fail_on: Sequence[str] = (),
    strict: bool = False,
    output: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    progress: Any = None,
    **policies: Any,
) -> Repair:
    """Mends what is wrong with a mesh, and names all that it did. The keywords are the options of `meshmend repair`.

    With `output` it is mended for the file that it will be written to, as on the command line: what that can't hold, such as
    polygons, digits or shared vertices, is known to the passes, and the report says what is lost.
    What `fail_on` names, such as kinds of defect, `removed`, `changed` or `left`, is in `Repair.failing`; with `strict` it raises.
    """
    given = _planned(plan, preset)
    words = {
        "plan": None if given is None else given._handle,
        "is_planned": plan is not None,
        "said": said("repair", policies),
        "allow_empty": allow_empty,
        "kernel": kernel,
        "geometry": geometry_words(geometry, near, pair_budget),
        "report": report,
        "parts": [str(part) for part in parts],
        "by": by,
        "fail_on": list(fail_on),
        "output": None if output is None else (os.fspath(output), write_words()),
    }
    with watched(threads, progress) as how:
        source = _source(mesh, is_whole=bool(parts) or by is not None, how=how)
        work = _native.repair_document if isinstance(source, Document) else _native.repair_mesh
        mended = Repair._of(work(source._handle, words, how), source)
        mended._seams = None if given is None else given._handle.seams()
    if strict and mended.failing:
        told = ", ".join(f"{word}: {count}" for word, count in mended.failing.items())
        raise DefectError(f"the repair has {told}", None if mended._is_of_parts() else mended.after)
    return mended


def mend(vertices: ArrayLike, faces: Any, **policies: Any) -> tuple[NDArray[Any], Any]:
    """Arrays in, arrays out, in the types that came in. The keywords are those of `repair`."""
    mended = repair(Mesh(vertices, faces), report=False, **policies)
    record = mended._record()
    # Of the handle: its arrays are made for who asks, and are nobody else's.
    handle = record.mesh()
    points = _of_type(handle.vertices(), np.asarray(vertices).dtype, record)
    if isinstance(faces, tuple) and len(faces) == 2:
        corners, offsets = (np.asarray(array).dtype for array in faces)
        return points, (_corners_of_type(handle, corners), _ids_of_type(handle.offsets(), offsets))
    if not handle.is_triangles():
        return points, _ids_of_type(np.array(mended.mesh.faces), _row_type(faces))
    return points, _corners_of_type(handle, _row_type(faces)).reshape(-1, 3)


def _planned(plan: Plan | str | os.PathLike[str] | None, preset: str | None) -> Plan | None:
    """The plan of a file or a preset, or of a file over a preset."""
    if preset is None:
        return plan if plan is None or isinstance(plan, Plan) else Plan.read(plan)
    if isinstance(plan, Plan):
        raise ValueError("a whole plan leaves nothing of a preset: give the path of a plan file, or keywords")
    return Plan.preset(preset, None if plan is None else text_of(plan))


def _source(mesh: object, is_whole: bool, how: Any) -> Mesh | Document:
    """A mesh, or a file whose parts are repaired each by itself."""
    if isinstance(mesh, (Mesh, Document)):
        found: Mesh | Document = mesh
    elif is_file(mesh):
        document = read_document(mesh, threads=how[0], progress=how[1])
        is_one = len(document.parts) == 1 and document.parts[0].sealed is None and not is_whole
        found = document.parts[0].mesh if is_one else document
    else:
        found = Mesh.of(mesh)
    if is_whole and isinstance(found, Mesh):
        raise ValueError("`parts` and `by` are about a file: give its path, or what `read_document` gives")
    return found


def _check(handle: Any) -> Check | None:
    return None if handle is None else Check._of(handle)


def _pass(record: Any) -> PassRecord:
    name, changed, mended, left, delta = record
    figures = ("euler_characteristic", "components", "boundary_loops")
    changes = MappingProxyType({} if delta is None else dict(zip(figures, delta)))
    return PassRecord(name, changed, by_kind(mended), by_kind(left), changes)


def _of_type(points: NDArray[np.float64], wanted: np.dtype[Any], record: Any) -> NDArray[Any]:
    """Positions in the type that came in. Only those of created vertices can be rounded by it."""
    if not np.issubdtype(wanted, np.floating):
        whole = points.astype(wanted) if np.issubdtype(wanted, np.integer) and np.isfinite(points).all() else points
        return np.array(whole if np.array_equal(whole, points) else points)
    if wanted == points.dtype:
        return points
    given, is_created = points.astype(wanted), record.sources("vertices")[0] < 0
    rounded = int((given[is_created].astype(np.float64) != points[is_created]).any(axis=1).sum())
    if rounded:
        message = f"the positions of {rounded} created vertices are rounded to {wanted}"
        warned("vertices", [Loss("precision", rounded, message)])
    return given


def _corners_of_type(handle: Any, wanted: np.dtype[Any]) -> NDArray[Any]:
    return corners_of(handle, np.int64) if wanted == np.int64 else _ids_of_type(corners_of(handle), wanted)


def _ids_of_type(ids: Ids, wanted: np.dtype[Any]) -> NDArray[Any]:
    """Ids in the type that came in, or in a wider one where they don't fit."""
    if np.can_cast(ids.dtype, wanted) or len(ids) == 0 or int(ids.max()) <= np.iinfo(wanted).max:
        return ids.astype(wanted, copy=False)
    wider = np.result_type(wanted, np.min_scalar_type(int(ids.max())))
    warned("faces", [Loss("integers", 1, f"{wanted} is too narrow for {int(ids.max()) + 1} ids: they are {wider}")])
    return ids.astype(wider)


def _row_type(faces: Any) -> np.dtype[Any]:
    """The type of a table of faces; int32 for lists."""
    return faces.dtype if isinstance(faces, np.ndarray) and np.issubdtype(faces.dtype, np.integer) else np.dtype(np.int32)


def _fixed(array: Ids) -> Ids:
    array.flags.writeable = False
    return array
