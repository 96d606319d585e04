"""MeshLab."""

from importlib.metadata import version as installed

import pymeshlab

from meshes import figures, load, stl_counts


def version():
    return "MeshLab " + installed("pymeshlab")


def mesh_set(file):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*load(file)))
    return meshes


def counts(meshes):
    mesh = meshes.current_mesh()
    return {"vertices": mesh.vertex_number(), "faces": mesh.face_number()}


def edge_figures(meshes, *names):
    mesh = meshes.current_mesh()
    return figures(mesh.vertex_number(), mesh.face_matrix(), *names)


def filtering(*filters):
    """Applies filters one after another."""

    def apply(meshes):
        for name in filters:
            getattr(meshes, name)()

    return apply


WELD = filtering("meshing_remove_duplicate_vertices")
CLEAN = filtering(
    "meshing_remove_duplicate_faces", "meshing_remove_null_faces", "meshing_remove_unreferenced_vertices"
)
ORIENT = filtering("meshing_re_orient_faces_coherently")
SPLIT = filtering("meshing_repair_non_manifold_edges", "meshing_repair_non_manifold_vertices")


def weld(file, scratch):
    meshes = mesh_set(file)
    yield
    WELD(meshes)
    yield
    return {"vertices": meshes.current_mesh().vertex_number()}


def clean(file, scratch):
    meshes = mesh_set(file)
    yield
    CLEAN(meshes)
    yield
    return counts(meshes)


def orient(file, scratch):
    meshes = mesh_set(file)
    yield
    ORIENT(meshes)
    yield
    return edge_figures(meshes, "faces", "inconsistent_edges")


def report(file, scratch):
    meshes = mesh_set(file)
    yield
    found = meshes.get_topological_measures()
    yield
    return {
        "edges": int(found["edges_number"]),
        "components": int(found["connected_components_number"]),
        "genus": int(found["genus"]),
    }


def intersections(file, scratch):
    meshes = mesh_set(file)
    yield
    meshes.compute_selection_by_self_intersections_per_face()
    yield
    return {"crossing_faces": meshes.current_mesh().selected_face_number()}


def fill(file, scratch):
    meshes = mesh_set(file)
    # Loose vertices are no part of the work.
    meshes.meshing_remove_unreferenced_vertices()
    yield
    meshes.meshing_close_holes(maxholesize=64)
    yield
    return edge_figures(meshes, "boundary_edges", "non_manifold_edges")


def process(file, scratch):
    yield
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(file)
    WELD(meshes)
    CLEAN(meshes)
    SPLIT(meshes)
    ORIENT(meshes)
    path = f"{scratch}/meshlab.ply"
    meshes.save_current_mesh(path)
    yield
    again = pymeshlab.MeshSet()
    again.load_new_mesh(path)
    return edge_figures(again, "vertices", "faces", "inconsistent_edges", "non_manifold_edges")


def read(file, scratch):
    yield
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(file)
    yield
    return counts(meshes)


def writing(extension):
    def write(file, scratch):
        meshes, path = mesh_set(file), f"{scratch}/meshlab.{extension}"
        yield
        meshes.save_current_mesh(path)
        yield
        if extension == "stl":
            return stl_counts(path)
        again = pymeshlab.MeshSet()
        again.load_new_mesh(path)
        return counts(again)

    return write


OPERATIONS = {
    "weld": weld,
    "report": report,
    "orient": orient,
    "clean": clean,
    "intersections": intersections,
    "intersections-crossed": intersections,
    "fill-12": fill,
    "fill-32": fill,
    "process-ply": process,
    "process-stl": process,
    "read-ply": read,
    "read-ply-ascii": read,
    "read-obj": read,
    "read-off": read,
    "read-stl-welded": read,
    "write-ply": writing("ply"),
    "write-obj": writing("obj"),
    "write-off": writing("off"),
    "write-stl": writing("stl"),
}
