"""Meshes of other libraries, in and out. None of them is imported before an object of it is there, or is asked for.

What crosses, beside positions, faces of the sizes that both can hold, and attributes of the same elements:

| library  | vertices                       | faces                 | corners         | loose           |
|----------|--------------------------------|-----------------------|-----------------|-----------------|
| trimesh  | attributes, `color`, `texcoord`| attributes, `color`   | -               | -               |
| PyVista  | point data                     | cell data             | -               | lines, vertices |
| Open3D   | `color`, `normal`              | -                     | `texcoord`      | -               |
| meshio   | point data                     | cell data             | -               | lines, vertices |

Out of `pymeshlab` come vertices and faces, out of `manifold3d` the further properties of vertices as `properties`. What does not cross
is told by a `LossWarning`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._files import warned
from ._mesh import Mesh
from ._notes import Loss

Attributes = dict[str, NDArray[Any]]


def mesh_of(thing: object) -> Mesh:
    """A mesh of whatever it is."""
    if isinstance(thing, Mesh):
        return thing
    if isinstance(thing, (tuple, list)) and len(thing) == 2:
        return Mesh(*thing)
    modules = {kind.__module__.partition(".")[0] for kind in type(thing).__mro__}
    for module, make in _READERS.items():
        if module in modules:
            return make(thing)
    kind = f"{type(thing).__module__}.{type(thing).__qualname__}"
    known = "a pair (vertices, faces), or a mesh of trimesh, PyVista, Open3D, meshio, pymeshlab or manifold3d"
    raise TypeError(f"{kind} is no mesh: give {known}")


def _of_trimesh(thing: Any) -> Mesh:
    if not hasattr(thing, "faces"):
        raise TypeError(f"a trimesh.{type(thing).__name__} is no single mesh: take one of its geometries")
    vertex, face = dict(thing.vertex_attributes), dict(thing.face_attributes)
    kind = getattr(thing.visual, "kind", None)
    if kind == "vertex":
        vertex["color"] = np.asarray(thing.visual.vertex_colors)
    elif kind == "face":
        face["color"] = np.asarray(thing.visual.face_colors)
    elif kind == "texture" and thing.visual.uv is not None:
        vertex["texcoord"] = np.asarray(thing.visual.uv)
    return Mesh(np.asarray(thing.vertices), np.asarray(thing.faces), vertex_attributes=vertex, face_attributes=face)


def _of_vtk(thing: Any) -> Mesh:
    if not hasattr(thing, "GetPolys"):
        raise TypeError(f"a {type(thing).__name__} is no surface: take its `extract_surface()`")
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def flat(cells: Any) -> tuple[NDArray[Any], NDArray[Any]]:
        if cells.GetNumberOfCells() == 0:
            return np.zeros(0, dtype=np.int64), np.zeros(1, dtype=np.int64)
        return vtk_to_numpy(cells.GetConnectivityArray()), vtk_to_numpy(cells.GetOffsetsArray())

    if thing.GetStrips().GetNumberOfCells():
        raise ValueError("the mesh has triangle strips: take its `triangulate()`")
    corners, starts = flat(thing.GetPolys())
    lines, line_starts = flat(thing.GetLines())
    points, _ = flat(thing.GetVerts())
    # Between the points of a line there is an edge, but not from the last of one to the first of the next.
    edges = np.stack([lines[:-1], lines[1:]], axis=1) if len(lines) else np.zeros((0, 2), dtype=np.int64)
    edges = np.delete(edges, line_starts[1:-1] - 1, axis=0)
    before = thing.GetVerts().GetNumberOfCells() + thing.GetLines().GetNumberOfCells()
    positions = vtk_to_numpy(thing.GetPoints().GetData()) if thing.GetNumberOfPoints() else np.zeros((0, 3))
    cells = _vtk_arrays(thing.GetCellData(), vtk_to_numpy)
    _tell("the mesh", [f"cell data `{name}` of lines and vertices" for name in cells if before])
    return Mesh(
        positions,
        (corners, starts),
        vertex_attributes=_vtk_arrays(thing.GetPointData(), vtk_to_numpy),
        face_attributes={name: values[before:] for name, values in cells.items()},
        loose_edges=edges,
        loose_points=points,
    )


def _vtk_arrays(data: Any, to_numpy: Callable[[Any], NDArray[Any]]) -> Attributes:
    """The arrays of points or cells; those of texts have no numbers, and are told."""
    found: Attributes = {}
    for at in range(data.GetNumberOfArrays()):
        array = data.GetArray(at)
        if array is None:
            _tell("the mesh", [f"the array `{data.GetArrayName(at)}`, which has no numbers"])
        else:
            found[array.GetName() or f"array {at}"] = _narrow(to_numpy(array))
    return found


def _of_open3d(thing: Any) -> Mesh:
    if hasattr(thing, "triangle"):
        return _of_open3d_tensor(thing)
    if not hasattr(thing, "triangles"):
        raise TypeError(f"an open3d {type(thing).__name__} is no triangle mesh")
    vertex, corner = {}, {}
    if thing.has_vertex_colors():
        vertex["color"] = np.asarray(thing.vertex_colors)
    if thing.has_vertex_normals():
        vertex["normal"] = np.asarray(thing.vertex_normals)
    if thing.has_triangle_uvs():
        corner["texcoord"] = np.asarray(thing.triangle_uvs)
    faces = np.asarray(thing.triangles)
    return Mesh(np.asarray(thing.vertices), faces, vertex_attributes=vertex, corner_attributes=corner)


_TENSOR_NAMES = {"colors": "color", "normals": "normal", "texture_uvs": "texcoord"}


def _of_open3d_tensor(thing: Any) -> Mesh:
    def others(attributes: Any, own: str) -> Attributes:
        names = [name for name, _ in attributes.items() if name != own]
        return {_TENSOR_NAMES.get(name, name): _narrow(attributes[name].numpy()) for name in names}

    vertex, face = others(thing.vertex, "positions"), others(thing.triangle, "indices")
    uv = face.pop("texcoord", None)
    return Mesh(
        thing.vertex.positions.numpy(),
        thing.triangle.indices.numpy(),
        vertex_attributes=vertex,
        face_attributes=face,
        corner_attributes={} if uv is None else {"texcoord": uv.reshape(-1, 2)},
    )


def _of_meshio(thing: Any) -> Mesh:
    points = np.asarray(thing.points)
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    faces: list[NDArray[Any]] = []
    edges, singles, blocks = [], [], []
    for at, block in enumerate(thing.cells):
        if block.type in ("triangle", "quad", "polygon"):
            faces.extend(np.asarray(row) for row in block.data)
            blocks.append(at)
        elif block.type == "line":
            edges.append(np.asarray(block.data))
        elif block.type == "vertex":
            singles.append(np.asarray(block.data).reshape(-1))
        else:
            raise ValueError(f"cells of the type `{block.type}` are no faces")
    face = {name: np.concatenate([values[at] for at in blocks]) for name, values in thing.cell_data.items() if blocks}
    others = [at for at in range(len(thing.cells)) if at not in blocks]
    _tell("the mesh", [f"cell data `{name}` of lines and vertices" for name in thing.cell_data if others])
    starts = np.concatenate([[0], np.cumsum([len(row) for row in faces], dtype=np.int64)])
    corners = np.concatenate(faces) if faces else np.zeros(0, dtype=np.int64)
    return Mesh(
        points,
        (corners, starts),
        vertex_attributes={name: _narrow(values) for name, values in thing.point_data.items()},
        face_attributes={name: _narrow(values) for name, values in face.items()},
        loose_edges=np.concatenate(edges) if edges else None,
        loose_points=np.concatenate(singles) if singles else None,
    )


def _of_pymeshlab(thing: Any) -> Mesh:
    mesh = thing.current_mesh() if hasattr(thing, "current_mesh") else thing
    return Mesh(mesh.vertex_matrix(), mesh.face_matrix())


def _of_manifold3d(thing: Any) -> Mesh:
    mesh = thing.to_mesh() if hasattr(thing, "to_mesh") else thing
    properties = np.asarray(mesh.vert_properties)
    vertex = {"properties": properties[:, 3:]} if properties.shape[1] > 3 else {}
    return Mesh(properties[:, :3], np.asarray(mesh.tri_verts), vertex_attributes=vertex)


_READERS: Mapping[str, Callable[[Any], Mesh]] = {
    "trimesh": _of_trimesh,
    "pyvista": _of_vtk,
    "vtkmodules": _of_vtk,
    "open3d": _of_open3d,
    "meshio": _of_meshio,
    "pymeshlab": _of_pymeshlab,
    "manifold3d": _of_manifold3d,
}


def to_trimesh(mesh: Mesh, keywords: Mapping[str, Any]) -> Any:
    """A `trimesh.Trimesh`, with nothing merged."""
    import trimesh

    vertex, face = _held(mesh, "trimesh", loose=False)
    colors, face_colors, uv = vertex.pop("color", None), face.pop("color", None), vertex.pop("texcoord", None)
    made = trimesh.Trimesh(
        mesh.vertices,
        _triangles(mesh),
        vertex_colors=colors,
        face_colors=None if colors is not None else face_colors,
        vertex_attributes=vertex,
        face_attributes=face,
        **{"process": False, **keywords},
    )
    if uv is not None and colors is None and face_colors is None:
        made.visual = trimesh.visual.TextureVisuals(uv=uv)
        uv = None
    beside = ["texture coordinates beside colours"] if uv is not None else []
    beside += ["colours of faces beside those of vertices"] if colors is not None and face_colors is not None else []
    _tell("trimesh", beside)
    return made


def to_pyvista(mesh: Mesh) -> Any:
    """A `pyvista.PolyData`, faces of any size kept."""
    import pyvista

    vertex, face = _held(mesh, "PyVista", loose=True)
    sizes = np.diff(mesh.offsets)
    faces = np.insert(mesh.corners, mesh.offsets[:-1], sizes)
    lines = np.column_stack([np.full(len(mesh.loose_edges), 2), mesh.loose_edges]).reshape(-1)
    singles = np.column_stack([np.full(len(mesh.loose_points), 1), mesh.loose_points]).reshape(-1)
    given = {"faces": faces, "lines": lines, "verts": singles}
    made = pyvista.PolyData(np.array(mesh.vertices), **{name: cells for name, cells in given.items() if len(cells)})
    if not any(len(cells) for cells in given.values()):
        # Without any cell PyVista makes a vertex of each point.
        made = pyvista.PolyData()
        made.points = np.array(mesh.vertices)
    for name, values in vertex.items():
        made.point_data[name] = np.array(values)
    before = len(mesh.loose_edges) + len(mesh.loose_points)
    if before:
        _tell("PyVista", [f"`{name}` of faces, as there are loose elements, which have none" for name in face])
        return made
    for name, values in face.items():
        made.cell_data[name] = np.array(values)
    return made


def to_open3d(mesh: Mesh, tensor: bool) -> Any:
    """An `open3d.geometry.TriangleMesh`, or that of `open3d.t`."""
    import open3d

    vertex = dict(mesh.vertex_attributes)
    color, normal, uv = vertex.pop("color", None), vertex.pop("normal", None), mesh.corner_attributes.get("texcoord")
    rest = [f"`{name}`" for name in [*vertex, *mesh.face_attributes, *mesh.corner_attributes] if name != "texcoord"]
    _tell("Open3D", [*rest, *_loose(mesh)])
    made = open3d.geometry.TriangleMesh()
    made.vertices = open3d.utility.Vector3dVector(mesh.vertices)
    made.triangles = open3d.utility.Vector3iVector(_triangles(mesh))
    if color is not None:
        most = 255.0 if color.dtype == np.uint8 else 1.0
        made.vertex_colors = open3d.utility.Vector3dVector(np.asarray(color, dtype=np.float64)[:, :3] / most)
    if normal is not None:
        made.vertex_normals = open3d.utility.Vector3dVector(np.asarray(normal, dtype=np.float64))
    if uv is not None:
        made.triangle_uvs = open3d.utility.Vector2dVector(np.asarray(uv, dtype=np.float64)[:, :2])
    return open3d.t.geometry.TriangleMesh.from_legacy(made) if tensor else made


def to_meshio(mesh: Mesh) -> Any:
    """A `meshio.Mesh` with a block of cells for each run of faces of one size."""
    import meshio

    vertex, face = _held(mesh, "meshio", loose=True)
    sizes = np.diff(mesh.offsets)
    cuts = np.concatenate([[0], np.flatnonzero(np.diff(sizes)) + 1, [len(sizes)]]) if len(sizes) else np.zeros(1, dtype=int)
    cells, data = [], {name: [] for name in face}  # type: dict[str, list[Any]]
    for begin, end in zip(cuts[:-1], cuts[1:]):
        rows = mesh.corners[mesh.offsets[begin] : mesh.offsets[end]].reshape(end - begin, -1)
        cells.append(({3: "triangle", 4: "quad"}.get(int(sizes[begin]), "polygon"), rows))
        for name, values in face.items():
            data[name].append(values[begin:end])
    loose = [("line", mesh.loose_edges), ("vertex", mesh.loose_points.reshape(-1, 1))]
    loose = [(kind, rows) for kind, rows in loose if len(rows)]
    if loose and data:
        _tell("meshio", [f"`{name}` of faces, as there are loose elements, which have none" for name in data])
        data = {}
    return meshio.Mesh(mesh.vertices, [*cells, *loose], point_data=vertex, cell_data=data)


def _triangles(mesh: Mesh) -> NDArray[np.int32]:
    if not mesh.is_triangles:
        raise ValueError("a face is no triangle: repair with triangulate='all', or take another library")
    return mesh.faces


def _held(mesh: Mesh, library: str, loose: bool) -> tuple[Attributes, Attributes]:
    """The attributes of vertices and faces that a library can hold; the others are told."""
    lost = [f"`{name}` of corners" for name in mesh.corner_attributes]
    lost += [] if loose else _loose(mesh)
    kept = []
    for domain, attributes in (("vertices", mesh.vertex_attributes), ("faces", mesh.face_attributes)):
        fit = {name: values for name, values in attributes.items() if _fits(values)}
        lost += [f"`{name}` of {domain}, which is no plain array of numbers" for name in attributes if name not in fit]
        kept.append(fit)
    _tell(library, lost)
    return kept[0], kept[1]


def _fits(values: NDArray[Any]) -> bool:
    return values.dtype.kind != "O" and not isinstance(values, np.ma.MaskedArray)


def _loose(mesh: Mesh) -> list[str]:
    counts = {"loose edges": len(mesh.loose_edges), "loose points": len(mesh.loose_points)}
    return [f"{count} {what}" for what, count in counts.items() if count]


def _tell(name: str, lost: Iterable[str]) -> None:
    losses = [Loss("layer", 1, f"{what} is left out") for what in lost]
    warned(name, losses)


def _narrow(values: Any) -> NDArray[Any]:
    """Values in rows of one dimension: a column of one is a row of numbers."""
    array = np.asarray(values)
    return array[:, 0] if array.ndim == 2 and array.shape[1] == 1 else array
