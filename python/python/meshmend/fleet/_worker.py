"""A kept child process that mends file after file, and what is done when it hangs, dies or takes too much memory."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

Row = dict[str, Any]
Answer = tuple[Row, bytes | None]
COMMAND = (sys.executable, "-m", "meshmend.fleet._command")  # As `meshmend-worker`, and `meshmend worker`.
RETRIED = frozenset({"timeout", "memory", "crashed"})
FILES_OF_A_CHILD, FILES_BETWEEN_LOOKS, SECONDS_TO_START, STARTS = 10_000, 100, 60.0, 10


class WorkerError(RuntimeError):
    """A worker does not start, and what it said of it."""


class Worker:
    """A child process that mends files one after another, for a map of one's own: Ray, Dask, Spark, threads.

    Whatever a file does, there is a row of it: a child that takes longer than `timeout` seconds is killed, it has no more memory
    than `memory` (such as "4GiB"), and what ends it is told. Such a file is tried once more, alone in a fresh child. A worker
    can be pickled; each process starts a child of its own. Threads are served one after another.
    """

    def __init__(
        self, *, plan: Any = None, options: Sequence[str] = (), timeout: float | None = None, memory: str | int | None = None,
        reports: bool = False, command: Sequence[str] | None = None,
    ) -> None:
        self._child: _Child | None = None
        self._plan, self._timeout = plan_text(plan), timeout
        self._words = [*(command or COMMAND), *(["--memory", str(memory)] if memory else []), *(["--reports"] if reports else []), *options]
        self.__setstate__({})

    def mend(self, path: str, output: str | None = None, *, name: str | None = None, format: str | None = None) -> Row:
        """The row of a file that is mended into another one, or only judged without `output`."""
        return self.run(os.fspath(path), output and os.fspath(output), name=name, format=format)[0]

    def run(self, source: str | bytes, output: str | bool | None = None, *, name: str | None = None, format: str | None = None) -> Answer:
        """The row of a file, by path or as bytes; and the bytes of the result, if `output` is True and there is one."""
        data = source if isinstance(source, bytes) else b""
        told, called = ({"path": source}, source) if isinstance(source, str) else ({"bytes": len(data)}, "bytes")
        job = _to({"id": 1, "name": name or called, "input": told}, output, format)
        with self._lock:
            answer = self._tried(job, data)
            if answer[0]["status"] in RETRIED:
                self.close()
                answer = self._tried(job, data)
                answer[0]["attempts"] = 2
                self.close()
        return answer

    def template(self, name: str, output: str | bool | None = None, format: str | None = None) -> Row:
        """The row of a file of this name on which nothing was done: it has the digest of the policy."""
        kind = (os.path.splitext(name)[1], os.path.splitext(output)[1] if isinstance(output, str) else output, format)
        job = _to({"id": 0, "name": name, "input": {"bytes": 0}}, output, format)
        for _ in range(STARTS):
            child = self._kept()
            if kind not in child.templates:  # No bytes are no file of any format: nothing is done.
                child.templates[kind] = child.ask(job, b"", SECONDS_TO_START)
            row = (child.templates[kind] or (child.ended(),))[0]
            if row.get("plan_digest"):
                return {**row, "path": name, "size": None, "input_sha256": None, "line": None, "byte": None}
            self.close()
            if not row["signal"]:
                break
        raise WorkerError(row["message"])

    def close(self) -> None:
        """Ends the child; the next file starts another one."""
        child, self._child = self._child, None
        if child and child.owner == os.getpid():
            child.close()

    def _tried(self, job: Row, data: bytes) -> Answer:
        row = self.template(job["name"], next(iter(job.get("output", {"": None}).values())), job.get("format"))
        child, begin = self._kept(), time.monotonic()
        answer = child.ask(job, data, self._timeout)
        if answer is None:
            row |= {**child.ended(), "size": len(data) or None, "seconds": time.monotonic() - begin, "cpu_seconds": None, "peak_bytes": None}
            if child.is_late:
                row |= {"status": "timeout", "signal": None, "message": f"it took longer than {self._timeout:g} s"}
        if answer is None or child.is_late or child.is_worn():
            self.close()
        return answer or (row, None)

    def _kept(self) -> _Child:
        if not self._child or self._child.owner != os.getpid():  # After a fork, the child is the parent's.
            self._child = _Child(self._words, self._plan)
        return self._child

    def __getstate__(self) -> Row:
        return {name: self.__dict__[name] for name in ("_plan", "_timeout", "_words")}

    def __setstate__(self, state: Row) -> None:
        self.__dict__.update(state, _child=None, _lock=threading.Lock())

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    __del__ = close


class _Child:
    def __init__(self, words: list[str], plan: str | None) -> None:
        self.owner, self.is_late, self.files, self.plateau = os.getpid(), False, 0, 0
        self.templates: dict[object, Answer | None] = {}
        self.errors = tempfile.TemporaryFile()
        with tempfile.TemporaryFile() as file:
            file.write((plan or "").encode())
            file.seek(0)
            words = words if plan is None else [*words, "--plan", f"/dev/fd/{file.fileno()}"]
            # In a session of its own: Ctrl-C is for who started it, and the whole of it can be killed.
            self.process = subprocess.Popen(
                words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors, start_new_session=True, pass_fds=[file.fileno()]
            )

    def ask(self, job: Row, data: bytes, timeout: float | None) -> Answer | None:
        """The answer to a job; None if the child has died, or was late and is killed."""
        timer = threading.Timer(threading.TIMEOUT_MAX if timeout is None else timeout, self.stop_late)
        timer.daemon = True
        timer.start()
        try:
            self.process.stdin.write(json.dumps(job, ensure_ascii=False).encode() + b"\n" + data)
            self.process.stdin.flush()
            answer = json.loads(self.process.stdout.readline())
            back = self.process.stdout.read(answer["bytes"]) if "bytes" in answer else None
            return (answer["row"], back) if len(back or b"") == answer.get("bytes", 0) else None
        except (OSError, json.JSONDecodeError):
            return None
        finally:
            self.files += 1
            timer.cancel()
            timer.join()

    def stop_late(self) -> None:
        self.is_late = True
        self.kill()

    def kill(self) -> None:
        if self.process.poll() is None:
            os.killpg(self.process.pid, signal.SIGKILL)

    def ended(self) -> Row:
        """How the child ended, as a row says it."""
        try:
            code = self.process.wait(5)
        except subprocess.TimeoutExpired:
            self.kill()
            code = self.process.wait()
        self.errors.seek(max(0, self.errors.seek(0, os.SEEK_END) - (64 << 10)))
        said = self.errors.read().decode(errors="replace").partition("\nstack backtrace:")[0].strip()
        message = f"the worker ended by signal {-code}" if code < 0 else f"the worker ended with status {code}"
        is_short = "memory allocation of" in said or "Cannot allocate memory" in said
        status = "memory" if code == -signal.SIGABRT and is_short else "crashed"
        return {"status": status, "signal": max(-code, 0) or None, "message": f"{message}: {said}".encode()[:500].decode(errors="ignore") if said else message}

    def is_worn(self) -> bool:
        """Whether another one should take its place: after many files, or when its memory has doubled."""
        if self.files % FILES_BETWEEN_LOOKS:
            return False
        resident = int(Path(f"/proc/{self.process.pid}/statm").read_text().split()[1]) if sys.platform == "linux" else 0
        self.plateau = self.plateau or resident
        return self.files >= FILES_OF_A_CHILD or resident > 2 * self.plateau

    def close(self) -> None:
        try:
            self.process.stdin.close()
            self.process.wait(1)
        except (OSError, subprocess.TimeoutExpired):
            self.kill()
            self.process.wait()
        self.process.stdout.close()
        self.errors.close()


def plan_text(plan: Any) -> str | None:
    """The TOML of a plan: of a `meshmend.Plan`, or of a file."""
    if plan is None or hasattr(plan, "to_toml"):
        return plan and plan.to_toml()
    return Path(plan).read_text(encoding="utf-8")


def _to(job: Row, output: str | bool | None, format: str | None) -> Row:
    asked = {"output": {"bytes": True} if output is True else {"path": output}} if output else {}
    return {**job, **asked, **({"format": format} if format else {})}
