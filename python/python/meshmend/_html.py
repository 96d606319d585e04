"""Meshes, checks and repairs as notebooks show them: tables and a picture, without scripts or anything from elsewhere."""

from __future__ import annotations

import base64
import html
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._check import Check
    from ._mesh import Mesh
    from ._repair import Repair

# A picture of more faces would make the answer of a cell wait.
_MOST_FACES = 200_000
_COLOURS = {"defect": "#b00020", "note": "#5f6368"}
_TABLE = "border-collapse:collapse;margin:4px 12px 4px 0;display:inline-block;vertical-align:top"


def of_mesh(mesh: Mesh) -> str:
    """Counts, layers and a picture."""
    layers = [*mesh.vertex_attributes, *mesh.face_attributes, *mesh.corner_attributes]
    rows = [("vertices", len(mesh.vertices)), ("faces", len(mesh)), ("format", mesh.format or "arrays")]
    return _page("Mesh", _table([*rows, ("attributes", ", ".join(layers) or "none")]), _picture(mesh))


def of_check(check: Check) -> str:
    """What a mesh is, what is wrong with it, and where."""
    facts = check.to_dict(0)
    verdict = "sound" if check.is_sound else "not sound"
    return _page(f"{facts['file'] or 'Mesh'}: {verdict}", _figures(facts), _defects(check), _picture(check.mesh))


def of_repair(repair: Repair) -> str:
    """What was done, and what is left."""
    if repair._is_of_parts():
        rows = [(title, "changed" if part.changed else "unchanged") for title, part in repair.parts.items()]
        return _page("Repair", _table([*rows, *repair.kept.items()]))
    passes = [(record.name, _mended(record.mended, record.changed)) for record in repair.passes]
    removed = [("faces removed", len(repair.removed_faces.faces)), ("faces turned", len(repair.flipped))]
    left = _defects(repair.after) if repair.after is not None else ""
    state = "changed" if repair.changed else "nothing to do"
    return _page(f"Repair: {state}", _table([*passes, *removed]), left, _picture(repair.mesh))


def _figures(facts: Mapping[str, object]) -> str:
    names = ("vertices", "edges", "faces", "components", "euler_characteristic", "boundary_loops", "genus", "manifold", "closed")
    return _table((name.replace("_", " "), _shown(facts[name])) for name in names)


def _defects(check: Check) -> str:
    """A row for each kind that occurs, with its severity in colour and in words, and what it means."""
    rows = []
    for kind, count in check.counts().items():
        defects = check.defects[kind]
        colour = _COLOURS[defects.severity]
        meaning = f"<details><summary>what is that?</summary>{html.escape(defects.explanation)}</details>"
        severity = f'<span style="color:{colour}">{html.escape(defects.severity)}</span>'
        rows.append(f"<tr><td>{severity}</td><td>{count}</td><td>{html.escape(defects.title)}{meaning}</td></tr>")
    return f'<table style="{_TABLE}">{"".join(rows)}</table>' if rows else ""


def _mended(mended: Mapping[str, object], changed: bool) -> str:
    told = ", ".join(f"{kind}: {len(defects)}" for kind, defects in mended.items())  # type: ignore[arg-type]
    return told or ("changed" if changed else "nothing to do")


def _shown(value: object) -> str:
    if value is None:
        return "not defined"
    return {True: "yes", False: "no"}[value] if isinstance(value, bool) else str(value)


def _table(rows: Iterable[tuple[str, object]]) -> str:
    cells = (f"<tr><th>{html.escape(name)}</th><td>{html.escape(str(value))}</td></tr>" for name, value in rows)
    return f'<table style="{_TABLE}">{"".join(cells)}</table>'


def _picture(mesh: Mesh) -> str:
    if not 0 < len(mesh) <= _MOST_FACES:
        return ""
    try:
        drawn = base64.b64encode(mesh.picture()).decode("ascii")
    except ValueError as reason:
        return f"<p>no picture: {html.escape(str(reason))}</p>"
    return f'<img alt="the mesh, with what is wrong marked" src="data:image/png;base64,{drawn}">'


def _page(title: str, *parts: str) -> str:
    return f"<div><strong>{html.escape(title)}</strong><br>{''.join(parts)}</div>"
