# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject

# R, x, θ in degrees, R_f, R_p, A, ρ_c, η: rows of the published experiments (1.1, 1.4, 2.16,
# 3.1, 5.8, 7.2, 9.15, 10.14, 12.11) and two sharp objects of our own
ROWS = [
    (10, 35, 100, 0.3, 0.5, 4, 0.2, 0.01),
    (8, 30, 110, 0.3, 0.5, 6, 0.1, 0.01),
    (10, 30, 110, 1.0, 0.5, 6, 0.25, 0.02),
    (20, 150, 90, 2.0, 2.0, 10, 0.36, 0.02),
    (75, 100, 120, 3.0, 2.0, 30, 1.0, 0.1),
    (75, 150, 120, 2.0, 1.0, 30, 1.0, 0.05),
    (150, 150, 120, 4.0, 1.0, 35, 0.5, 0.2),
    (350, 250, 140, 2.0, 1.0, 40, 1.0, 0.2),
    (500, 350, 150, 4.0, 1.0, 40, 1.0, 0.1),
    (15, 35, 60, 0.0, 0.0, 8, 0.3, 0.0),
    (15, 35, 90, 0.0, 1.0, 8, 0.3, 0.0),
]


def build(row):
    section, edge, angle, fillet, probe = row[:5]
    return TorusObject(section, edge, np.radians(angle), fillet, probe)


def section_centres(section, edge, angle):
    """Centres (ρ, z) of both sections, from geometry alone: the tubes' circles pass through the
    edge, the first from straight above, the second turned by π - θ round the edge."""
    corner = np.array([edge, -section], dtype=float)
    turn = np.pi - np.radians(angle)
    up = np.array([0, section])
    second = corner + section * np.array([-np.sin(turn), np.cos(turn)])
    return corner, corner + up, second


def in_half_plane(points):
    return np.column_stack([np.hypot(points[:, 0], points[:, 1]), points[:, 2]])


@pytest.mark.parametrize("row", ROWS)
def test_every_point_lies_on_the_torus_of_its_label(row):
    section, edge, angle, _, probe, amplitude, pitch, _ = row
    _, first, second = section_centres(section, edge, angle)
    cloud = build(row).cloud(3 * pitch, amplitude)
    flat = in_half_plane(cloud.points)
    for label, centre in ((0, first), (1, second)):
        distance = np.linalg.norm(flat[cloud.labels == label] - centre, axis=1)
        assert np.abs(distance - (section - probe)).max() < 1e-9
    azimuth = np.arctan2(cloud.points[:, 1], cloud.points[:, 0]) % (2 * np.pi)
    assert not ((azimuth > np.pi + 0.1 + 1e-9) & (azimuth < 2 * np.pi - 0.1 - 1e-9)).any()
    assert cloud.probe_radius == probe


@pytest.mark.parametrize("row", ROWS)
def test_the_rounding_is_tangent_to_both_tori(row):
    section, edge, angle, fillet, probe, amplitude = row[:6]
    _, first, second = section_centres(section, edge, angle)
    faces = build(row).faces(amplitude)
    if fillet + probe == 0:
        assert [face.name for face in faces] == ["outer", "inner"]
        return
    outer, inner, rounding = faces
    centre = np.array([rounding.major_radius, rounding.centre_height])
    for face, middle, v, w in (
        (outer, first, outer.v0, rounding.v0),
        (inner, second, inner.v1, rounding.v1),
    ):
        assert np.linalg.norm(centre - middle) == pytest.approx(section + fillet)
        touch, end = face.points(v, 0.3), rounding.points(w, 0.3)
        assert touch == pytest.approx(end, abs=1e-9)
        direction = (in_half_plane(touch[None])[0] - middle) / (section - probe)
        assert direction == pytest.approx((centre - middle) / (section + fillet), abs=1e-12)


