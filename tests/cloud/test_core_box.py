# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from scipy.spatial import cKDTree

from freecad_edgescan.cloud import CoreBox

BALL = 1.0055


@pytest.fixture(scope="module")
def box():
    return CoreBox()


@pytest.fixture(scope="module")
def exact(box):
    return box.cloud(noise=0.0)


@pytest.fixture(scope="module", params=[0.0, 1.0], ids=["sharp", "rounded"])
def small(request):
    rounded = CoreBox.small(rim_radius=request.param)
    return rounded, rounded.cloud(noise=0.0)


def depth_in_pipe(pipe, points):
    """How deep places lie within the union of the pipe's spheres, by trying all of them."""
    spheres = pipe.spine(np.linspace(pipe.spine.t[0], pipe.spine.t[-1], 3001))
    centres = np.column_stack([spheres[:, :2], np.zeros(len(spheres))])
    places = np.zeros((len(points), 3))
    places[:, : points.shape[1]] = points
    deepest = []
    for place in places:
        depth = spheres[:, 2] - np.sqrt(((place - centres) ** 2).sum(axis=1))
        at = np.clip(depth.argmax(), 1, len(depth) - 2)
        before, top, after = depth[at - 1 : at + 2]  # the parabola through the three deepest
        deepest.append(top - (after - before) ** 2 / (8 * (after - 2 * top + before)))
    return np.array(deepest)


def wall(pipe, step):
    """Places on the wall, from differences between neighbouring spheres."""
    u = np.linspace(pipe.spine.t[0], pipe.spine.t[-1], 40_001)
    x, y, r = pipe.spine(u).T
    length = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(x), np.diff(y)))])
    even = np.arange(0.0, length[-1], step)
    x, y, r = (np.interp(even, length, values) for values in (x, y, r))
    tx, ty, slope = (np.gradient(values, even) for values in (x, y, r))
    phi = np.linspace(0.0, np.pi, int(np.pi * r.max() / step))[None, :]
    back, size = (-r * slope)[:, None], (r * np.sqrt(1 - slope**2))[:, None]
    aside, down = size * np.cos(phi), -size * np.sin(phi)
    px = x[:, None] + back * tx[:, None] - aside * ty[:, None]
    py = y[:, None] + back * ty[:, None] + aside * tx[:, None]
    return np.column_stack([px.ravel(), py.ravel(), down.ravel()])


def test_sharp_part_is_cleared_by_exactly_the_ball():
    small = CoreBox.small()
    cloud = small.cloud(noise=0.0)
    (pipe,) = small.pipes
    u = np.linspace(0.0, pipe.spine.t[-1], 2001)
    strips = [
        curve + away * outwards
        for side in (1.0, -1.0)
        for curve, _, outwards in [pipe.rim(u, side)]
        for away in np.arange(0.0, 1.5, 0.07)
    ]
    plane = np.vstack(strips)
    surface = np.vstack([wall(pipe, 0.07), np.column_stack([plane, np.zeros(len(plane))])])
    gap = cKDTree(surface).query(cloud.points[cloud.labels > 0])[0]
    assert gap.min() > BALL - 5e-5  # and so are the differences its slope is taken from
    assert gap.max() < BALL + 2e-3  # the samples of the surface are 0.07 mm apart


def test_centres_in_the_pipe_are_one_radius_from_the_wall(small):
    box, cloud = small
    centres = cloud.points[cloud.labels == 1][::9]
    assert np.abs(depth_in_pipe(box.pipes[0], centres) - BALL).max() < 1e-6
    assert (centres[:, 2] <= 0).all()


def test_centres_over_the_plane_are_one_radius_above_it(small):
    box, cloud = small
    centres = cloud.points[cloud.labels == 0]
    assert (centres[:, 2] == BALL).all()
    assert depth_in_pipe(box.pipes[0], centres[::5, :2]).max() < 1e-6


