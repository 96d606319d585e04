"""Words: what they mean, and how many threads work."""

from __future__ import annotations

from . import _native
from ._progress import watched


def explain(code: str) -> str:
    """The page of a kind of defect, a pass, a kernel or a word of topology, as `meshmend explain` prints it."""
    with watched() as how:
        return str(_native.explain(code, how))


def set_threads(count: int | None) -> None:
    """Default of all calls; None: as many as this process may use (affinity, cgroup)."""
    _native.set_threads(count)
