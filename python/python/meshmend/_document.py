"""A file as a whole, with its parts."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ._mesh import Mesh, mesh_as_read
from ._notes import Note

if TYPE_CHECKING:
    from ._check import DocumentCheck
    from ._repair import Repair


class Part:
    """One mesh of a file: `name`, `title` as reports say it, `sealed` if it can't be edited, and `mesh` in its own space."""

    __slots__ = ("mesh", "name", "number", "sealed", "title")

    def __init__(self, number: int, name: str, title: str, sealed: str | None, mesh: Mesh) -> None:
        self.number = number
        self.name = name
        self.title = title
        self.sealed = sealed
        self.mesh = mesh

    def __repr__(self) -> str:
        return f"<Part {self.number}: {self.title}>"


class Document:
    """A file with all its parts, and what is round them: nodes, materials, skins, animations. It never changes."""

    __slots__ = ("_handle", "_parts")

    def __init__(self) -> None:
        raise TypeError("a document comes from meshmend.read_document")

    @classmethod
    def _of(cls, handle: Any) -> Document:
        document = cls.__new__(cls)
        document._handle = handle
        document._parts = tuple(
            Part(number, name.decode("utf-8", "replace"), title, sealed, mesh_as_read(handle.mesh(number)))
            for number, (name, title, sealed) in enumerate(handle.parts())
        )
        return document

    @property
    def parts(self) -> Sequence[Part]:
        """The meshes of the file, in file order."""
        return self._parts

    @property
    def name(self) -> str:
        """What the file is called."""
        return str(self._handle.name())

    @property
    def format(self) -> str:
        """`glb`, `ply-le`, `stl-binary` and so on."""
        return str(self._handle.variant())

    @property
    def notes(self) -> Sequence[Note]:
        """What the reader had to say."""
        return tuple(Note.of(note) for note in json.loads(self._handle.notes()))

    def check(self, *, parts: Sequence[str | int] | None = None, **options: Any) -> DocumentCheck:
        """Each part, or those of these names or numbers, by itself; the options are those of `meshmend.check`."""
        from ._check import check_document

        return check_document(self, parts, options)

    def repair(self, **options: Any) -> Repair:
        """Each part, or those of `parts`, by itself. Same as `meshmend.repair(self, ...)`."""
        from ._repair import repair

        return repair(self, **options)

    def mesh(self, place: str = "scene") -> Mesh:
        """All parts as one mesh: `scene`, as the file places them, or `parts`, each once in its own space."""
        if place not in ("scene", "parts"):
            raise ValueError(f"place can't be `{place}`; it can be scene, parts")
        return mesh_as_read(self._handle.as_one(place == "scene").mesh(0))

    def write(self, target: Any, **options: Any) -> list[Any]:
        """Writes the file: in its own format with all that it holds, else its parts as one mesh. As `meshmend.write`."""
        from ._files import write

        return write(self, target, **options)

    def __len__(self) -> int:
        return len(self._parts)

    def __repr__(self) -> str:
        return f"<Document {self.name}: {len(self)} parts, {self.format}>"

    def _only(self, hint: str) -> Mesh:
        """The mesh of a file that has one."""
        if len(self._parts) != 1:
            names = ", ".join(f"{part.number}: {part.title}" for part in self._parts[:8])
            more = f", and {len(self) - 8} more" if len(self) > 8 else ""
            have = f"has {len(self)} parts ({names}{more})" if self._parts else "has no mesh"
            raise ValueError(f"{self.name} {have}; {hint}")
        part = self._parts[0]
        if part.sealed is not None:
            raise ValueError(f"{self.name}: {part.title} can't be read: {part.sealed}")
        return part.mesh

    def _chosen(self, parts: Sequence[str | int] | None) -> list[Part]:
        """The parts of some names or numbers, in file order."""
        if parts is None:
            return list(self._parts)
        for word in parts:
            if not any(_is(part, word) for part in self._parts):
                known = ", ".join(f"{part.number}: {part.title}" for part in self._parts[:8])
                raise ValueError(f"there is no part `{word}`; the parts are {known}")
        return [part for part in self._parts if any(_is(part, word) for word in parts)]


def _is(part: Part, word: str | int) -> bool:
    return str(part.number) == str(word) or (part.name != "" and part.name == word)