def test_the_ball_rolls_round_the_rims(small):
    """Its centre is R_p from a sharp rim, R_p + q from the centres of a rounding of radius q."""
    box, cloud = small
    q = box.rim_radius
    u = np.linspace(0.0, box.pipes[0].spine.t[-1], 20_001)
    for label, side in ((2, 1.0), (3, -1.0)):
        centres = cloud.points[cloud.labels == label]
        curve = box.pipes[0].rim(u, side, q)[0]
        # the rounding's centres are q deep in the material, from the wall as from the plane
        buried = np.column_stack([curve[::50], np.full(len(curve[::50]), -q)])
        assert np.abs(depth_in_pipe(box.pipes[0], buried) + q).max() < 1e-5
        distance = cKDTree(np.column_stack([curve, np.full(len(curve), -q)])).query(centres)[0]
        assert np.abs(distance - BALL - q).max() < 1e-5
        assert len(centres) > 300


def test_heights_are_continuous_across_the_rims():
    for q in (0.0, 1.2):
        box = CoreBox.small(q)
        y = np.linspace(20, 48, 100_001)
        height, label = box.touch(np.column_stack([np.full(len(y), 5.0), y]))
        assert set(label) == {0, 1, 2, 3}
        assert np.abs(np.diff(height)).max() < 0.07  # steep, but without a jump
        change = np.flatnonzero(np.diff(label))
        assert len(change) == 4
        assert np.abs(np.diff(height)[change]).max() < 0.07


