"""A kept child process that answers job after job, and how it ended when it hangs, dies or takes too much memory."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

Row = dict[str, Any]
Answer = tuple[Row, bytes | None]
FILES_OF_A_CHILD, FILES_BETWEEN_LOOKS = 10_000, 100


def short(text: object) -> str:
    """As much of a text as the message of a row holds."""
    return str(text).encode()[:500].decode(errors="ignore")


class Child:
    """A process with a policy; it belongs to the process that started it."""

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
        return {"status": status, "signal": max(-code, 0) or None, "message": short(f"{message}: {said}" if said else message)}

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
