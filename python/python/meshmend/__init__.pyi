# What is public, with its types. Lists of words and options are those of the registries: `tests/test_types.py` compares them.
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any, BinaryIO, ClassVar, Final, Literal, NamedTuple, Protocol, SupportsIndex, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from typing_extensions import TypedDict, Unpack

_Ids: TypeAlias = NDArray[np.int32]
_Source: TypeAlias = str | PathLike[str] | bytes | bytearray | memoryview | BinaryIO
_Target: TypeAlias = str | PathLike[str] | BinaryIO
_Faces: TypeAlias = ArrayLike | Sequence[Sequence[int]] | tuple[ArrayLike, ArrayLike]
# 0.01 or "0.01": a length; "0.001%": of the diagonal; also "none", "exact", "single", "auto", and "boundary:" with a length.
_Weld: TypeAlias = float | str
_View: TypeAlias = Literal["indexed", "welded"]
_Encoding: TypeAlias = Literal["ascii", "binary", "little-endian", "big-endian"]
_Kind: TypeAlias = Literal["degenerate-face", "non-simple-face", "face-with-hole", "crossing-face", "repeated-corner",
    "duplicate-face", "opposite-face", "differing-face", "polygon-face", "non-finite-face", "boundary-edge",
    "non-manifold-edge", "inconsistent-edge", "seam-edge", "coincident-edges", "pinched-vertex", "singular-vertex",
    "non-finite-vertex", "unreferenced-vertex", "coincident-vertex", "loose-edge", "loose-point", "non-orientable-patch",
    "unjudged-patch", "turned-cavity", "inside-out-component", "solid-within", "no-volume", "crossing-faces",
    "coincident-faces", "touching-faces", "self-crossing-face", "t-junction", "internal-face", "internal-component",
    "zero-area-face", "sliver-face", "undecided-component", "small-component"]
_PassName: TypeAlias = Literal["weld", "clean", "orient", "heal", "split", "fill", "triangulate", "slivers", "drop",
    "outward", "compact", "apart", "verify"]
_Kernel: TypeAlias = Literal["edge-use", "face-vertex", "adjacency-lists", "half-edge", "quad-edge", "winged-edge",
    "corner-table", "simple-record", "generalised-map", "rotation-system"]
_RepairKernel: TypeAlias = Literal["edge-use", "face-vertex", "adjacency-lists", "half-edge", "quad-edge", "winged-edge",
    "corner-table", "simple-record", "generalised-map", "rotation-system"]
_Question: TypeAlias = Literal["crossings", "t-junctions", "nesting", "internal", "shape"]
_Witness: TypeAlias = Literal["breadth-first", "shortest"]
_Variant: TypeAlias = Literal["obj", "ply-le", "ply-be", "ply-ascii", "stl-binary", "stl-ascii", "off", "glb", "gltf",
    "3mf"]
_Format: TypeAlias = Literal["obj", "ply", "stl", "stla", "stlb", "off", "coff", "noff", "cnoff", "stoff", "glb", "gltf",
    "3mf"]
_Shape: TypeAlias = Literal["tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron", "hexagon", "annulus",
    "torus", "disc", "surface", "moebius-band", "klein-bottle", "projective-plane", "dycks-surface", "seven-vertex-torus",
    "dunce-hat", "wrapped-disc", "three-triangles-on-an-edge", "two-tetrahedra-on-a-vertex", "two-tetrahedra-on-an-edge",
    "two-boxes-on-an-edge", "book", "nested-pages", "bow-tie", "umbrellas", "pinched-torus", "sphere-with-membrane",
    "three-hemispheres", "foam", "fan", "strip"]
_Preset: TypeAlias = Literal["asset", "print", "scan", "teaching"]
_Geometry: TypeAlias = bool | str | Sequence[_Question]

class _Progress(Protocol):
    def __call__(self, step: str, done: int, total: int, /) -> object: ...