@pytest.mark.parametrize("row", ROWS)
def test_rounding_length_follows_equation_5_2_1_1(row):
    section, _, angle, fillet, probe, amplitude = row[:6]
    phi = np.arcsin(section * np.sin((np.pi - np.radians(angle)) / 2) / (section + fillet))
    torus = build(row)
    assert torus.rounding_length == pytest.approx(2 * phi * (probe + fillet), abs=1e-12)
    if fillet + probe > 0:
        rounding = torus.faces(amplitude)[2]
        assert rounding.section_radius * (rounding.v1 - rounding.v0) == pytest.approx(
            torus.rounding_length
        )


@pytest.mark.parametrize("row", ROWS)
def test_the_faces_meet_in_the_edge_circle_under_the_angle_of_the_wedge_of_material(row):
    section, edge, angle = row[:3]
    corner, first, second = section_centres(section, edge, angle)
    (true,) = build(row).edges
    assert np.abs(in_half_plane(true.points) - corner).max() < 1e-9
    assert np.allclose(true.angle, np.radians(angle))
    assert true.convex is True
    # outward normals of the material point into the air, to the tubes' centres
    turn = np.arccos((first - corner) @ (second - corner) / section**2)
    assert turn == pytest.approx(np.pi - np.radians(angle), abs=1e-7)
    assert np.abs(np.einsum("ij,ij->i", true.tangents, true.points)).max() < 1e-9
    middle = (true.points[1:] + true.points[:-1]) / 2
    assert np.abs(np.hypot(middle[:, 0], middle[:, 1]) - edge).max() < 1e-5


def test_a_sharp_object_without_a_probe_is_its_two_faces():
    cloud = TorusObject(15, 35, np.radians(60)).cloud(0.3, 8)
    assert cloud.face_names == ("outer", "inner")
    assert cloud.edges[0].distance(cloud.points).min() < 0.16


def test_touching_balls_clear_the_material_by_their_radius():
    """The ball's centre, seen from the uncompensated faces, is one probe radius away in the air."""
    bare = TorusObject(20, 40, np.radians(110), 1.0, 0.0)
    probed = TorusObject(20, 40, np.radians(110), 1.0, 1.5)
    surface, centres = bare.cloud(0.05, 20).points, probed.cloud(0.5, 10).points
    quarter = np.abs(np.arctan2(centres[:, 1], centres[:, 0]) - 1.0) < 0.05
    near = np.abs(np.arctan2(surface[:, 1], surface[:, 0]) - 1.0) < 0.15
    gaps = np.linalg.norm(surface[near][None] - centres[quarter][::7, None], axis=2).min(axis=1)
    assert np.abs(gaps - 1.5).max() < 1e-3


def test_the_cloud_reaches_half_an_amplitude_and_four_pitches_beyond_the_rounding():
    torus = TorusObject(20, 150, np.radians(90), 2.0, 1.0)
    cloud = torus.cloud(0.5, 10)
    outer, inner, _ = torus.faces(10 / 2 + 4 * 0.5)
    for label, face, end in ((0, outer, outer.v1), (1, inner, inner.v0)):
        last = in_half_plane(face.points(end, 0.0)[None])
        rest = np.linalg.norm(in_half_plane(cloud.points[cloud.labels == label]) - last, axis=1)
        assert rest.min() < 0.5


def test_spacing_is_the_pitch_in_both_directions():
    cloud = TorusObject(20, 100, np.radians(120), 2.0, 1.0).cloud(0.4, 12)
    assert cloud.pitch == pytest.approx(0.4, rel=0.15)
    nearest = cloud.tree.query(cloud.points[::5], k=3)[0][:, 1:]
    assert nearest[:, 0].max() < 0.401
    assert np.median(nearest) == pytest.approx(0.4, rel=0.02)


