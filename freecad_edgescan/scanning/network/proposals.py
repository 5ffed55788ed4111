# SPDX-License-Identifier: LGPL-2.1-or-later
"""Places where two smooth sides may meet: sections proposed all over a cloud, at several scales.

Round every node the normals of the nodes nearby are sorted by their direction across the one to
which all of them are square; where they fall into two groups, the two planes of the groups meet in
a proposed edge. Normals have no sign, so that directions are compared by their doubled angles. A
proposal is only a place to look: whether there is an edge, the patches on both sides decide.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ...cloud.cubes import one_of_each_cube
from ...cloud.point_cloud import PointCloud
from ..positive_definite import inverses
from ..section import Frames, frames_from_sides
from .nodes import Nodes, spread_nodes
from .pieces import in_pieces
from .spacing import best_apart

__all__ = ["ALONG", "SCALES", "Scale", "propose_sections"]


@dataclass(frozen=True)
class Scale:
    """How far round a place to look; lengths in pitches.

    Attributes
    ----------
    spacing : of the nodes
    neighbours : points of a node's neighbourhood
    radius : of a place
    apart : two places, roughly
    """

    spacing: float
    neighbours: int
    radius: float
    apart: float


SCALES = (Scale(1.6, 14, 4.5, 2.4), Scale(2.6, 24, 8.0, 2.6), Scale(4.5, 48, 14.0, 4.5))
ALONG = 3.5  # pitches: one proposal for a place and direction
_NEIGHBOURS = 30  # nodes of a place, at most
_FEWEST = 2  # of a group
_BY_CHANCE = 8.0  # standard deviations of a normal by which those nearby may seem to turn
_PURE = 0.3  # of the way between two groups, within which a node belongs to one of them
_ASIDE = 0.3  # of the radius, likewise
_UNEVEN = 1.6  # of what noise leaves over, that one smooth surface leaves where there is an edge
_FLAT = 0.012  # pitches, that a surface leaves over where there is no noise


def propose_sections(cloud: PointCloud, scale: Scale, min_angle: float) -> Frames:
    """Sections proposed all over a cloud, one for each place and direction.

    Parameters
    ----------
    scale : how far round a place to look
    min_angle : least turn between the two sides, rad
    """
    pitch = cloud.pitch
    nodes = spread_nodes(cloud, scale.spacing * pitch, scale.neighbours)
    # A plane through the points of a disc leans by four times noise / √points / diameter.
    chance = 2.0 * cloud.noise / pitch * np.sqrt(np.pi) / scale.neighbours
    least = max(0.5 * min_angle, _BY_CHANCE * chance)
    even = _UNEVEN * cloud.noise / np.sqrt(scale.neighbours) + _FLAT * pitch
    frames, clear = _proposed(nodes, scale.apart * pitch, scale.radius * pitch, least, even)
    return frames[best_apart(frames, -clear, ALONG * pitch, _ASIDE * scale.radius * pitch)]


def _proposed(
    nodes: Nodes, apart: float, radius: float, least: float, even: float
) -> tuple[Frames, np.ndarray]:
    """Sections, and how clearly the normals fall into two groups, 0 … 1."""
    tree = cKDTree(nodes.places, balanced_tree=False)
    count = min(_NEIGHBOURS, len(nodes))
    parts = in_pieces(
        lambda rows: _of_nodes(nodes, rows, tree, count, radius, least, even),
        one_of_each_cube(nodes.places, apart),
    )
    frames, clear = zip(*parts, strict=True)
    return Frames.join(frames), np.concatenate(clear)


def _of_nodes(
    nodes: Nodes,
    rows: np.ndarray,
    tree: cKDTree,
    count: int,
    radius: float,
    least: float,
    even: float,
) -> tuple[Frames, np.ndarray]:
    _, near = tree.query(nodes.places[rows], k=range(1, count + 1), distance_upper_bound=radius)
    there = near < len(nodes)
    near = np.where(there, near, rows[:, None])
    alike = np.abs(np.einsum("nki,ni->nk", nodes.normals[near], nodes.normals[rows]))
    turning = np.sort(alike, axis=1)[:, min(_FEWEST, count) - 1] < np.cos(least)
    rows, near, there = rows[turning], near[turning], there[turning]
    normals, places = nodes.normals[near], nodes.places[near]
    weight = there.astype(float)
    scatter = (normals * weight[..., None]).transpose(0, 2, 1) @ normals
    axes = np.linalg.eigh(scatter)[1]
    uneven = _left_over(places - nodes.places[rows][:, None], weight, axes) > even
    places, normals, weight = places[uneven], normals[uneven], weight[uneven]
    rows, there, axes = rows[uneven], there[uneven], axes[uneven]
    value = _across(normals, axes, weight)
    lowest, highest = (_outermost(value, there, sign) for sign in (-1.0, 1.0))
    share = (value - lowest[:, None]) / np.maximum(highest - lowest, 1e-12)[:, None]
    groups = [there & (share < _PURE), there & (share > 1.0 - _PURE)]
    between = there & ~groups[0] & ~groups[1]
    enough = np.minimum(groups[0].sum(axis=1), groups[1].sum(axis=1)) >= _FEWEST
    clear = 1.0 - between.sum(axis=1) / np.maximum(there.sum(axis=1), 1)
    planes = [_plane(places, normals, group.astype(float)) for group in groups]
    frames, sound = _meeting(nodes.places[rows], planes, radius, least)
    kept = enough & sound
    return frames[kept], clear[kept]


def _left_over(offsets: np.ndarray, weight: np.ndarray, axes: np.ndarray) -> np.ndarray:
    """Standard deviation of nodes about one smooth surface, a quadric through them, (n,) mm."""
    b, a, h = np.moveaxis(offsets @ axes, 2, 0)
    size = np.sqrt(np.max(weight * (a**2 + b**2 + h**2), axis=1))[:, None]
    a, b, h = a / size, b / size, h / size
    terms = np.stack([np.ones_like(a), a, b, a * a, a * b, b * b], axis=2)
    weighted = (terms * weight[..., None]).transpose(0, 2, 1)
    matrix = weighted @ terms + 1e-6 * np.eye(6)
    c = inverses(matrix) @ (weighted @ h[..., None])
    off = h - (terms @ c)[..., 0]
    free = np.maximum(weight.sum(axis=1) - 6.0, 1.0)
    few = weight.sum(axis=1) <= 7.0
    left = np.sqrt(np.einsum("nk,nk->n", weight, off**2) / free) * size[:, 0]
    return np.asarray(np.where(few, np.inf, left))


def _across(normals: np.ndarray, axes: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Where each normal stands among the others across the direction square to them, (n, k)."""
    one, other = (np.einsum("nki,ni->nk", normals, axes[:, :, k]) for k in (2, 1))
    square = np.maximum(one**2 + other**2, 1e-12)
    doubled = np.stack([(one**2 - other**2) / square, 2.0 * one * other / square], axis=-1)
    mean = np.einsum("nk,nka->na", weight, doubled) / weight.sum(axis=1)[:, None]
    doubled = doubled - mean[:, None]
    spread = (doubled * weight[..., None]).transpose(0, 2, 1) @ doubled
    main = np.linalg.eigh(spread)[1][:, :, 1]
    return np.einsum("nka,na->nk", doubled, main)