class _Policies(TypedDict, total=False):
    weld: float | str | Literal[False] | None
    weld_by: Literal["pose", "position"] | None
    clean: Literal["on", "off", False, True] | None
    non_finite: Literal["drop", "keep", "fail"] | None
    repeated: Literal["keep-different", "drop"] | None
    orient: Literal["majority", "outward", "outward-nested", "off", False] | None
    non_orientable: Literal["report", "cut", "fail"] | None
    duplicates: Literal["keep", "remove-pair", "keep-first"] | None
    flipped_normals: Literal["negate", "keep"] | None
    heal: float | str | Literal[False] | None
    split: Literal["sheets", "cut", "pinch-only", "off", False] | None
    fill: str | Literal[False] | None
    fill_by: Literal["fold", "area", "fan"] | None
    fill_rims: bool | None
    fill_crossing: Literal["leave", "keep"] | None
    triangulate: Literal["auto", "all", "off", False] | None
    slivers: float | str | Literal[False] | None
    max_move: float | str | None
    drop_components: str | None
    internal: Literal["keep", "remove-components", "remove-faces"] | None
    outward: Literal["solids", "nested", "visible", "off", False] | None
    compact: Literal["on", "keep-loose", "off", False, True] | None
    apart: Literal["nudge", "off", False] | None

class _CallOptions(TypedDict, total=False):
    threads: int | None
    progress: _Progress | bool | None

class _CheckOptions(_CallOptions, total=False):
    view: _View | None
    weld: _Weld | None
    kernel: _Kernel
    witness: _Witness
    geometry: _Geometry
    near: float | str
    pair_budget: int | None
    fail_on: Sequence[_Kind]

class _RepairOptions(_Policies, _CallOptions, total=False):
    plan: Plan | str | PathLike[str] | None
    preset: _Preset | None
    report: bool
    kernel: _RepairKernel
    allow_empty: bool
    geometry: _Geometry
    near: float | str
    pair_budget: int | None
    parts: Sequence[str | int]
    by: Literal["object", "group", "material", "solid"] | None
    fail_on: Sequence[_Kind | Literal["removed", "changed", "left"]]
    strict: bool
    output: str | PathLike[str] | None

class _MendOptions(_Policies, _CallOptions, total=False):
    plan: Plan | str | PathLike[str] | None
    preset: _Preset | None
    kernel: _RepairKernel
    allow_empty: bool

class _WriteOptions(_CallOptions, total=False):
    format: _Format | None
    encoding: _Encoding | None
    strict: bool
    seams: Literal["split", "corners", "fail"]
    manifold_extension: bool
    keep_double: bool
    companions: Literal["copy", "skip"]

class _EncodeOptions(TypedDict, total=False):
    encoding: _Encoding | None
    strict: bool
    seams: Literal["split", "corners", "fail"]
    manifold_extension: bool
    keep_double: bool

class _ReadOptions(_CallOptions, total=False):
    format: _Format | None
    name: str | None
    max_bytes: int | None
    max_vertices: int | None
    max_faces: int | None

__all__ = [
    "SCHEMA", "Betti", "Check", "Cut", "DefectError", "Defects", "Document", "DocumentCheck", "InternalError", "Loss", "LossError",
    "LossWarning", "Loop", "Loops", "Mesh", "MeshmendError", "Note", "Part", "PassRecord", "Plan", "PlanError", "ReadError", "RefusedError",
    "Relation", "Removed", "Repair", "Surface", "WriteError", "__version__", "check", "cut", "encode", "explain", "loops", "make",
    "mend", "read", "read_document", "repair", "set_threads", "write",
]

__version__: Final[str]
SCHEMA: Final[int]

