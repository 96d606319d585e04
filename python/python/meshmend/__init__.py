"""Finds, explains and mends what is wrong with polygon meshes."""

from . import _native
from ._check import Betti, Check, DocumentCheck, check
from ._defects import Defects
from ._document import Document, Part
from ._errors import (
    DefectError,
    InternalError,
    LossError,
    LossWarning,
    MeshmendError,
    PlanError,
    ReadError,
    RefusedError,
    WriteError,
)
from ._files import encode, read, read_document, write
from ._mesh import Mesh
from ._notes import Loss, Note
from ._plan import Plan
from ._relation import Relation
from ._repair import PassRecord, Removed, Repair, mend, repair
from ._surfaces import Cut, Loop, Loops, Surface, cut, loops, make
from ._words import explain, set_threads

__version__: str = _native.__version__
SCHEMA: int = _native.SCHEMA

__all__ = [
    "SCHEMA", "Betti", "Check", "Cut", "DefectError", "Defects", "Document", "DocumentCheck", "InternalError", "Loss", "LossError",
    "LossWarning", "Loop", "Loops", "Mesh", "MeshmendError", "Note", "Part", "PassRecord", "Plan", "PlanError", "ReadError", "RefusedError",
    "Relation", "Removed", "Repair", "Surface", "WriteError", "__version__", "check", "cut", "encode", "explain", "loops", "make",
    "mend", "read", "read_document", "repair", "set_threads", "write",
]

# Where they are found, not where they are made.
for _name in __all__:
    if _name[0].isalpha() and hasattr(globals()[_name], "__module__"):
        globals()[_name].__module__ = __name__
del _name
