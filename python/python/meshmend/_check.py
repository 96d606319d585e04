"""What a mesh is, and what is wrong with it."""

from __future__ import annotations

import difflib
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from . import _native
from ._defects import Defects
from ._document import Document
from ._errors import DefectError
from ._files import loaded
from ._mesh import Mesh, mesh_with
from ._notes import Note
from ._progress import watched

_REGISTRIES: dict[str, Any] = _native.registries()


class Betti(NamedTuple):
    """Betti numbers over the field of two elements, and over the rationals."""

    z2: tuple[int, int, int] | None
    q: tuple[int, int, int] | None


def _figure(key: str) -> property:
    """A key of the JSON report, as an attribute."""
    return property(lambda check: check._facts()[key], doc=f"`{key}` of the JSON report.")


class Check:
    """What a mesh is and what is wrong with it. Every key of the JSON report is an attribute of that name.

    Vertices and faces have the numbers that they have as stored, also in a welded view. Edge ids are rows of `mesh.edges`.
    """

    __slots__ = ("_found", "_handle", "_known", "_mesh")

    def __init__(self) -> None:
        raise TypeError("a check comes from meshmend.check")

    @classmethod
    def _of(cls, handle: Any) -> Check:
        check = cls.__new__(cls)
        check._handle = handle
        check._known = None
        check._found = None
        check._mesh = None
        return check

    @property
    def mesh(self) -> Mesh:
        """The mesh in the view of the check: as stored, or as welded."""
        if self._mesh is None:
            handle = self._handle.mesh()
            self._mesh: Mesh | None = mesh_with(handle, self.notes, handle.variant())
        return self._mesh  # type: ignore[return-value]

    @property
    def betti(self) -> Betti:
        """Betti numbers; None over a field where they were not found."""
        found = self._facts()["betti"]
        of = {field: None if found[field] is None else tuple(found[field]) for field in ("z2", "q")}
        return Betti(of["z2"], of["q"])

    @property
    def undefined(self) -> Mapping[str, str]:
        """Of each figure that the mesh does not have, the reason."""
        return {row["figure"]: row["reason"] for row in self._facts()["undefined"]}

    @property
    def kernels(self) -> Mapping[str, Mapping[str, int]]:
        """For each kernel how many defects of each kind it does not admit; none if it holds the mesh."""
        return {row["name"]: row["refusals"] for row in self._facts()["kernels"]}

    @property
    def component_kinds(self) -> Sequence[Mapping[str, Any]]:
        """What the components are, how many of each, as in the JSON report; all kinds."""
        kinds: Sequence[Mapping[str, Any]] = self.to_dict(self._facts()["component_kinds_total"])["component_kinds"]
        return kinds

    @property
    def geometry(self) -> Mapping[str, Any] | None:
        """Where the faces lie, as in the JSON report, if that was asked; its lists are cut."""
        geometry: Mapping[str, Any] | None = self._facts().get("geometry")
        return geometry

    @property
    def notes(self) -> Sequence[Note]:
        """What the reader had to say about the file."""
        return tuple(Note.of(note) for note in self._facts()["notes"])

    @property
    def is_sound(self) -> bool:
        """No defect but notes. Deliberately no `__bool__`: `if check:` raises TypeError."""
        return bool(self._handle.is_sound())

    @property
    def defects(self) -> Mapping[str, Defects]:
        """All kinds that were looked for; those that do not occur are empty. Kinds about where faces lie need `geometry`."""
        if self._found is None:
            self._found: _ByKind | None = _ByKind(self._handle)
        return self._found  # type: ignore[return-value]

    def counts(self) -> dict[str, int]:
        """Only the kinds that occur."""
        return dict(self._handle.counts())

    def to_dict(self, limit: int | None = 10) -> dict[str, Any]:
        """The document that `meshmend check --json` prints."""
        document: dict[str, Any] = json.loads(self.to_json(limit))
        return document

    def to_json(self, limit: int | None = 10) -> str:
        """The same, byte for byte, without the end of the line. Lists are cut to `limit`; None cuts nothing."""
        return str(self._handle.json(limit))

    def require(self, *kinds: str, **figures: object) -> Check:
        """Raises `DefectError` if a kind occurs or a figure differs; for asserts in pipelines."""
        wrong = []
        for kind in kinds:
            found = self.defects[kind] if kind in self.defects else _asked(kind)
            if len(found):
                first = next(iter(found))["message"]
                wrong.append(f"{found.title}: {len(found)}, the first: {first}")
        facts = self._facts()
        for name, expected in figures.items():
            if name not in facts:
                raise TypeError(f"require() has no figure `{name}`{_nearest(name, facts)}")
            if facts[name] != expected:
                wrong.append(f"{name} is {facts[name]!r}, not {expected!r}")
        if wrong:
            name = facts["file"] or "the mesh"
            raise DefectError(f"{name}: {'; '.join(wrong)}", self)
        return self

    def __bool__(self) -> bool:
        raise TypeError("a Check is neither true nor false: ask `is_sound`, or a figure such as `manifold`")

    def __str__(self) -> str:
        return str(self._handle.text(10)).rstrip("\n")

    def __repr__(self) -> str:
        facts = self._facts()
        return f"<Check of {facts['file'] or 'a mesh'}: {'sound' if self.is_sound else 'not sound'}, {len(self.counts())} kinds>"

    def _repr_html_(self) -> str:
        from . import _html

        return _html.of_check(self)

    def _facts(self) -> dict[str, Any]:
        if self._known is None:
            self._known: dict[str, Any] | None = self.to_dict(0)
        return self._known or {}