class Mesh:
    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __init__(
        self,
        vertices: ArrayLike,
        faces: _Faces = (),
        *,
        pad: int | None = None,
        vertex_attributes: Mapping[str, ArrayLike] | None = None,
        face_attributes: Mapping[str, ArrayLike] | None = None,
        corner_attributes: Mapping[str, ArrayLike] | None = None,
        loose_edges: ArrayLike | None = None,
        loose_points: ArrayLike | None = None,
    ) -> None: ...
    @classmethod
    def of(cls, thing: object) -> Mesh: ...
    @property
    def vertices(self) -> NDArray[np.float64]: ...
    @property
    def faces(self) -> _Ids: ...
    @property
    def corners(self) -> _Ids: ...
    @property
    def offsets(self) -> _Ids: ...
    @property
    def is_triangles(self) -> bool: ...
    @property
    def edges(self) -> _Ids: ...
    @property
    def loose_edges(self) -> _Ids: ...
    @property
    def loose_points(self) -> _Ids: ...
    @property
    def vertex_attributes(self) -> Mapping[str, NDArray[Any]]: ...
    @property
    def face_attributes(self) -> Mapping[str, NDArray[Any]]: ...
    @property
    def corner_attributes(self) -> Mapping[str, NDArray[Any]]: ...
    @property
    def notes(self) -> Sequence[Note]: ...
    @property
    def format(self) -> _Variant | None: ...
    def check(self, **options: Unpack[_CheckOptions]) -> Check: ...
    def repair(self, **options: Unpack[_RepairOptions]) -> Repair: ...
    def write(self, target: _Target, **options: Unpack[_WriteOptions]) -> list[Loss]: ...
    def picture(
        self, *, defects: bool = True, size: tuple[int, int] = (480, 360), format: Literal["png", "svg"] = "png"
    ) -> bytes: ...
    def to_trimesh(self, **keywords: Any) -> Any: ...
    def to_pyvista(self) -> Any: ...
    def to_open3d(self, *, tensor: bool = False) -> Any: ...
    def to_meshio(self) -> Any: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> Literal[True]: ...
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self) -> Mesh: ...
    def __deepcopy__(self, memo: Any) -> Mesh: ...
    def __reduce_ex__(self, protocol: SupportsIndex) -> Any: ...
    def _repr_html_(self) -> str: ...

class Part:
    number: int
    name: str
    title: str
    sealed: str | None
    mesh: Mesh
    def __init__(self, number: int, name: str, title: str, sealed: str | None, mesh: Mesh) -> None: ...

class Document:
    @property
    def parts(self) -> Sequence[Part]: ...
    @property
    def name(self) -> str: ...
    @property
    def format(self) -> _Variant: ...
    @property
    def notes(self) -> Sequence[Note]: ...
    def check(self, *, parts: Sequence[str | int] | None = None, **options: Unpack[_CheckOptions]) -> DocumentCheck: ...
    def repair(self, **options: Unpack[_RepairOptions]) -> Repair: ...
    def mesh(self, place: Literal["scene", "parts"] = "scene") -> Mesh: ...
    def write(self, target: _Target, **options: Unpack[_WriteOptions]) -> list[Loss]: ...
    def __len__(self) -> int: ...

@dataclass(frozen=True)
class Note:
    kind: str
    count: int
    message: str
    line: int | None = None
    @classmethod
    def of(cls, note: dict[str, Any]) -> Note: ...
    def to_dict(self) -> dict[str, Any]: ...

@dataclass(frozen=True)
class Loss:
    kind: str
    count: int
    message: str
    def to_dict(self) -> dict[str, Any]: ...

class Defects:
    @property
    def kind(self) -> _Kind: ...
    @property
    def title(self) -> str: ...
    @property
    def explanation(self) -> str: ...
    @property
    def severity(self) -> Literal["note", "defect"]: ...
    @property
    def vertices(self) -> _Ids: ...
    @property
    def edges(self) -> _Ids: ...
    @property
    def faces(self) -> _Ids: ...
    @property
    def data(self) -> Mapping[str, NDArray[Any]]: ...
    @property
    def strips(self) -> Sequence[_Ids]: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[dict[str, Any]]: ...
    def __reduce__(self) -> Any: ...

class Betti(NamedTuple):
    z2: tuple[int, int, int] | None
    q: tuple[int, int, int] | None

