"""VTK."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

from meshes import figures, load, stl_counts

# The tolerance of meshmend-bench.
JITTER = 0.085


def version():
    return "VTK " + vtk.vtkVersion.GetVTKVersion()


def poly_data(file):
    vertices, triangles = load(file)
    points, cells, mesh = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(vertices.astype(np.float32), deep=True))
    offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
    cells.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True)
    )
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def triangles_of(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def static_clean(tolerance):
    def weld(file, scratch):
        mesh, clean = poly_data(file), vtk.vtkStaticCleanPolyData()
        clean.SetInputData(mesh)
        clean.ToleranceIsAbsoluteOn()
        clean.SetAbsoluteTolerance(tolerance)
        yield
        clean.Update()
        yield
        return {"vertices": clean.GetOutput().GetNumberOfPoints()}

    return weld


def edges(file, scratch):
    mesh, features = poly_data(file), vtk.vtkFeatureEdges()
    features.SetInputData(mesh)
    features.BoundaryEdgesOn()
    features.NonManifoldEdgesOn()
    features.FeatureEdgesOff()
    features.ManifoldEdgesOff()
    features.ColoringOn()
    yield
    features.Update()
    yield
    found = features.GetOutput()
    kind = found.GetCellData().GetScalars()
    boundary = int((vtk_to_numpy(kind) == 0).sum()) if kind else 0
    return {"boundary_edges": boundary, "non_manifold_edges": found.GetNumberOfLines() - boundary}


def orient(file, scratch):
    mesh, sides = poly_data(file), vtk.vtkOrientPolyData()
    sides.SetInputData(mesh)
    sides.ConsistencyOn()
    sides.NonManifoldTraversalOff()
    yield
    sides.Update()
    yield
    found = sides.GetOutput()
    return figures(found.GetNumberOfPoints(), triangles_of(found), "faces", "inconsistent_edges")


def reading(make):
    def read(file, scratch):
        yield
        reader = make()
        reader.SetFileName(file)
        reader.Update()
        yield
        mesh = reader.GetOutput()
        return {"vertices": mesh.GetNumberOfPoints(), "faces": mesh.GetNumberOfPolys()}

    return read


def stl_reader(is_merging):
    def make():
        reader = vtk.vtkSTLReader()
        reader.SetMerging(is_merging)
        return reader

    return make


def writing(make, extension, make_reader=None):
    def write(file, scratch):
        mesh, path = poly_data(file), f"{scratch}/vtk.{extension}"
        yield
        writer = make()
        writer.SetInputData(mesh)
        writer.SetFileName(path)
        writer.Write()
        yield
        if extension == "stl":
            return stl_counts(path)
        reader = make_reader()
        reader.SetFileName(path)
        reader.Update()
        mesh = reader.GetOutput()
        return {"vertices": mesh.GetNumberOfPoints(), "faces": mesh.GetNumberOfPolys()}

    return write


def binary(make):
    def made():
        writer = make()
        writer.SetFileTypeToBinary()
        return writer

    return made


OPERATIONS = {
    "weld": static_clean(0.0),
    "weld-tolerance": static_clean(JITTER),
    "edges": edges,
    "edges-pinched": edges,
    "orient": orient,
    "read-ply": reading(vtk.vtkPLYReader),
    "read-ply-ascii": reading(vtk.vtkPLYReader),
    "read-obj": reading(vtk.vtkOBJReader),
    "read-stl": reading(stl_reader(False)),
    "read-stl-welded": reading(stl_reader(True)),
    "read-stl-ascii": reading(stl_reader(False)),
    "write-ply": writing(binary(vtk.vtkPLYWriter), "ply", vtk.vtkPLYReader),
    "write-stl": writing(binary(vtk.vtkSTLWriter), "stl"),
    "write-obj": writing(vtk.vtkOBJWriter, "obj", vtk.vtkOBJReader),
}
