# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from freecad_edgescan.scanning.section import Frames, frames_from_sides, section_points

TURN = Rotation.random(random_state=4)
PLACE = np.array([7.0, -3.0, 2.0])


def circle_frames(radius, azimuths, sides=((1, 1), (-1, 0.3)), turn=TURN, place=PLACE):
    """Sections on a circle about z; sides as (radial, axial) directions."""
    azimuths = np.asarray(azimuths, dtype=float)
    radial = np.column_stack([np.cos(azimuths), np.sin(azimuths), np.zeros(len(azimuths))])
    tangent = np.column_stack([-radial[:, 1], radial[:, 0], np.zeros(len(azimuths))])
    up = np.array([0.0, 0.0, 1.0])
    two = np.stack([r * radial + z * up for r, z in sides], axis=1)
    return frames_from_sides(
        turn.apply(radius * radial) + place,
        turn.apply(tangent),
        np.stack([turn.apply(two[:, k]) for k in range(2)], axis=1),
        turn.apply(-radial / radius),
    )


def torus_points(radius, offsets, azimuths, turn=TURN, place=PLACE):
    """Points at (radial, axial) offsets from a circle, at azimuths."""
    radial, axial = np.asarray(offsets, dtype=float).T
    rho = radius + radial
    points = np.column_stack([rho * np.cos(azimuths), rho * np.sin(azimuths), axial])
    return turn.apply(points) + place


def test_frames_stand_square_and_their_normals_point_out_of_the_smaller_wedge():
    rng = np.random.default_rng(1)
    frames = frames_from_sides(
        rng.normal(size=(50, 3)), rng.normal(size=(50, 3)), rng.normal(size=(50, 2, 3))
    )
    axes = np.stack(
        [np.broadcast_to(frames.tangent[:, None], frames.sides.shape), frames.sides, frames.normals]
    )
    gram = np.einsum("amki,bmki->mkab", axes, axes)
    assert gram == pytest.approx(np.broadcast_to(np.eye(3), gram.shape), abs=1e-12)
    # Out of the wedge: each side lies behind the other's normal.
    behind = np.einsum("mki,mki->mk", frames.normals, frames.sides[:, ::-1])
    assert (behind < 0).all()


@pytest.mark.parametrize("degrees", [30, 90, 165])
def test_the_turn_is_what_the_wedge_lacks_to_a_flat_surface(degrees):
    half = np.radians(degrees) / 2
    sides = np.array([[[0, np.sin(half), -np.cos(half)], [0, -np.sin(half), -np.cos(half)]]])
    frames = frames_from_sides(np.zeros((1, 3)), np.array([[1.0, 0, 0]]), sides)
    assert frames.turn == pytest.approx([np.pi - 2 * half])


def test_a_torus_point_has_its_arc_along_and_its_own_place_in_the_section():
    """On a torus round the edge's axis nothing but u changes along the edge."""
    radius, rng = 20.0, np.random.default_rng(2)
    frames = circle_frames(radius, [0.4])
    azimuth = 0.4 + rng.uniform(-0.6, 0.6, 200)
    points = torus_points(radius, np.tile([2.0, 1.5], (200, 1)), azimuth)
    found = section_points(frames, np.zeros(200, int), np.arange(200), points)
    assert found.along == pytest.approx(radius * (azimuth - 0.4), abs=1e-9)
    # (2, 1.5) in the frame of the first side, which runs along (1, 1)/√2.
    assert (found.side == 0).all()
    assert found.away == pytest.approx(np.full(200, 3.5 / np.sqrt(2)), abs=1e-9)
    assert np.abs(found.height) == pytest.approx(np.full(200, 0.5 / np.sqrt(2)), abs=1e-9)


@pytest.mark.parametrize("radius", [3.0, 50.0, 1e5, 1e9])
def test_section_coordinates_are_the_offsets_from_the_edge_for_every_radius(radius):
    rng = np.random.default_rng(3)
    offsets = rng.uniform(-1.5, 1.5, (300, 2))
    along = rng.uniform(-1.0, 1.0, 300)
    turn, place = Rotation.identity(), np.array([-radius, 0.0, 0.0])
    frames = circle_frames(radius, [0.0], turn=turn, place=place)
    points = torus_points(radius, offsets, along / radius, turn, place)
    found = section_points(frames, np.zeros(300, int), np.arange(300), points)
    assert len(found.index) == 300
    assert found.along == pytest.approx(along, abs=1e-6)
    pick = found.side
    away, height = found.away[:, None], found.height[:, None]
    back = away * frames.sides[0, pick] + height * frames.normals[0, pick]
    assert back[:, [0, 2]] == pytest.approx(offsets, abs=1e-6)


def test_on_a_straight_edge_section_coordinates_are_plain_ones():
    rng = np.random.default_rng(5)
    points = rng.normal(size=(100, 3))
    sides = np.array([[[0, 1.0, 0], [0, 0, 1.0]]])
    frames = frames_from_sides(np.zeros((1, 3)), np.array([[1.0, 0, 0]]), sides)
    found = section_points(frames, np.zeros(100, int), np.arange(100), points)
    assert found.along == pytest.approx(points[:, 0])
    assert found.away == pytest.approx(points[:, 1:].max(axis=1))
    assert (found.side == (points[:, 2] > points[:, 1])).all()


def test_points_beyond_the_centre_of_curvature_belong_to_no_section():
    frames = circle_frames(5.0, [0.0])
    points = torus_points(5.0, [[-4.9, 0], [-6.0, 0], [-2.0, 0]], np.zeros(3))
    found = section_points(frames, np.zeros(3, int), np.arange(3), points)
    assert found.index.tolist() == [2]


def test_joined_sections_are_the_same_sections():
    frames = circle_frames(5.0, [0.0, 0.2, 0.4])
    again = Frames.join([frames[0], frames[1:]])
    for name in ("origin", "tangent", "sides", "normals", "bend", "curvature"):
        assert np.array_equal(getattr(again, name), getattr(frames, name))
    assert len(frames[-1]) == 1
    assert np.array_equal(frames[-1].origin, frames.origin[2:])


def test_probe_centres_roll_over_a_rim_within_the_touching_points_of_the_ball(wedge):
    """A ball of radius R round a sharp edge touches the moved sides R·tan(turn/2) from their
    meeting line."""
    part = wedge(60.0, noise=0.0, rounding=1.5)
    frames = frames_from_sides(part.middle[None], part.along[None], part.sides[None])
    assert frames.rolled_over(1.5) == pytest.approx([1.5 / np.tan(np.radians(30))])