class Check:
    @property
    def schema(self) -> int: ...
    @property
    def vertices(self) -> int: ...
    @property
    def edges(self) -> int: ...
    @property
    def faces(self) -> int: ...
    @property
    def components(self) -> int: ...
    @property
    def patches(self) -> int: ...
    @property
    def component_kinds_total(self) -> int: ...
    @property
    def euler_characteristic(self) -> int: ...
    @property
    def boundary_edges(self) -> int: ...
    @property
    def interior_edges(self) -> int: ...
    @property
    def inconsistent_edges(self) -> int: ...
    @property
    def non_manifold_edges(self) -> int: ...
    @property
    def non_orientable_patches(self) -> int: ...
    @property
    def non_simple_faces(self) -> int: ...
    @property
    def repeated_corner_faces(self) -> int: ...
    @property
    def degenerate_faces(self) -> int: ...
    @property
    def unreferenced_vertices(self) -> int: ...
    @property
    def non_finite_vertices(self) -> int: ...
    @property
    def loose_edges(self) -> int: ...
    @property
    def loose_points(self) -> int: ...
    @property
    def joined_in_single(self) -> int: ...
    @property
    def apart_in_pose(self) -> int: ...
    @property
    def boundary_loops(self) -> int | None: ...
    @property
    def genus(self) -> int | None: ...
    @property
    def cross_caps(self) -> int | None: ...
    @property
    def manifold(self) -> bool: ...
    @property
    def closed(self) -> bool: ...
    @property
    def orientable(self) -> bool: ...
    @property
    def consistently_oriented(self) -> bool: ...
    @property
    def file(self) -> str | None: ...
    @property
    def format(self) -> _Variant | None: ...
    @property
    def view(self) -> Literal["indexed", "welded"]: ...
    @property
    def weld(self) -> Any: ...
    @property
    def witness(self) -> _Witness: ...
    @property
    def stored(self) -> Mapping[str, int]: ...
    @property
    def non_manifold_vertices(self) -> Mapping[str, int]: ...
    @property
    def duplicate_faces(self) -> Mapping[str, int]: ...
    @property
    def instigators(self) -> Mapping[str, int]: ...
    @property
    def betti_unknown(self) -> str | None: ...
    @property
    def mesh(self) -> Mesh: ...
    @property
    def betti(self) -> Betti: ...
    @property
    def undefined(self) -> Mapping[str, str]: ...
    @property
    def kernels(self) -> Mapping[_Kernel, Mapping[_Kind, int]]: ...
    @property
    def component_kinds(self) -> Sequence[Mapping[str, Any]]: ...
    @property
    def geometry(self) -> Mapping[str, Any] | None: ...
    @property
    def notes(self) -> Sequence[Note]: ...
    @property
    def is_sound(self) -> bool: ...
    @property
    def defects(self) -> Mapping[_Kind, Defects]: ...
    def counts(self) -> dict[_Kind, int]: ...
    def to_dict(self, limit: int | None = 10) -> dict[str, Any]: ...
    def to_json(self, limit: int | None = 10) -> str: ...
    def require(self, *kinds: _Kind, **figures: object) -> Check: ...
    def __bool__(self) -> bool: ...
    def _repr_html_(self) -> str: ...

class DocumentCheck(Mapping[str, Check]):
    document: Document
    def __init__(self, document: Document, checks: Sequence[tuple[int, Check | None]]) -> None: ...
    @property
    def is_sound(self) -> bool: ...
    def to_dict(self, limit: int | None = 10) -> dict[str, Any]: ...
    def to_json(self, limit: int | None = 10) -> str: ...
    def __getitem__(self, title: str) -> Check: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def __bool__(self) -> bool: ...

class Relation:
    @property
    def old_of_new(self) -> _Ids: ...
    @property
    def new_of_old(self) -> _Ids: ...
    @property
    def pairs(self) -> _Ids: ...
    @property
    def removed(self) -> _Ids: ...
    @property
    def created(self) -> _Ids: ...
    def all_new_of(self, old: int) -> _Ids: ...
    def carry(self, values: ArrayLike, fill: Any = None) -> NDArray[Any]: ...

