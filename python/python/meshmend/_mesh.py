"""The mesh, as arrays."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _layers, _native
from ._errors import LossWarning
from ._notes import Note
from ._progress import watched

if TYPE_CHECKING:
    from ._check import Check
    from ._repair import Repair

Ids = NDArray[np.int32]


class Mesh:
    """An immutable polygon mesh: positions, faces of any size, loose elements, attribute layers."""

    __slots__ = ("__weakref__", "_cache", "_format", "_handle", "_notes")
    __hash__ = None  # type: ignore[assignment]

    def __init__(
        self,
        vertices: ArrayLike,
        faces: Any = (),
        *,
        pad: int | None = None,
        vertex_attributes: Mapping[str, ArrayLike] | None = None,
        face_attributes: Mapping[str, ArrayLike] | None = None,
        corner_attributes: Mapping[str, ArrayLike] | None = None,
        loose_edges: ArrayLike | None = None,
        loose_points: ArrayLike | None = None,
    ) -> None:
        points = _arrays.points(vertices)
        corners, starts = _arrays.faces(faces, len(points), pad)
        loose = (
            _arrays.pairs("loose_edges", loose_edges, len(points)),
            _arrays.singles("loose_points", loose_points, len(points)),
        )
        layers = [
            *_arrays.layers("vertex", vertex_attributes, len(points)),
            *_arrays.layers("face", face_attributes, len(corners) if starts is None else len(starts) - 1),
            *_arrays.layers("corner", corner_attributes, corners.size),
        ]
        try:
            self._be(_native.MeshHandle(points, corners, starts, loose, layers, []), (), None)
        except IndexError:
            _arrays.checked(corners, len(points), "faces")
            raise

    @classmethod
    def of(cls, thing: object) -> Mesh:
        """From a trimesh, PyVista, Open3D, meshio, pymeshlab or manifold3d object, or a pair (V, F); imports none of them."""
        from . import _adapters

        return _adapters.mesh_of(thing)

    def _be(self, handle: Any, notes: Sequence[Note], form: str | None) -> None:
        self._handle = handle
        self._notes = tuple(notes)
        self._format = form
        self._cache: dict[str, Any] = {}

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions, (n, 3)."""
        return self._once("vertices", self._handle.vertices)

    @property
    def faces(self) -> Ids:
        """Triangles, (m, 3), or faces of one size, (m, k); ValueError where sizes differ."""
        return self._once("faces", self._rows)

    @property
    def corners(self) -> Ids:
        """The vertex of each corner, face after face."""
        return self._once("corners", lambda: corners_of(self._handle))

    @property
    def offsets(self) -> Ids:
        """Where each face begins in `corners`; m + 1 numbers."""
        return self._once("offsets", self._handle.offsets)

    @property
    def is_triangles(self) -> bool:
        """Whether all faces have three corners."""
        return bool(self._handle.is_triangles())

    @property
    def edges(self) -> Ids:
        """The ends of each edge, (e, 2), lower first; edge ids in reports are rows of it."""
        return self._once("edges", self._handle.edges)

    @property
    def loose_edges(self) -> Ids:
        """The ends of each edge that is an element of its own, (e, 2)."""
        return self._once("loose_edges", self._handle.loose_edges)

    @property
    def loose_points(self) -> Ids:
        """The vertex of each point that is an element of its own."""
        return self._once("loose_points", self._handle.loose_points)

    @property
    def vertex_attributes(self) -> Mapping[str, NDArray[Any]]:
        """Layers by name, in their stored types."""
        return self._attributes("vertex")

    @property
    def face_attributes(self) -> Mapping[str, NDArray[Any]]:
        """Layers with a value for each face."""
        return self._attributes("face")

    @property
    def corner_attributes(self) -> Mapping[str, NDArray[Any]]:
        """Layers with a value for each corner: those of vertices come here where vertices that differ were welded."""
        return self._attributes("corner")

    @property
    def notes(self) -> Sequence[Note]:
        """What the reader had to say; empty for arrays."""
        return self._notes

    @property
    def format(self) -> str | None:
        """`obj`, `ply-le`, `stl-binary` and so on: the form of the file that it is from."""
        return self._format

    def check(self, **options: Any) -> Check:
        """Same as `meshmend.check(self, ...)`."""
        from ._check import check

        return check(self, **options)

    def repair(self, **options: Any) -> Repair:
        """Same as `meshmend.repair(self, ...)`."""
        from ._repair import repair

        return repair(self, **options)

    def write(self, target: Any, **options: Any) -> list[Any]:
        """Same as `meshmend.write(self, target, ...)`."""
        from ._files import write

        return write(self, target, **options)

    def picture(
        self, *, defects: bool = True, size: tuple[int, int] = (480, 360), format: Literal["png", "svg"] = "png"
    ) -> bytes:
        """A picture without a GPU or window; what is wrong is marked."""
        width, height = size
        with watched() as how:
            return bytes(_native.picture(self._handle, defects, (width, height), format, how))

    def to_trimesh(self, **keywords: Any) -> Any:
        """`trimesh.Trimesh(..., process=False)`; ValueError where a face is no triangle."""
        from . import _adapters

        return _adapters.to_trimesh(self, keywords)

    def to_pyvista(self) -> Any:
        """`pyvista.PolyData`, faces of any size kept, attributes as point and cell data."""
        from . import _adapters

        return _adapters.to_pyvista(self)

    def to_open3d(self, *, tensor: bool = False) -> Any:
        """`open3d.geometry.TriangleMesh`, or `open3d.t.geometry.TriangleMesh`; ValueError where a face is no triangle."""
        from . import _adapters

        return _adapters.to_open3d(self, tensor)

    def to_meshio(self) -> Any:
        """`meshio.Mesh`, faces of any size kept, attributes as point and cell data."""
        from . import _adapters

        return _adapters.to_meshio(self)

    def __len__(self) -> int:
        return int(self._handle.counts()[1])

    def __bool__(self) -> bool:
        return True

    def __repr__(self) -> str:
        vertices, faces, _ = self._handle.counts()
        form = f", {self._format}" if self._format else ""
        return f"<Mesh: {vertices} vertices, {faces} faces{form}>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mesh):
            return NotImplemented
        if self is other or self._handle is other._handle:
            return True
        same = all(same_bits(one, two) for one, two in zip(self._arrays_of(), other._arrays_of()))
        return same and _layers.are_same(self._layers(), other._layers())

    def __copy__(self) -> Mesh:
        return self

    def __deepcopy__(self, memo: Any) -> Mesh:
        return self

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        """Pickles with out-of-band buffers (protocol 5). What a file holds beside the mesh does not come along."""
        if self._handle.has_shell():
            text = f"{self!r}: what its file holds beside the mesh is not pickled, such as materials, nodes and other parts"
            warnings.warn(LossWarning(text), stacklevel=2)
        plain = (self.vertices, self.corners, self.offsets, self.loose_edges, self.loose_points)
        return _unpickled, (plain, self._layers(), self._handle.metadata(), self._notes, self._format)

    def _repr_html_(self) -> str:
        from . import _html

        return _html.of_mesh(self)

    def _arrays_of(self) -> tuple[NDArray[Any], ...]:
        return self.vertices, self.corners, self.offsets, self.loose_edges, self.loose_points

    def _layers(self) -> list[dict[str, Any]]:
        if "layers" not in self._cache:
            self._cache.setdefault("layers", self._handle.layers())
        layers: list[dict[str, Any]] = self._cache["layers"]
        return layers

    def _attributes(self, domain: str) -> Mapping[str, NDArray[Any]]:
        key = f"{domain} attributes"
        if key not in self._cache:
            found = _layers.by_name(layer for layer in self._layers() if layer["domain"] == domain)
            self._cache.setdefault(key, MappingProxyType(found))
        attributes: Mapping[str, NDArray[Any]] = self._cache[key]
        return attributes

    def _rows(self) -> Ids:
        if self.is_triangles:
            return self.corners.reshape(-1, 3)
        lengths = np.diff(self.offsets)
        size = int(lengths[0]) if len(lengths) else 3
        if not (lengths == size).all():
            raise ValueError("faces have different sizes: take `corners` and `offsets`, or repair with triangulate='all'")
        return self.corners.reshape(-1, size) if size else self.corners.reshape(len(lengths), 0)

    def _once(self, name: str, make: Callable[[], Any]) -> Any:
        """An array that is made once, and can't be written to."""
        if name not in self._cache:
            array = make()
            array.flags.writeable = False
            self._cache.setdefault(name, array)
        return self._cache[name]


