"""The exceptions and warnings of meshmend."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._check import Check
    from ._defects import Defects
    from ._notes import Loss


class MeshmendError(Exception):
    """Whatever meshmend raises of its own."""

    def __reduce__(self) -> Any:
        """Pickles with all that is plain data; a check stays behind."""
        plain = {name: dict(value) if isinstance(value, Mapping) else value for name, value in self.__dict__.items()}
        return _again, (type(self), self.args, {**plain, "check": None} if "check" in plain else plain)


class ReadError(MeshmendError, ValueError):
    """A file that can't be read: where, and of which kind the reason is."""

    def __init__(self, message: str, path: str, line: int | None, byte: int | None, kind: str) -> None:
        super().__init__(message)
        self.path = path
        self.line = line
        self.byte = byte
        self.kind = kind


class WriteError(MeshmendError, ValueError):
    """A mesh that can't be written as it was asked for."""

    def __init__(self, message: str, path: str) -> None:
        super().__init__(message)
        self.path = path


class LossError(WriteError):
    """A file that would not carry everything, where that was forbidden. Nothing was written."""

    def __init__(self, message: str, path: str, losses: str) -> None:
        from ._notes import losses_of

        super().__init__(message, path)
        self.losses: list[Loss] = losses_of(losses)


class RefusedError(MeshmendError):
    """A mesh that is not to be worked on, or can't be: a policy says `fail`, or a kernel can't hold it."""

    def __init__(self, message: str, defects: Sequence[Any] = (), kernel: str | None = None) -> None:
        from ._defects import by_kind

        super().__init__(message)
        self.defects: Mapping[str, Defects] = by_kind(defects)
        self.kernel = kernel


class DefectError(MeshmendError, AssertionError):
    """A mesh that is not what `Check.require` asks for, or that a repair leaves so; the check is there where there is one mesh."""

    def __init__(self, message: str, check: Check | None) -> None:
        super().__init__(message)
        self.check = check


class PlanError(MeshmendError, ValueError):
    """A text that is no plan; the line is that of the word that is wrong, where one is."""

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.line: int | None = _line_in(message)


class InternalError(MeshmendError):
    """A mistake of meshmend itself. The input is untouched. `place` says where, for a report of the mistake."""

    def __init__(self, message: str, place: str | None = None) -> None:
        super().__init__(
            f"a mistake of meshmend: {message}. Your data is untouched. Please report it, with `place` of this exception."
        )
        self.place = place


class LossWarning(UserWarning):
    """Something that a file, another library or a type of numbers can't carry; `losses` says what, each with its kind."""

    def __init__(self, message: str, losses: Sequence[Loss] = ()) -> None:
        super().__init__(message)
        self.losses = tuple(losses)


def _again(kind: type[MeshmendError], args: tuple[Any, ...], state: dict[str, Any]) -> MeshmendError:
    error = kind.__new__(kind, *args)
    error.args = args
    error.__dict__.update(state)
    return error


def _line_in(message: str) -> int | None:
    """The line that a message of the TOML reader names: `TOML parse error at line 3, column 1`."""
    words = message.replace(",", " ").split()
    numbers = (after for word, after in zip(words, words[1:]) if word == "line")
    return next((int(number) for number in numbers if number.isdigit()), None)