class PassRecord(NamedTuple):
    name: _PassName
    changed: bool
    mended: Mapping[_Kind, Defects]
    left: Mapping[_Kind, Defects]
    delta: Mapping[str, int | None]

class Removed(NamedTuple):
    faces: _Ids
    passes: Sequence[_PassName]
    reasons: Sequence[_Kind]

class Repair:
    @property
    def mesh(self) -> Mesh: ...
    @property
    def parts(self) -> Mapping[str, Repair]: ...
    @property
    def kept(self) -> Mapping[str, str]: ...
    @property
    def document(self) -> Document | None: ...
    @property
    def before(self) -> Check | None: ...
    @property
    def after(self) -> Check | None: ...
    @property
    def passes(self) -> Sequence[PassRecord]: ...
    @property
    def vertices(self) -> Relation: ...
    @property
    def faces(self) -> Relation: ...
    @property
    def corners(self) -> Relation: ...
    @property
    def flipped(self) -> _Ids: ...
    @property
    def removed_faces(self) -> Removed: ...
    @property
    def changed(self) -> bool: ...
    @property
    def failing(self) -> Mapping[str, int]: ...
    def to_dict(self, limit: int | None = 10, maps: bool = False) -> dict[str, Any]: ...
    def to_json(self, limit: int | None = 10, maps: bool = False) -> str: ...
    def write(self, target: _Target, **options: Unpack[_WriteOptions]) -> list[Loss]: ...
    def _repr_html_(self) -> str: ...

class Plan:
    __hash__: ClassVar[None]  # type: ignore[assignment]
    def __init__(self, *passes: _PassName, allow_empty: bool = False, **policies: Unpack[_Policies]) -> None: ...
    @classmethod
    def from_toml(cls, text: str) -> Plan: ...
    @classmethod
    def read(cls, path: str | PathLike[str]) -> Plan: ...
    @classmethod
    def preset(cls, name: _Preset, over: str | None = None) -> Plan: ...
    @property
    def passes(self) -> tuple[_PassName, ...]: ...
    def to_toml(self) -> str: ...
    def __eq__(self, other: object) -> bool: ...
    def __reduce__(self) -> Any: ...

class Loop(NamedTuple):
    kind: Literal["handle", "cross-cap", "boundary"]
    length: float
    two_sided: bool
    vertices: _Ids

class Surface(NamedTuple):
    name: str | None
    root: int | None
    system_length: float | None
    loops: Sequence[Loop]
    obstacle: str | None

class Loops(Sequence[Loop]):
    components: Sequence[Surface]
    def __init__(self, handle: Any) -> None: ...
    @property
    def mesh(self) -> Mesh: ...
    def to_dict(self, limit: int | None = 10000) -> dict[str, Any]: ...
    def to_json(self, limit: int | None = 10000) -> str: ...
    def __getitem__(self, at: Any) -> Any: ...
    def __len__(self) -> int: ...
    def __iter__(self) -> Iterator[Loop]: ...

class Cut:
    mesh: Mesh
    vertices: Relation
    def __init__(self, handle: Any) -> None: ...
    @property
    def seams(self) -> _Ids: ...
    def to_dict(self, limit: int | None = 10) -> dict[str, Any]: ...
    def to_json(self, limit: int | None = 10) -> str: ...
    def write(self, target: _Target, **options: Unpack[_WriteOptions]) -> list[Loss]: ...

