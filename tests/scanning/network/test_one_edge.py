# SPDX-License-Identifier: LGPL-2.1-or-later
"""One edge stays one edge, though it was found in pieces; and it ends where it ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

import freecad_edgescan as es
from freecad_edgescan.scanning.automatic import Chosen, choose_parameters
from freecad_edgescan.scanning.measured_sections import MeasuredSections
from freecad_edgescan.scanning.network.cloud_workers import CloudWorkers
from freecad_edgescan.scanning.network.finishing import finished
from freecad_edgescan.scanning.network.joining import bridged
from freecad_edgescan.scanning.network.measuring import measure_sections
from freecad_edgescan.scanning.network.tracing import Tracer
from freecad_edgescan.scanning.network.tracks import Track, join_tracks
from freecad_edgescan.scanning.parameters import ScanParameters
from freecad_edgescan.scanning.section import frames_from_sides
from freecad_edgescan.scanning.stop import Stop
from freecad_edgescan.scanning.trace import Trace

PITCH, NOISE = 0.5, 0.04
LENGTH, WIDTH = 50.0, 8.0
LAST = 12  # section of the first piece


@pytest.fixture(scope="module")
def chosen() -> Chosen:
    """What an edge along x between two faces, y and z from 0 on, is measured with."""
    return choose_parameters(wedge(), np.array([25.0, 0.0, 0.0]), ScanParameters(), 0.26)


@pytest.fixture(scope="module")
def workers() -> Iterator[CloudWorkers]:
    with CloudWorkers(wedge(), 1) as workers:
        yield workers


@pytest.fixture(scope="module")
def sections(workers: CloudWorkers, chosen: Chosen) -> MeasuredSections:
    """Sections along the edge, at uneven places as a search finds them."""
    along = np.arange(4.0, LENGTH - 4.0, 1.5)
    along += 0.4 * np.sin(7.0 * np.arange(len(along)))
    origin = np.column_stack([along, np.zeros((len(along), 2))])
    tangent = np.tile([1.0, 0.0, 0.0], (len(along), 1))
    sides = np.tile([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], (len(along), 1, 1))
    measured = measure_sections(workers, frames_from_sides(origin, tangent, sides), chosen.settings)
    assert measured.found.all()
    return measured


def wedge(seed: int = 0, length: float = LENGTH, width: float = WIDTH) -> es.PointCloud:
    """The points of two faces that meet at right angles, strewn at random."""
    rng = np.random.default_rng(seed)
    count = int(length * width / PITCH**2)
    faces = []
    for order in ([0, 1, 2], [0, 2, 1]):
        points = np.zeros((count, 3))
        points[:, :2] = rng.uniform(0.0, 1.0, (count, 2)) * [length, width]
        points[:, 2] = rng.normal(0.0, NOISE, count)
        faces.append(points[:, order])
    return es.PointCloud(np.vstack(faces))


def piece(sections: MeasuredSections, begin: int, end: int) -> Track:
    return join_tracks([Track(sections[np.arange(begin, end)], False)])


def with_stray_last_section(sections: MeasuredSections) -> MeasuredSections:
    """The sections, where the last one of the first piece stands beside the edge."""
    frames, sigma = sections.frames, sections.sigma.copy()
    origin = frames.origin.copy()
    origin[LAST] += np.array([0.5, -0.7, 0.0]) * PITCH
    sigma[LAST] *= 3.5
    return replace(sections, frames=replace(frames, origin=origin), sigma=sigma)


def in_other_order(sections: MeasuredSections) -> MeasuredSections:
    """The same sections, the second side called the first."""
    frames, ways = sections.frames, [1, 0]
    return replace(
        sections,
        frames=replace(
            frames,
            sides=frames.sides[:, ways],
            normals=frames.normals[:, ways],
            curvature=frames.curvature[:, ways],
        ),
        begins=sections.begins[:, ways],
        ends=sections.ends[:, ways],
    )


def test_a_stray_section_at_its_end_does_not_part_a_track(sections, workers, chosen):
    stray = with_stray_last_section(sections)
    pieces = [piece(stray, 0, LAST + 1), piece(stray, LAST + 1, len(stray))]
    (track,) = bridged(workers, pieces, chosen.settings)
    origin = track.sections.frames.origin
    assert track.length == pytest.approx(np.ptp(sections.frames.origin[:, 0]), abs=PITCH)
    assert np.abs(origin[:, 1:]).max() < 0.35 * PITCH


def test_from_a_stray_section_the_walk_finds_on(sections, workers, chosen):
    track = piece(with_stray_last_section(sections), 0, LAST + 1)
    (edge,) = found(Tracer(workers, [track], chosen))
    assert edge.length > LENGTH - 4.0 * PITCH


@pytest.mark.parametrize("backward", [False, True])
@pytest.mark.parametrize("crossed", [False, True])
def test_pieces_that_a_walk_joins_are_one_edge_however_they_look(
    sections, workers, chosen, crossed, backward
):
    ahead = np.arange(LAST + 2, len(sections))
    rest = sections[ahead[::-1] if backward else ahead]
    rest = in_other_order(rest) if crossed else rest
    tracks = [piece(sections, 0, LAST), piece(rest, 0, len(rest))]
    if backward:
        frames = tracks[1].sections.frames
        assert frames.tangent[0, 0] < 0.0
    (edge,) = found(Tracer(workers, tracks, chosen))
    assert edge.length > LENGTH - 4.0 * PITCH
    assert edge.supported.all()


def found(tracer: Tracer) -> list[es.ScannedEdge]:
    return [edge for _, edges in tracer.edges() for edge in edges]


def test_an_end_without_a_third_surface_is_no_corner(sections, workers, chosen):
    stations = piece(sections, 5, 20).stations()
    edge = finished(workers.cloud, (Trace(stations, (Stop.CORNER, Stop.CORNER)), chosen))
    assert edge.vertices == (None, None)
    assert edge.stops == (Stop.LOST, Stop.LOST)
    assert "corner" not in edge.message


@pytest.mark.parametrize("seed", [95, 138])
def test_a_straight_edge_is_found_in_one(seed):
    length = 100.0
    network = es.find_edges(wedge(seed, length, 12.0), jobs=1)
    (edge,) = network.edges
    assert edge.length > length - 4.0 * PITCH
    assert edge.stops == (Stop.CLOUD_END, Stop.CLOUD_END)
