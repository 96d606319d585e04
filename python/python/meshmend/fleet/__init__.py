"""Many files: on this machine, on a cluster, in object stores; and the worker for a map of one's own.

`mend` and `check` need the extra `meshmend[fleet]` (daft, pyarrow); `Worker` needs nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._worker import Worker, WorkerError

if TYPE_CHECKING:
    from ._jobs import check, mend
    from ._table import SCHEMA, compact, read_table, summary

__all__ = ["SCHEMA", "Worker", "WorkerError", "check", "compact", "mend", "read_table", "summary"]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import _jobs, _table

    return getattr(_jobs if hasattr(_jobs, name) else _table, name)
