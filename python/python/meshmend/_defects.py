"""Defects of one kind, as columns."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

Ids = NDArray[np.int32]


class Defects:
    """The defects of one kind, all of them, as columns; row i of each array is one defect.

    Vertices and faces have the numbers that they have as stored, so that they index the arrays that were given. Edge ids are rows
    of `Check.mesh.edges`.
    """

    __slots__ = ("_columns", "_handle")

    def __init__(self) -> None:
        raise TypeError("defects come from Check.defects and from the records of a repair")

    @classmethod
    def _of(cls, handle: Any) -> Defects:
        defects = cls.__new__(cls)
        defects._handle = handle
        defects._columns = None
        return defects

    @property
    def kind(self) -> str:
        """The stable name, as in reports."""
        return str(self._handle.kind)

    @property
    def title(self) -> str:
        """What they are called in a sentence."""
        return str(self._handle.title)

    @property
    def explanation(self) -> str:
        """What it is, why it matters, and what mends it."""
        return str(self._handle.explanation)

    @property
    def severity(self) -> str:
        """`defect` if it fails a check, else `note`."""
        return str(self._handle.severity)

    @property
    def vertices(self) -> Ids:
        """The vertex, or (k, 2) ends of edges; for faces see `faces`."""
        return self._column("vertices")

    @property
    def edges(self) -> Ids:
        """Edge ids; empty for kinds that are no edges."""
        return self._column("edges")

    @property
    def faces(self) -> Ids:
        """Face ids; of a patch, a component or a strip the lowest or first one."""
        return self._column("faces")

    @property
    def data(self) -> Mapping[str, NDArray[Any]]:
        """Further columns, as the kind has them: degree, umbrellas, boundary_only, beside, corners, how and so on."""
        data: Mapping[str, NDArray[Any]] = self._all()["data"]
        return data

    @property
    def strips(self) -> Sequence[Ids]:
        """For `non-orientable-patch`: the closed strip of faces that comes back mirrored."""
        strips: Sequence[Ids] = self._all()["strips"]
        return strips

    def __len__(self) -> int:
        return len(self._handle)

    def __iter__(self) -> Iterator[dict[str, Any]]:
        """The same as the items of the JSON report."""
        items: list[dict[str, Any]] = json.loads(self._handle.items())
        return iter(items)

    def __reduce__(self) -> Any:
        """Pickles as plain columns and items."""
        handle = self._handle
        return _unpickled, ((handle.kind, handle.title, handle.explanation, handle.severity, len(handle)), self._plain())

    def _plain(self) -> tuple[dict[str, Any], str]:
        columns = self._all()
        return {**columns, "data": dict(columns["data"])}, self._handle.items()

    def __repr__(self) -> str:
        return f"<Defects {self.kind}: {len(self)}>"

    def _column(self, name: str) -> Any:
        return self._all()[name]

    def _all(self) -> dict[str, Any]:
        if self._columns is None:
            columns = self._handle.columns()
            data = {name: _fixed(np.asarray(column)) for name, column in columns.pop("data").items()}
            strips = tuple(_fixed(strip) for strip in columns.pop("strips"))
            fixed = {name: _fixed(column) for name, column in columns.items()}
            self._columns: dict[str, Any] | None = {**fixed, "data": MappingProxyType(data), "strips": strips}
        return self._columns or {}


class _Kept:
    """Defects that were pickled, as `_native` has them."""

    def __init__(self, words: tuple[str, str, str, str, int], columns: dict[str, Any], items: str) -> None:
        self.kind, self.title, self.explanation, self.severity, self._count = words
        self._columns = columns
        self._items = items

    def __len__(self) -> int:
        return self._count

    def columns(self) -> dict[str, Any]:
        return dict(self._columns)

    def items(self) -> str:
        return self._items


def _unpickled(words: tuple[str, str, str, str, int], plain: tuple[dict[str, Any], str]) -> Defects:
    return Defects._of(_Kept(words, *plain))


def by_kind(handles: Sequence[Any]) -> Mapping[str, Defects]:
    """Lists of defects by their kinds."""
    return MappingProxyType({handle.kind: Defects._of(handle) for handle in handles})


def _fixed(column: NDArray[Any]) -> NDArray[Any]:
    column.flags.writeable = False
    return column
