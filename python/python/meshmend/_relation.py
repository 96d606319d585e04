"""Which elements before a repair are which after it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Ids = NDArray[np.int32]


class Relation:
    """Which elements before are which after, both ways. -1 stands for none."""

    __slots__ = ("_before", "_cache", "_further", "_old_of_new", "_what")

    def __init__(self) -> None:
        raise TypeError("a relation comes from a repair")

    @classmethod
    def _of(cls, what: str, old_of_new: Ids, before: int, further: Callable[[], NDArray[np.int64]] | None = None) -> Relation:
        """The relation by old elements of new ones; `further` gives pairs (old, new) that are not among these."""
        relation = cls.__new__(cls)
        relation._what = what
        relation._old_of_new = _fixed(old_of_new)
        relation._before = before
        relation._further = further
        relation._cache = {}
        return relation

    @property
    def old_of_new(self) -> Ids:
        """For each new element the old one; -1 where it was created."""
        return self._old_of_new

    @property
    def new_of_old(self) -> Ids:
        """For each old element the first new one; -1 where nothing is left of it."""
        return self._once("new_of_old", self._first)

    @property
    def pairs(self) -> Ids:
        """(k, 2) pairs (old, new), sorted; vertices that were welded are all in it."""
        return self._once("pairs", self._paired)

    @property
    def removed(self) -> Ids:
        """Old elements of which nothing is left."""
        return self._once("removed", lambda: np.flatnonzero(self.new_of_old < 0).astype(np.int32))

    @property
    def created(self) -> Ids:
        """New elements that were none before."""
        return self._once("created", lambda: np.flatnonzero(self._old_of_new < 0).astype(np.int32))

    def all_new_of(self, old: int) -> Ids:
        """Every new element that an old one became (a split vertex, a cut face)."""
        if not 0 <= old < self._before:
            raise IndexError(f"there is no {self._what} {old}: there were {self._before}")
        first, last = np.searchsorted(self.pairs[:, 0], [old, old + 1])
        return self.pairs[first:last, 1]

    def carry(self, values: ArrayLike, fill: Any = None) -> NDArray[Any]:
        """Values of each element before as values of each after. Created ones get `fill`; without it NaN if that fits."""
        before = np.asarray(values)
        if before.ndim == 0 or len(before) != self._before:
            count = "one value" if before.ndim == 0 else f"{len(before)} values"
            raise ValueError(f"{count}: there were {self._before} of kind {self._what}")
        is_created = self._old_of_new < 0
        if not is_created.any():
            return before[self._old_of_new]
        if fill is None:
            if not (np.issubdtype(before.dtype, np.inexact) or before.dtype == object):
                created = int(is_created.sum())
                raise ValueError(f"{created} were created, and {before.dtype} has no word for none: say `fill`")
            fill = None if before.dtype == object else np.nan
        after = np.empty((len(self._old_of_new), *before.shape[1:]), dtype=before.dtype)
        after[~is_created] = before[self._old_of_new[~is_created]]
        after[is_created] = fill
        return after

    def __repr__(self) -> str:
        return f"<Relation of {self._what}: {self._before} before, {len(self._old_of_new)} after>"

    def _first(self) -> Ids:
        first = np.full(self._before, -1, dtype=np.int32)
        # Of several writes to one place the last holds: that of the lowest new element.
        first[self.pairs[::-1, 0]] = self.pairs[::-1, 1]
        return first

    def _paired(self) -> Ids:
        new = np.flatnonzero(self._old_of_new >= 0)
        rows = np.stack([self._old_of_new[new].astype(np.int64), new], axis=1)
        if self._further is not None:
            rows = np.concatenate([rows, self._further()])
        after = max(len(self._old_of_new), 1)
        keys = np.unique(rows[:, 0] * after + rows[:, 1])
        return np.stack([keys // after, keys % after], axis=1).astype(np.int32)

    def _once(self, name: str, make: Callable[[], Ids]) -> Ids:
        if name not in self._cache:
            self._cache.setdefault(name, _fixed(make()))
        found: Ids = self._cache[name]
        return found


def by_corners(old_of_new: Ids, before: Ids, after: Ids) -> NDArray[np.int64]:
    """Pairs of vertices (old, new) that are at the same corner; `before` and `after` are the vertices of corners."""
    new = np.flatnonzero(old_of_new >= 0)
    return np.stack([before[old_of_new[new]], after[new]], axis=1).astype(np.int64)


def _fixed(array: Ids) -> Ids:
    array.flags.writeable = False
    return array