# The keys whose attributes are not plain values have properties of their own.
FIGURES = (
    "schema file format view weld stored witness vertices edges faces components patches component_kinds_total "
    "euler_characteristic boundary_edges boundary_loops interior_edges inconsistent_edges non_manifold_edges "
    "non_manifold_vertices non_orientable_patches non_simple_faces repeated_corner_faces degenerate_faces duplicate_faces "
    "unreferenced_vertices non_finite_vertices loose_edges loose_points joined_in_single apart_in_pose instigators betti_unknown "
    "genus cross_caps manifold closed orientable consistently_oriented"
).split()
for _name in FIGURES:
    setattr(Check, _name, _figure(_name))


class _ByKind(Mapping[str, Defects]):
    """The defects of each kind that was looked for."""

    def __init__(self, handle: Any) -> None:
        lists = ((kind, handle.defects(kind)) for kind in _REGISTRIES["kinds"])
        self._found = {kind: Defects._of(found) for kind, found in lists if found is not None}

    def __getitem__(self, kind: str) -> Defects:
        return self._found[kind] if kind in self._found else _asked(kind)

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __contains__(self, kind: object) -> bool:
        return kind in self._found

    def __repr__(self) -> str:
        return repr(self._found)


def _asked(kind: str) -> Defects:
    """There is no answer about a kind."""
    if kind in _REGISTRIES["kinds"]:
        raise KeyError(f"{kind} was not looked for: ask for it by `geometry=True`, or it is of those that only a repair finds")
    raise KeyError(f"there is no kind `{kind}`{_nearest(kind, _REGISTRIES['kinds'])}")


def _nearest(word: str, known: Iterable[str]) -> str:
    near = difflib.get_close_matches(word, list(known), 1)
    return f"; did you mean `{near[0]}`?" if near else ""


class DocumentCheck(Mapping[str, Check]):
    """A check of each part of a file, by its title; parts that can't be read are left out here, and named in the report."""

    def __init__(self, document: Document, checks: Sequence[tuple[int, Check | None]]) -> None:
        self.document = document
        self._checks = tuple(checks)
        parts = document.parts
        self._by_title = MappingProxyType({parts[number].title: check for number, check in checks if check is not None})

    @property
    def is_sound(self) -> bool:
        """Whether each part is."""
        return all(check.is_sound for check in self.values())

    def to_dict(self, limit: int | None = 10) -> dict[str, Any]:
        """The document that `meshmend check --json` prints."""
        document: dict[str, Any] = json.loads(self.to_json(limit))
        return document

    def to_json(self, limit: int | None = 10) -> str:
        """The same, byte for byte, without the end of the line."""
        if len(self._checks) == 1 and self._checks[0][1] is not None:
            return self._checks[0][1].to_json(limit)
        handles = [(number, None if check is None else check._handle) for number, check in self._checks]
        return str(_native.parts_json(self.document._handle, handles, limit))

    def __getitem__(self, title: str) -> Check:
        return self._by_title[title]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_title)

    def __len__(self) -> int:
        return len(self._by_title)

    def __bool__(self) -> bool:
        raise TypeError("a DocumentCheck is neither true nor false: ask `is_sound`")

    def __str__(self) -> str:
        return "\n\n".join(str(check) for check in self.values())


def check(
    mesh: object,
    *,
    view: str | None = None,
    weld: float | str | None = None,
    kernel: str = "edge-use",
    witness: str = "breadth-first",
    geometry: bool | str | Sequence[str] = False,
    near: float | str = "exact",
    pair_budget: int | None = None,
    fail_on: Sequence[str] = (),
    threads: int | None = None,
    progress: Any = None,
) -> Check:
    """Changes nothing. A mesh is judged as stored; STL, which has no indices, as welded exactly."""
    words = {
        "view": view,
        "weld": None if weld is None else str(weld),
        "kernel": kernel,
        "witness": witness,
        "geometry": geometry_words(geometry, near, pair_budget),
        "fail_on": list(fail_on),
    }
    given = loaded(mesh, check)
    with watched(threads, progress) as how:
        return Check._of(_native.check(given._handle, words, how))


def check_document(document: Document, parts: Sequence[str | int] | None, options: Mapping[str, Any]) -> DocumentCheck:
    """Each part by itself."""
    checks = [(part.number, None if part.sealed is not None else check(part.mesh, **options)) for part in document._chosen(parts)]
    return DocumentCheck(document, checks)


def geometry_words(geometry: bool | str | Sequence[str], near: float | str, pair_budget: int | None) -> dict[str, Any]:
    """What is asked about where the faces lie, for `_native`."""
    questions: list[str] | None
    if geometry is False or geometry is None:
        questions = None
    elif geometry is True:
        questions = []
    else:
        questions = geometry.split(",") if isinstance(geometry, str) else list(geometry)
        questions = questions or None
    return {"questions": questions, "near": str(near), "pair_budget": pair_budget}
