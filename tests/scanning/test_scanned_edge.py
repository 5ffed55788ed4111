# SPDX-License-Identifier: LGPL-2.1-or-later
import csv
import dataclasses

import numpy as np
import pytest

from freecad_edgescan.cloud import TorusObject
from freecad_edgescan.scanning import scan_edge

NOISE = 0.02


@pytest.fixture(scope="module")
def filleted(wedge):
    part = wedge(100.0, rounding=1.5)
    return part, scan_edge(part.cloud, part.at(0.1, 0.4))


def test_every_array_has_one_row_for_each_edge_point(right_angle):
    edge = right_angle[1]
    many = len(edge)
    shapes = {
        "points": (many, 3),
        "tangents": (many, 3),
        "normals": (many, 2, 3),
        "angle": (many,),
        "covariance": (many, 2, 2),
        "fillet_radius": (many,),
        "fillet_sigma": (many,),
        "sigma": (many,),
        "supported": (many,),
        "compensation": (many,),
        "covariance_3d": (many, 3, 3),
    }
    for name, shape in shapes.items():
        assert getattr(edge, name).shape == shape, name
    assert edge.supported.dtype == bool
    assert len(edge.scan_lines) == many
    assert np.linalg.norm(edge.tangents, axis=1) == pytest.approx(np.ones(many))
    assert np.linalg.norm(edge.normals, axis=2) == pytest.approx(np.ones((many, 2)))
    # A tangent lies in both surfaces.
    along = np.einsum("mki,mi->mk", edge.normals, edge.tangents)
    assert along == pytest.approx(np.zeros((many, 2)), abs=1e-9)


def test_an_edge_cannot_be_changed(right_angle):
    with pytest.raises(dataclasses.FrozenInstanceError):
        right_angle[1].points = None


def test_the_length_is_that_of_the_polyline(right_angle):
    edge = right_angle[1]
    steps = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
    assert edge.length == pytest.approx(steps.sum())


def test_covariance_in_space_is_that_across_the_edge(right_angle):
    """No variance along the edge, and the same in every direction across it."""
    edge = right_angle[1]
    value = np.linalg.eigvalsh(edge.covariance_3d)
    assert value[:, 0] == pytest.approx(np.zeros(len(edge)), abs=1e-12)
    assert value[:, 1:] == pytest.approx(np.linalg.eigvalsh(edge.covariance), rel=1e-6)
    along = np.cross(edge.normals[:, 0], edge.normals[:, 1])
    flat = np.einsum("mi,mij,mj->m", along, edge.covariance_3d, along)
    assert flat == pytest.approx(np.zeros(len(edge)), abs=1e-12)


def test_a_table_of_the_edge_holds_what_the_edge_holds(filleted, tmp_path):
    edge = filleted[1]
    path = tmp_path / "edge.csv"
    edge.to_csv(path)
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(edge)

    def column(*names):
        return np.array([[float(row[name]) for name in names] for row in rows]).squeeze()

    assert column("x_mm", "y_mm", "z_mm") == pytest.approx(edge.points, abs=1e-6)
    assert column("sigma_mm") == pytest.approx(edge.sigma, abs=1e-6)
    tangents = column("tangent_x", "tangent_y", "tangent_z")
    assert tangents == pytest.approx(edge.tangents, abs=1e-6)
    assert np.radians(column("angle_deg")) == pytest.approx(edge.angle, abs=1e-7)
    assert column("fillet_radius_mm") == pytest.approx(edge.fillet_radius, abs=1e-6, nan_ok=True)
    assert column("fillet_sigma_mm") == pytest.approx(edge.fillet_sigma, abs=1e-6, nan_ok=True)
    assert np.array_equal(column("supported").astype(bool), edge.supported)


def test_a_table_can_be_written_where_a_plain_string_says(right_angle, tmp_path):
    right_angle[1].to_csv(str(tmp_path / "edge.csv"))
    assert (tmp_path / "edge.csv").stat().st_size > 1000


def test_the_curve_lies_nearer_to_the_edge_than_its_points(right_angle):
    part, edge = right_angle
    curve = edge.curve()
    sample = curve.sample(200)
    assert part.distance(sample).mean() < part.distance(edge.unsmoothed.points).mean()
    assert part.distance(sample).max() < 2 * NOISE
    low, high = curve.parameter_range
    ends = part.place_along(np.array([curve.evaluate(low), curve.evaluate(high)]))
    assert ends == pytest.approx(part.place_along(edge.points[[0, -1]]), abs=0.05)
    assert len(curve.poles) <= 8


def test_a_tolerance_bounds_the_distance_of_the_points_from_the_curve(right_angle):
    edge = right_angle[1]
    wide, narrow = edge.curve(tolerance=0.1), edge.curve(tolerance=0.01)
    for curve, tolerance in ((wide, 0.1), (narrow, 0.01)):
        u, _ = curve.closest(edge.points)
        away = np.linalg.norm(curve.evaluate(u) - edge.points, axis=1)
        assert away.max() <= tolerance * 1.001
    assert len(narrow.poles) >= len(wide.poles)


