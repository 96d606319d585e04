"""Plans, and the options of passes as keywords."""

from __future__ import annotations

import difflib
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import _native

_OPTIONS: dict[str, tuple[str, list[str], str]] = _native.registries()["options"]
_LONGEST = 1 << 20


class Plan:
    """Passes, their order and options; the TOML of `--plan`."""

    __slots__ = ("_handle",)
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, *passes: str, allow_empty: bool = False, **policies: Any) -> None:
        self._handle = _native.PlanHandle(list(passes) or None).saying(said("Plan", policies), allow_empty)

    @classmethod
    def from_toml(cls, text: str) -> Plan:
        """The plan of a text; PlanError names the line and the word."""
        return cls._of(_native.PlanHandle.from_toml(text))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Plan:
        """The plan of a file."""
        return cls.from_toml(text_of(path))

    @classmethod
    def preset(cls, name: str, over: str | None = None) -> Plan:
        """The plan for a purpose, as `--preset`; a TOML text says what differs."""
        return cls._of(_native.PlanHandle.preset(name, over))

    @property
    def passes(self) -> tuple[str, ...]:
        """The passes, in their order."""
        return tuple(self._handle.passes())

    def to_toml(self) -> str:
        """The text that `from_toml` and `--plan` read."""
        return str(self._handle.to_toml())

    @classmethod
    def _of(cls, handle: Any) -> Plan:
        plan = cls.__new__(cls)
        plan._handle = handle
        return plan

    def __eq__(self, other: object) -> bool:
        return bool(self._handle.is_(other._handle)) if isinstance(other, Plan) else NotImplemented

    def __repr__(self) -> str:
        return f"<Plan: {', '.join(self.passes)}>"

    def __reduce__(self) -> Any:
        return Plan.from_toml, (self.to_toml(),)


def text_of(path: str | os.PathLike[str]) -> str:
    """The text of a plan file."""
    with Path(path).open("rb") as file:
        text = file.read(_LONGEST + 1)
    if len(text) > _LONGEST:
        raise ValueError(f"{os.fspath(path)}: too long for a plan")
    return text.decode("utf-8")


def said(called: str, policies: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Keywords as words of the command line; None and False leave an option as it is, but for a pass, which False leaves out."""
    return [word for name, value in policies.items() for word in _said(called, name, value)]


def _said(called: str, name: str, value: Any) -> list[tuple[str, str]]:
    option = name.replace("_", "-")
    if option not in _OPTIONS or "-" in name:
        near = difflib.get_close_matches(option, [*_OPTIONS, "allow-empty"], 1)
        hint = f"; did you mean `{near[0].replace('-', '_')}`?" if near else ""
        raise TypeError(f"{called}() got an unexpected keyword argument '{name}'{hint}")
    takes, words, _ = _OPTIONS[option]
    if value is None:
        return []
    if isinstance(value, bool):
        if takes == "flag":
            return [(option, words[0])] if value else []
        word = "on" if value else "off"
        if word in words or (word == "off" and takes == "length"):
            return [(option, word)]
        raise ValueError(f"{name} can't be {value}{_known(words)}")
    if isinstance(value, str):
        return [(option, value)]
    if takes in ("length", "number") and hasattr(value, "__float__"):
        return [(option, repr(float(value)))]
    raise TypeError(f"{name} is a {type(value).__name__}: it is a word{' or a number' if takes in ('length', 'number') else ''}")


def _known(words: list[str]) -> str:
    return f"; it can be {', '.join(words)}" if words else ""
