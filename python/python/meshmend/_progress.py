"""Who is told of the steps of a call."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Step = Callable[[str, int, int], object]


How = tuple[int | None, Step | None]


@contextmanager
def watched(threads: int | None = None, progress: Step | bool | None = None) -> Iterator[How]:
    """How a call works, for `_native`: on how many threads, and who is told of its steps."""
    if threads is not None and (isinstance(threads, bool) or not isinstance(threads, int)):
        raise TypeError(f"threads is a {type(threads).__name__}: it is a whole number or None")
    if progress is None or progress is False:
        yield threads, None
    elif progress is True:
        with _bar() as step:
            yield threads, step
    elif callable(progress):
        yield threads, progress
    else:
        raise TypeError("progress is True, or a function of (step, done, total)")


@contextmanager
def _bar() -> Iterator[Step | None]:
    """A bar of tqdm if it is there; else a line on a terminal; else nothing."""
    if importlib.util.find_spec("tqdm") is not None:
        from tqdm.auto import tqdm

        with tqdm(total=None, leave=False) as bar:
            yield lambda step, done, total: _move(bar, step, done, total)
    elif sys.stderr.isatty():
        yield _line
        print(file=sys.stderr)
    else:
        yield None


def _move(bar: Any, step: str, done: int, total: int) -> None:
    bar.total = total
    bar.set_description_str(step, refresh=False)
    bar.n = done
    bar.refresh()


def _line(step: str, done: int, total: int) -> None:
    print(f"\r\x1b[K{step} {done}/{total}", end="", file=sys.stderr, flush=True)
