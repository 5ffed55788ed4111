# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of different kinds to look for all edges in: pockets, turned steps, chamfers, ribs."""

from __future__ import annotations

from typing import Any

import FreeCAD  # before Part, which ends the process otherwise
import Part

__all__ = ["varied_parts"]


def varied_parts() -> list[tuple[str, Any]]:
    """Names and shapes."""
    return [
        ("block with pockets", _block_with_pockets()),
        ("stepped shaft", _stepped_shaft()),
        ("chamfered block", _chamfered_block()),
        ("bracket with rib", _bracket_with_rib()),
        ("hexagonal frustum", _hexagonal_frustum()),
    ]


def _block_with_pockets() -> Any:
    """A rectangular pocket, a step in it, and a slot with round ends."""
    block = Part.makeBox(80.0, 60.0, 25.0)
    pocket = _box((8.0, 8.0, 10.0), (34.0, 44.0, 20.0))
    deeper = _box((16.0, 18.0, 4.0), (18.0, 24.0, 20.0))
    ends = [_cylinder((62.0, y, 12.0), 8.0, 20.0) for y in (18.0, 42.0)]
    slot = _box((54.0, 18.0, 12.0), (16.0, 24.0, 20.0))
    return block.cut(pocket).cut(deeper).cut(slot.fuse(ends)).removeSplitter()


def _stepped_shaft() -> Any:
    """Three steps, a conical one, a bore and a keyway."""
    shaft = _cylinder((0.0, 0.0, 0.0), 24.0, 14.0)
    shaft = shaft.fuse(_cylinder((0.0, 0.0, 14.0), 17.0, 26.0))
    shaft = shaft.fuse(Part.makeCone(17.0, 11.0, 8.0, FreeCAD.Vector(0.0, 0.0, 40.0)))
    shaft = shaft.fuse(_cylinder((0.0, 0.0, 48.0), 11.0, 20.0))
    bored = shaft.cut(_cylinder((0.0, 0.0, -1.0), 5.0, 80.0))
    return bored.cut(_box((13.0, -3.0, 20.0), (8.0, 6.0, 14.0))).removeSplitter()


def _chamfered_block() -> Any:
    """Chamfers round the top, a groove of two slopes across it, and a cut corner."""
    block = Part.makeBox(70.0, 50.0, 30.0)
    top = [edge for edge in block.Edges if all(v.Z > 29.0 for v in edge.Vertexes)]
    block = block.makeChamfer(5.0, top)
    groove = _prism([(29.0, 31.0), (35.0, 18.0), (41.0, 31.0)], 52.0)
    corner = Part.makeBox(60.0, 60.0, 60.0)
    corner.rotate(FreeCAD.Vector(), FreeCAD.Vector(1.0, -1.0, 0.0), 50.0)
    corner.translate(FreeCAD.Vector(62.0, 44.0, 4.0))
    return block.cut(groove).cut(corner)


def _bracket_with_rib() -> Any:
    """Two plates, a slanted rib between them, and holes through both."""
    plates = _box((0.0, 0.0, 0.0), (60.0, 50.0, 8.0)).fuse(_box((0.0, 0.0, 0.0), (8.0, 50.0, 45.0)))
    rib = _prism([(7.0, 7.0), (40.0, 7.0), (7.0, 36.0)], 8.0)
    rib.translate(FreeCAD.Vector(0.0, 21.0, 0.0))
    holes = [_cylinder((48.0, y, -1.0), 5.0, 12.0) for y in (12.0, 38.0)]
    across = Part.makeCylinder(
        6.0, 12.0, FreeCAD.Vector(-1.0, 11.0, 30.0), FreeCAD.Vector(1.0, 0.0, 0.0)
    )
    return plates.fuse(rib).cut(holes[0]).cut(holes[1]).cut(across).removeSplitter()


def _hexagonal_frustum() -> Any:
    """Six slanted sides, a slanted top, and a blind hole in it."""
    rings = [
        Part.makePolygon(
            [
                FreeCAD.Rotation(FreeCAD.Vector(0.0, 0.0, 1.0), 60.0 * k).multVec(
                    FreeCAD.Vector(radius, 0.0, height)
                )
                for k in (*range(6), 0)
            ]
        )
        for radius, height in ((30.0, 0.0), (20.0, 40.0))
    ]
    frustum = Part.makeLoft(rings, True, True)
    above = Part.makeBox(100.0, 100.0, 40.0, FreeCAD.Vector(-50.0, -50.0, 0.0))
    above.rotate(FreeCAD.Vector(), FreeCAD.Vector(0.0, 1.0, 0.0), 12.0)
    above.translate(FreeCAD.Vector(0.0, 0.0, 32.0))
    return frustum.cut(above).cut(_cylinder((0.0, 0.0, 18.0), 9.0, 40.0))


def _box(corner: tuple[float, float, float], size: tuple[float, float, float]) -> Any:
    return Part.makeBox(*size, FreeCAD.Vector(*corner))


def _cylinder(base: tuple[float, float, float], radius: float, height: float) -> Any:
    return Part.makeCylinder(radius, height, FreeCAD.Vector(*base))


def _prism(outline: list[tuple[float, float]], depth: float) -> Any:
    """An outline in x and z, from y = −1 on."""
    corners = [FreeCAD.Vector(x, -1.0, z) for x, z in [*outline, outline[0]]]
    return Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0.0, depth, 0.0))