def corners_of(handle: Any, wanted: type[np.int32 | np.int64] = np.int32) -> NDArray[Any]:
    """The vertex of each corner of the mesh of a handle."""
    corners = np.empty(handle.counts()[2], dtype=wanted)
    handle.corners(corners)
    return corners


def mesh_with(handle: Any, notes: Sequence[Note] = (), form: str | None = None) -> Mesh:
    """The mesh of a handle."""
    mesh = Mesh.__new__(Mesh)
    mesh._be(handle, notes, form)
    return mesh


def mesh_as_read(handle: Any) -> Mesh:
    """The mesh of a handle, with what its file says."""
    notes = [Note.of(note) for note in json.loads(handle.notes())]
    return mesh_with(handle, notes, handle.variant())


def same_bits(one: NDArray[Any], other: NDArray[Any]) -> bool:
    """Whether two arrays are the same to the bit, so that NaN equals NaN and 0 does not equal -0."""
    if one.dtype != other.dtype or one.shape != other.shape:
        return False
    return bool(np.array_equal(np.ascontiguousarray(one).view(np.uint8), np.ascontiguousarray(other).view(np.uint8)))


def _unpickled(
    plain: tuple[NDArray[Any], ...],
    layers: list[dict[str, Any]],
    metadata: list[tuple[str, bytes]],
    notes: Sequence[Note],
    form: str | None,
) -> Mesh:
    vertices, corners, offsets, edges, points = plain
    numbers = [np.ascontiguousarray(array).astype(np.uint32) for array in (corners, offsets, edges, points)]
    corners, offsets, edges, points = numbers
    return mesh_with(_native.MeshHandle(vertices, corners, offsets, (edges, points), layers, metadata), notes, form)