def test_rims_lie_exactly_where_the_wall_meets_the_plane(box):
    for k, edge in enumerate(box.edges):
        pipe = box.pipes[k // 2]
        some = edge.points[::150]
        assert np.abs(depth_in_pipe(pipe, some)).max() < 1e-5
        assert (edge.points[:, 2] == 0).all()
        chords = np.diff(edge.points, axis=0)
        cosine = np.einsum("ij,ij->i", chords, edge.tangents[1:])
        assert (cosine > (1 - 1e-5) * np.linalg.norm(chords, axis=1)).all()


def test_the_wall_stands_upright_at_the_rims(box):
    down = 1e-3
    for k, edge in enumerate(box.edges):
        below = edge.points[::300] - np.array([0.0, 0.0, down])
        assert np.abs(depth_in_pipe(box.pipes[k // 2], below)).max() < 1e-5
        assert (edge.angle == np.pi / 2).all()
        assert edge.convex is True


def test_rims_are_denser_than_their_chord_error_needs(box):
    for edge in box.edges:
        turn = np.linalg.norm(np.diff(edge.tangents, axis=0), axis=1)
        chord = np.linalg.norm(np.diff(edge.points, axis=0), axis=1)
        assert (chord * turn / 8).max() < 1e-5


def test_the_land_between_the_pipes_is_3_mm_at_one_place(box):
    inner, outer = box.edges[1], box.edges[2]
    gap = inner.distance(outer.points[::20])
    assert gap.min() == pytest.approx(3.0, abs=1e-3)
    assert np.ptp(np.flatnonzero(gap < 4.0)) < 0.15 * len(gap)
    assert outer.room.min() == pytest.approx(3.0, abs=1e-3)
    assert np.abs(outer.room[::20] - gap)[gap < 30].max() < 1e-3
    assert gap[[0, -1]].min() > 10


def test_the_pipes_narrow_from_19_5_to_17_mm_and_bend_by_a_right_angle(box):
    for k, pipe in enumerate(box.pipes):
        radius = pipe.spine(pipe.parameters)[:, 2]
        assert (radius.max(), radius.min()) == pytest.approx((19.5, 17.0))
        assert (np.diff(radius) < 1e-12).all()
        for edge in box.edges[2 * k : 2 * k + 2]:
            assert edge.tangents[0] == pytest.approx([1, 0, 0], abs=0.02)
            assert edge.tangents[-1] == pytest.approx([0, -1, 0], abs=0.02)
            assert edge.points[0, 0] == pytest.approx(0, abs=0.1)
            assert edge.points[-1, 1] == pytest.approx(0, abs=0.1)


def test_points_are_at_most_a_pitch_apart_along_lines_a_pitch_apart(exact):
    line = np.round(exact.points[:, 0] / 0.5).astype(int)
    assert np.abs(exact.points[:, 0] - 0.5 * line).max() < 1e-9
    assert np.array_equal(np.unique(line), np.arange(701))
    same = np.diff(line) == 0
    steps = np.linalg.norm(np.diff(exact.points, axis=0), axis=1)[same]
    assert steps.max() <= 0.5 * (1 + 1e-6)
    assert np.median(steps) > 0.47
    assert (np.diff(exact.points[:, 1])[same] > 0).all()
    assert 280_000 < len(exact) < 340_000


def test_walls_across_the_lines_are_dense_and_walls_along_them_have_gaps(box, exact):
    def farthest(places):
        return exact.tree.query(places)[0].max()

    for pipe in box.pipes:
        inset = wall(pipe, 0.5)
        x, y, _ = inset.T
        across = inset[(x > 5) & (x < 30)]
        along = inset[(y > 5) & (y < 20) & (x > 200)]
        steep = along[(along[:, 2] < -0.5) & (along[:, 2] > -6)]
        assert farthest(across) < BALL + 0.4
        assert farthest(steep) > BALL + 0.4
    # the highest contact in a wall along the lines lies up to 4 mm below the rim's
    low = exact.points[(exact.points[:, 1] < 20) & (exact.points[:, 0] > 240)]
    x, inverse = np.unique(np.round(low[:, 0] / 0.5), return_inverse=True)
    height = np.bincount(inverse, low[:, 2]) / np.bincount(inverse)
    assert 2.5 < np.abs(np.diff(height)).max() < 4.5


def test_noise_is_uniform_on_each_coordinate_and_repeats_with_the_seed():
    box = CoreBox.small()
    exact, noisy = box.cloud(noise=0.0).points, box.cloud(noise=0.05, seed=3).points
    errors = noisy - exact
    assert np.abs(errors).max() <= 0.05
    assert errors.std(axis=0) == pytest.approx(np.full(3, 0.05 / np.sqrt(3)), rel=0.03)
    assert np.array_equal(noisy, CoreBox.small().cloud(noise=0.05, seed=3).points)
    assert not np.array_equal(noisy, box.cloud(noise=0.05, seed=4).points)


def test_the_cloud_says_what_it_is(exact):
    names = ("plane", "pipe 1", "pipe 2", "rim 1", "rim 2", "rim 3", "rim 4")
    assert exact.face_names == names
    assert exact.probe_radius == BALL
    assert exact.approach == pytest.approx([0, 0, -1])
    for label, edge in enumerate(exact.edges, start=3):
        rolling = exact.points[exact.labels == label]
        assert np.abs(edge.distance(rolling) - BALL)[::10].max() < 0.02  # beyond the edge's ends
    small = CoreBox.small().cloud()
    assert len(small) < 20_000
    assert small.face_names == ("plane", "pipe 1", "rim 1", "rim 2")


@pytest.mark.parametrize("amplitude", [7.0, 22.0])
def test_starts_and_gates_lie_on_the_plane_half_an_amplitude_from_their_rims(box, amplitude):
    lift = np.array([0.0, 0.0, BALL])
    ends = zip(box.edges, box.pipes[:1] * 2 + box.pipes[1:] * 2, strict=True)
    starts, gates = box.starts(amplitude), box.gates(amplitude)
    for (edge, pipe), start, gate in zip(ends, starts, gates, strict=True):
        point, across, along = start
        for place, direction in ((point, across), gate):
            assert edge.distance([place - lift + amplitude / 2 * direction])[0] < 1e-9
            assert edge.distance([place - lift])[0] == pytest.approx(amplitude / 2, rel=1e-3)
            assert depth_in_pipe(pipe, (place - lift)[None])[0] < 0
            assert depth_in_pipe(pipe, (place - lift + amplitude * direction)[None])[0] > 3
        assert along == pytest.approx([1, 0, 0], abs=0.02)
        assert abs(across @ along) < 1e-12
        assert 5 < point[0] < 12
        assert 5 < gate[0][1] < 12


@pytest.mark.parametrize(
    ("build", "sentence"),
    [
        (lambda: CoreBox(rim_radius=2.0), "rim radius is 2.0 mm"),
        (lambda: CoreBox(rim_radius=float("nan")), "rim radius is nan mm"),
        (lambda: CoreBox(probe_radius=17.0), "probe radius is 17.0 mm"),
        (lambda: CoreBox.small().cloud(pitch=0.0), "pitch is 0.0 mm"),
        (lambda: CoreBox.small().cloud(noise=-0.1), "noise level is -0.1 mm"),
        (lambda: CoreBox.small().starts(-1.0), "amplitude is -1.0 mm"),
    ],
)
def test_impossible_boxes_are_refused_with_the_value(build, sentence):
    with pytest.raises(ValueError, match=sentence):
        build()
