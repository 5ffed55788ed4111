# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

from freecad_edgescan.scanning.edge_path import EdgePath
from freecad_edgescan.scanning.section import frames_from_sides
from freecad_edgescan.scanning.stop import Stop
from freecad_edgescan.scanning.strip import strip_points


def straight_path(part, at):
    many = len(at)
    frames = frames_from_sides(
        part.middle + at[:, None] * part.along,
        np.tile(part.along, (many, 1)),
        np.tile(part.sides, (many, 1, 1)),
    )
    return EdgePath(frames, at - at[0], at[-1] - at[0], False, (Stop.CLOUD_END, Stop.CORNER))


def test_every_point_of_a_strip_lies_in_the_sections_whose_slabs_hold_it(wedge):
    part = wedge(100.0, noise=0.0)
    at = np.cumsum(np.resize([1.0, 0.6, 1.4], 24)) - 12.0
    found = strip_points(part.cloud, straight_path(part, at), 5.0, 0.8)
    place = part.place_along(part.cloud.points)
    near = np.flatnonzero(part.distance(part.cloud.points) < 5.0)
    within = np.abs(place[near][:, None] - at) < 0.8
    wanted = {(near[i], j) for i, j in np.argwhere(within)}
    assert set(zip(found.index.tolist(), found.owner.tolist(), strict=True)) == wanted
    assert len(found.index) == len(wanted)
    assert np.abs(found.height).max() < 1e-9


def test_strips_of_closed_edges_join_their_ends(can):
    part = can(noise=0.0)
    turns = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    origin = np.array([part.on_rim(t) for t in turns])
    radial = (origin - part.centre) / part.radius
    tangent = np.cross(part.axis, radial)
    tangent *= np.sign(np.einsum("ij,ij->i", tangent, np.roll(origin, -1, 0) - origin))[:, None]
    sides = np.stack([-radial, np.tile(-part.axis, (40, 1))], axis=1)
    frames = frames_from_sides(origin, tangent, sides, -radial / part.radius)
    path = EdgePath(
        frames, turns * part.radius, 2 * np.pi * part.radius, True, (Stop.CLOSED, Stop.CLOSED)
    )
    found = strip_points(part.cloud, path, 4.0, 1.2)
    count = np.bincount(found.owner, minlength=40)
    assert count.min() > 0.7 * count.max()
    assert np.abs(found.height).max() < 1e-9
    assert (np.abs(found.along) <= 1.2).all()