def _outermost(value: np.ndarray, there: np.ndarray, sign: float) -> np.ndarray:
    """The second outermost value of each row, (n,): one node may be an outlier."""
    ranked = np.sort(np.where(there, sign * value, -np.inf), axis=1)
    return np.asarray(sign * ranked[:, -min(_FEWEST, ranked.shape[1])])


def _plane(
    places: np.ndarray, normals: np.ndarray, weight: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Normals and centres (n, 3) of weighted nodes."""
    total = np.maximum(weight.sum(axis=1), 1e-12)
    scatter = (normals * weight[..., None]).transpose(0, 2, 1) @ normals
    normal = np.linalg.eigh(scatter)[1][:, :, 2]
    return normal, np.einsum("nk,nki->ni", weight, places) / total[:, None]


def _meeting(
    at: np.ndarray, planes: list[tuple[np.ndarray, np.ndarray]], radius: float, least: float
) -> tuple[Frames, np.ndarray]:
    """Sections where two planes meet beside some places, and which of them are near (n,)."""
    (normal_a, centre_a), (normal_b, centre_b) = planes
    tangent = np.cross(normal_a, normal_b)
    size = np.linalg.norm(tangent, axis=1)
    sound = size > np.sin(0.8 * least)
    tangent = np.where(sound[:, None], tangent, np.array([1.0, 0.0, 0.0]))
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    matrix = np.stack([normal_a, normal_b, tangent], axis=1)
    matrix[~sound] = np.eye(3)
    level = np.stack(
        [
            np.einsum("ni,ni->n", normal_a, centre_a - at),
            np.einsum("ni,ni->n", normal_b, centre_b - at),
            np.zeros(len(at)),
        ],
        axis=1,
    )
    offset = np.linalg.solve(matrix, level[..., None])[..., 0]
    sound &= np.linalg.norm(offset, axis=1) < radius
    origin = at + offset
    sides = np.stack([np.cross(tangent, normal_a), np.cross(tangent, normal_b)], axis=1)
    centres = np.stack([centre_a, centre_b], axis=1) - origin[:, None]
    towards = np.einsum("nki,nki->nk", centres, sides)
    sides *= np.where(towards < 0.0, -1.0, 1.0)[..., None]
    return frames_from_sides(origin, tangent, sides), sound