def test_noise_is_uniform_within_its_level_on_each_coordinate_and_repeats_with_the_seed():
    torus = TorusObject(20, 50, np.radians(110), 1.0, 1.0)
    exact = torus.cloud(0.3, 10).points
    noisy = torus.cloud(0.3, 10, noise=0.05, seed=[0, 3, 7])
    errors = noisy.points - exact
    assert np.abs(errors).max() <= 0.05
    assert errors.std(axis=0) == pytest.approx(np.full(3, 0.05 / np.sqrt(3)), rel=0.02)
    assert np.abs(np.corrcoef(errors.T) - np.eye(3)).max() < 0.02
    assert np.array_equal(noisy.points, torus.cloud(0.3, 10, noise=0.05, seed=[0, 3, 7]).points)
    assert not np.array_equal(noisy.points, torus.cloud(0.3, 10, noise=0.05, seed=1).points)


@pytest.mark.parametrize("row", ROWS)
def test_start_and_gate_lie_on_the_outer_face_half_an_amplitude_from_the_edge(row):
    section, edge, angle, _, probe, amplitude = row[:6]
    _, first, _ = section_centres(section, edge, angle)
    torus = build(row)
    point, across, along = torus.start(amplitude)
    assert np.arctan2(point[1], point[0]) == pytest.approx(0.1)
    assert np.linalg.norm(in_half_plane(point[None])[0] - first) == pytest.approx(section - probe)
    outer = torus.faces(amplitude)[0]
    turn = (amplitude - torus.rounding_length) / 2 / (section - probe)
    assert point == pytest.approx(outer.points(outer.v0 + turn, 0.1))
    towards = torus.edges[0].nearest(point[None])[0] - point
    assert across @ towards > 0.85 * np.linalg.norm(towards)
    assert [np.linalg.norm(across), across @ along] == pytest.approx([1.0, 0.0], abs=1e-12)
    gate, inwards = torus.gate(amplitude)
    assert np.arctan2(gate[1], gate[0]) == pytest.approx(np.pi - 0.1)
    passed = gate + inwards * (np.hypot(gate[0], gate[1]) - edge)
    assert 0 < (passed - gate) @ inwards < amplitude
    assert passed[:2] == pytest.approx(edge * np.array([-np.cos(0.1), np.sin(0.1)]))


def test_a_start_on_a_wide_rounding_is_on_the_rounding():
    torus = TorusObject(20, 50, np.radians(90), 3.0, 2.0)
    point, across, _ = torus.start(0.5 * torus.rounding_length)
    rounding = torus.faces(1.0)[2]
    centre = np.array([rounding.major_radius, rounding.centre_height])
    arm = in_half_plane(point[None])[0] - centre
    assert np.linalg.norm(arm) == pytest.approx(5.0)
    radial = across[:2] @ point[:2] / np.linalg.norm(point[:2])
    assert np.array([radial, across[2]]) @ arm == pytest.approx(0.0, abs=1e-9)
    assert radial < 0


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"section_radius": -1.0}, "section radius is -1.0 mm"),
        ({"edge_radius": np.nan}, "edge radius is nan mm"),
        ({"fillet_radius": -0.5}, "fillet radius is -0.5 mm"),
        ({"angle": 110.0}, "not degrees"),
        ({"probe_radius": 20.0}, "does not fit into tubes of radius 20"),
    ],
)
def test_impossible_objects_are_refused_with_the_value(change, sentence):
    values = {"section_radius": 20.0, "edge_radius": 50.0, "angle": 2.0} | change
    with pytest.raises(ValueError, match=sentence):
        TorusObject(**values)


def test_impossible_clouds_are_refused_with_the_value():
    torus = TorusObject(10, 12, np.radians(90))
    with pytest.raises(ValueError, match="pitch is 0"):
        torus.cloud(0, 4)
    with pytest.raises(ValueError, match="noise level is -1"):
        torus.cloud(0.5, 4, noise=-1)
    with pytest.raises(ValueError, match=r"cannot reach .* take a smaller amplitude"):
        torus.cloud(0.5, 40)
