"""A broken scan, mended from Python: what is wrong, where, what was done, and what became of the data.

Run it from anywhere: `python examples/python/walk_through.py`. Each step says what it expects, so that it fails where it is not so.
"""

# %% What is wrong?
from pathlib import Path
from tempfile import TemporaryDirectory

import meshmend as mm
import numpy as np

files = Path(__file__).resolve().parent.parent
check = mm.check(files / "broken.obj")
print(check)
assert not check.is_sound and not check.manifold

# %% Where? Defects are columns, and index the arrays of the mesh.
kinds = [kind for kind in check.counts() if check.defects[kind].severity == "defect"]
for kind in kinds:
    defects = check.defects[kind]
    places = defects.vertices if len(defects.vertices) else defects.faces
    print(f"{kind}: {len(defects)}, the first at {places[0]}")
assert sum(len(check.defects[kind]) for kind in kinds) == sum(check.counts()[kind] for kind in kinds)

# %% Mended, and what was done.
mended = mm.repair(files / "broken.obj", orient="outward")
for step in mended.passes:
    told = ", ".join(f"{kind}: {len(defects)}" for kind, defects in step.mended.items())
    print(f"{step.name:12}{told or 'nothing to do'}")
assert mended.changed and mended.after is not None and mended.after.manifold

# %% A temperature of each vertex and a label of each face come along.
before = mm.read(files / "broken.obj")
heat = before.vertices[:, 2]
labels = np.arange(len(before))
heat_after = mended.vertices.carry(heat)
labels_after = mended.faces.carry(labels, fill=-1)
same = mended.vertices.old_of_new >= 0
assert (heat_after[same] == mended.mesh.vertices[same, 2]).all()
assert set(labels) - set(labels_after) == set(mended.removed_faces.faces.tolist())
for face, reason in zip(mended.removed_faces.faces, mended.removed_faces.reasons):
    print(f"face {face} is gone: {reason}")

# %% A second run changes nothing, and what is written is what is held.
with TemporaryDirectory() as folder:
    losses = mended.write(Path(folder) / "mended.obj")
    again = mm.repair(Path(folder) / "mended.obj")
print("lost:", ", ".join(loss.message for loss in losses) or "nothing")
assert not again.changed

# %% Surfaces have handles: two paths go round this one's, two more through.
surface = mm.make("surface", genus=2, triangles=True)
for path in mm.loops(surface, greedy=True):
    print(f"{path.kind}: {path.length:.1f} long, {len(path.vertices)} vertices")
disc = mm.cut(surface).mesh
assert (surface.check().genus, disc.check().genus, disc.check().boundary_loops) == (2, 0, 1)
print("cut open:", disc)
