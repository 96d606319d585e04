"""Random meshes with what the reference pipeline makes of them, one JSON object a line; not to be compared where there
are faces with holes.

    reference_cases.py REFERENCE_FOLDER FIRST_SEED COUNT
"""
import json
import random
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import repair_reference as reference  # noqa: E402

KEYS = ("faces", "source_vertex", "source_face", "flipped", "inserted", "non_orientable")
for seed in range(int(sys.argv[2]), int(sys.argv[2]) + int(sys.argv[3])):
    positions, faces = reference.random_mesh(random.Random(seed))
    case = {"seed": seed, "positions": positions, "faces": faces}
    for split in ("sheets", "cut"):
        result = reference.repair(positions, faces, split)
        case[split] = {key: result[key] for key in KEYS}
    print(json.dumps(case))
