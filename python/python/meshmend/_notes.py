"""What readers and writers have to say."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True)
class Note:
    """What a reader had to say."""

    kind: str
    count: int
    message: str
    line: int | None = None

    @classmethod
    def of(cls, note: dict[str, Any]) -> Note:
        """The note of a JSON report."""
        first = note.get("first")
        line = first.get("line") if isinstance(first, dict) else None
        return cls(note["kind"], note["count"], note["message"], line)

    def to_dict(self) -> dict[str, Any]:
        """Its fields by name."""
        return asdict(self)


@dataclass(frozen=True)
class Loss:
    """What a written file can't carry."""

    kind: str
    count: int
    message: str

    def to_dict(self) -> dict[str, Any]:
        """Its fields by name."""
        return asdict(self)


def losses_of(text: str) -> list[Loss]:
    """The losses of a JSON list."""
    return [Loss(loss["kind"], loss["count"], loss["message"]) for loss in json.loads(text)]