def test_scan_lines_show_the_clouds_own_points(right_angle):
    """On a straight edge a scan line's plane coordinates are those of the points in space."""
    part, edge = right_angle
    lines = edge.scan_lines
    for j in (0, len(edge) // 2, -1):
        line = lines[j]
        assert line.axes @ line.axes.T == pytest.approx(np.eye(2), abs=1e-12)
        assert line.axes @ lines.frames.tangent[j] == pytest.approx([0, 0], abs=1e-12)
        index = lines.points.index[lines.points.owner == j % len(edge)]
        flat = (part.cloud.points[index] - line.origin) @ line.axes.T
        assert line.points == pytest.approx(flat, abs=5e-3)
        assert len(line.side) == len(line.removed) == len(line.points)


def test_scan_lines_show_the_edge_points(right_angle):
    _, edge = right_angle
    for j in range(len(edge)):
        line = edge.scan_lines[j]
        assert line.origin + line.edge_point @ line.axes == pytest.approx(edge.points[j], abs=1e-9)
        meeting = line.origin + line.meeting_point @ line.axes
        assert meeting == pytest.approx(edge.unsmoothed.points[j], abs=1e-9)


def test_with_a_probe_the_sides_meet_one_radius_away_from_both_surfaces(wedge):
    radius, degrees = 1.0, 80.0
    far = radius / np.sin(np.radians(degrees) / 2)
    part = wedge(degrees, rounding=radius, raised=far, probe_radius=radius, approach=(0, 0, -1))
    edge = scan_edge(part.cloud, part.at(0.1, 0.4))
    gap = [np.linalg.norm(line.meeting_point - line.edge_point) for line in edge.scan_lines]
    assert gap == pytest.approx(np.full(len(edge), far), abs=0.02)


def test_the_fitted_sides_run_through_the_points_that_were_kept(filleted):
    """And those that were left out are the rounding's, strays, or beyond the stretch."""
    edge = filleted[1]
    for line in list(edge.scan_lines)[3:-3:4]:
        for k in range(2):
            kept = line.points[(line.side == k) & ~line.removed]
            curve = line.curves[k]
            direction = curve[-1] - curve[0]
            direction /= np.linalg.norm(direction)
            beside = (kept - curve[0]) @ np.array([-direction[1], direction[0]])
            assert np.abs(beside).max() < 5 * NOISE
            assert len(kept) >= 6
        touching = 1.5 / np.tan(np.radians(50))
        away = np.linalg.norm(line.points - line.edge_point, axis=1)
        assert line.removed[away < 0.5 * touching].all()


def test_the_upright_axis_of_a_scan_line_points_out_of_the_wedge(right_angle):
    part, edge = right_angle
    out = part.outward.sum(axis=0) / np.linalg.norm(part.outward.sum(axis=0))
    for line in edge.scan_lines:
        assert line.axes[1] @ out > 0.99


def test_a_scan_line_that_does_not_exist_is_an_index_error(right_angle):
    lines = right_angle[1].scan_lines
    with pytest.raises(IndexError, match=str(len(lines) + 3)):
        lines[len(lines) + 3]
    assert lines[-1].origin == pytest.approx(lines[len(lines) - 1].origin)


def test_an_edge_and_its_curve_are_printed_in_one_line(right_angle):
    edge = right_angle[1]
    assert (
        repr(edge)
        == f"ScannedEdge({len(edge)} points, {edge.length:.6g} mm, CLOUD_END to CLOUD_END)"
    )
    assert repr(edge.curve()).startswith("BSplineCurve(")
    assert len(repr(edge.curve())) < 60


def test_the_curve_of_an_edge_in_a_plane_lies_in_a_plane():
    """The rim of a torus object; its points leave its plane by their noise."""
    part = TorusObject(section_radius=40, edge_radius=100, angle=np.pi / 2)
    cloud = part.cloud(pitch=0.5, amplitude=20, noise=0.05)
    edge = scan_edge(cloud, at=cloud.edges[0].points[200])
    poles = edge.curve().poles
    assert np.linalg.svd(poles - poles.mean(axis=0))[1][2] < 1e-9
    loose = edge.curve(tolerance=0.05).poles
    assert np.linalg.svd(loose - loose.mean(axis=0))[1][2] > 1e-6
    u, _ = edge.curve().closest(edge.points)
    away = np.linalg.norm(edge.curve().evaluate(u) - edge.points, axis=1)
    assert np.mean((away / edge.sigma) ** 2) < 2.0


def test_a_curve_runs_from_vertex_to_vertex(filleted):
    _, edge = filleted
    along = edge.points[-1] - edge.points[0]
    along /= np.linalg.norm(along)
    beyond = edge.points[-1] + 0.4 * along
    ended = dataclasses.replace(edge, vertices=(None, (beyond, 1e-4 * np.eye(3))), single=None)
    assert len(ended.vertex_to_vertex) == len(edge) + 1
    _, last = ended.curve().parameter_range
    assert ended.curve().evaluate(last) == pytest.approx(beyond, abs=0.03)
    before = (edge.points[-1] - 0.1 * along, 1e-4 * np.eye(3))
    assert len(dataclasses.replace(edge, vertices=(None, before)).vertex_to_vertex) == len(edge)
    backward = ended.reversed()
    assert backward.vertex_to_vertex == pytest.approx(ended.vertex_to_vertex[::-1])