def read(source: _Source, **options: Unpack[_ReadOptions]) -> Mesh: ...
def read_document(
    source: _Source,
    *,
    format: _Format | None = None,
    name: str | None = None,
    max_bytes: int | None = None,
    max_vertices: int | None = None,
    max_faces: int | None = None,
    threads: int | None = None,
    progress: _Progress | bool | None = None,
) -> Document: ...
def write(
    mesh: object,
    target: _Target,
    *,
    format: _Format | None = None,
    encoding: _Encoding | None = None,
    strict: bool = False,
    seams: Literal["split", "corners", "fail"] = "split",
    manifold_extension: bool = False,
    keep_double: bool = False,
    companions: Literal["copy", "skip"] = "copy",
    threads: int | None = None,
    progress: _Progress | bool | None = None,
) -> list[Loss]: ...
def encode(mesh: object, format: _Format, **options: Unpack[_EncodeOptions]) -> bytes: ...
def check(
    mesh: object,
    *,
    view: _View | None = None,
    weld: _Weld | None = None,
    kernel: _Kernel = "edge-use",
    witness: _Witness = "breadth-first",
    geometry: _Geometry = False,
    near: float | str = "exact",
    pair_budget: int | None = None,
    fail_on: Sequence[_Kind] = (),
    threads: int | None = None,
    progress: _Progress | bool | None = None,
) -> Check: ...
def repair(
    mesh: object,
    *,
    plan: Plan | str | PathLike[str] | None = None,
    preset: _Preset | None = None,
    report: bool = True,
    kernel: _RepairKernel = "edge-use",
    allow_empty: bool = False,
    geometry: _Geometry = False,
    near: float | str = "exact",
    pair_budget: int | None = None,
    parts: Sequence[str | int] = (),
    by: Literal["object", "group", "material", "solid"] | None = None,
    fail_on: Sequence[_Kind | Literal["removed", "changed", "left"]] = (),
    strict: bool = False,
    output: str | PathLike[str] | None = None,
    threads: int | None = None,
    progress: _Progress | bool | None = None,
    **policies: Unpack[_Policies],
) -> Repair: ...
def mend(vertices: ArrayLike, faces: _Faces, **policies: Unpack[_MendOptions]) -> tuple[NDArray[Any], Any]: ...
def loops(
    mesh: object,
    *,
    greedy: bool = False,
    root: int | None = None,
    roots: int | None = None,
    hops: bool = False,
    view: _View | None = None,
    weld: _Weld | None = None,
    kernel: _Kernel = "edge-use",
    threads: int | None = None,
    progress: _Progress | bool | None = None,
) -> Loops: ...
def cut(
    mesh: object,
    *,
    along: Literal["cut-graph", "generators"] = "cut-graph",
    greedy: bool = False,
    root: int | None = None,
    roots: int | None = None,
    hops: bool = False,
    view: _View | None = None,
    weld: _Weld | None = None,
    threads: int | None = None,
    progress: _Progress | bool | None = None,
) -> Cut: ...
def make(
    shape: _Shape,
    *,
    resolution: int | None = None,
    count: int | None = None,
    genus: int | None = None,
    cross_caps: int | None = None,
    holes: int | None = None,
    refine: int = 0,
    triangles: bool = False,
) -> Mesh: ...
def explain(code: str) -> str: ...
def set_threads(count: int | None) -> None: ...

class MeshmendError(Exception):
    def __reduce__(self) -> Any: ...

class ReadError(MeshmendError, ValueError):
    path: str
    line: int | None
    byte: int | None
    kind: Literal["malformed", "unknown-format", "limit"]
    def __init__(self, message: str, path: str, line: int | None, byte: int | None, kind: str) -> None: ...

class WriteError(MeshmendError, ValueError):
    path: str
    def __init__(self, message: str, path: str) -> None: ...

class LossError(WriteError):
    losses: list[Loss]
    def __init__(self, message: str, path: str, losses: str) -> None: ...

class RefusedError(MeshmendError):
    defects: Mapping[_Kind, Defects]
    kernel: str | None
    def __init__(self, message: str, defects: Sequence[Any] = (), kernel: str | None = None) -> None: ...

class DefectError(MeshmendError, AssertionError):
    check: Check | None
    def __init__(self, message: str, check: Check | None) -> None: ...

class PlanError(MeshmendError, ValueError):
    line: int | None
    def __init__(self, message: str) -> None: ...

class InternalError(MeshmendError):
    place: str | None
    def __init__(self, message: str, place: str | None = None) -> None: ...

class LossWarning(UserWarning):
    losses: tuple[Loss, ...]
    def __init__(self, message: str, losses: Sequence[Loss] = ()) -> None: ...
