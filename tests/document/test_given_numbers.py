# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers that cannot work: one sentence, whether as an argument or in a property; nothing lost."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import pytest

FreeCAD = pytest.importorskip("FreeCAD")
Part = pytest.importorskip("Part")

import freecad_edgescan as es  # noqa: E402
from freecad_edgescan import document  # noqa: E402

V = FreeCAD.Vector
NO_LENGTHS = (math.nan, math.inf, -1.0, "wide")


class Made(NamedTuple):
    """An object that was computed, and what makes another one like it."""

    obj: Any
    make: Callable[..., Any]


def feature(doc: Any, shape: Any, name: str) -> Any:
    made = doc.addObject("Part::Feature", name)
    made.Shape = shape
    return made


@pytest.fixture(scope="module")
def scene() -> Iterator[dict[str, Made]]:
    """One object of each kind that takes numbers, over a wavy cloud and a roof."""
    doc = FreeCAD.newDocument("GivenNumbers")
    x, y = np.random.default_rng(0).uniform((0, 0), (40, 30), (1500, 2)).T
    wavy = document.make_cloud(doc, np.column_stack([x, y, 0.3 * np.sin(x / 8)]))
    roof = es.PointCloud(np.column_stack([x, y, 15.0 - np.abs(y - 15.0)]))
    ridge = document.make_cloud(doc, roof, name="Roof")
    base = feature(doc, Part.makePlane(40, 30), "Plane")
    wall = feature(doc, Part.makeBox(10, 40, 10, V(10, -5, -5)), "Wall")
    rails = [
        feature(doc, Part.makeLine(V(1, y, 0), V(39, y, 0)), f"Rail{number}")
        for number, y in enumerate((5, 25))
    ]
    profiles = [
        feature(doc, Part.makeLine(V(x, 5, 0), V(x, 25, 0)), f"Profile{number}")
        for number, x in enumerate((1, 39))
    ]
    rim = [
        feature(doc, edge, f"Rim{number}")
        for number, edge in enumerate(Part.makePlane(20, 20, V(5, 5, 0)).Edges)
    ]
    makers: dict[str, Callable[..., Any]] = {
        "thinned": lambda **own: document.make_thinned_cloud(doc, wavy, **{"pitch": 2.0} | own),
        "segment": lambda **own: document.make_cloud_segment(doc, wavy, base, **own),
        "map": lambda **own: document.make_deviation_map(doc, wavy, base, **own),
        "simulated": lambda **own: document.make_simulated_cloud(doc, base, **{"pitch": 2.0} | own),
        "section": lambda **own: document.make_cloud_section(
            doc, wavy, rails[0], towards=rails[1], **own
        ),
        "fit": lambda **own: document.make_fitted_surface(
            doc, wavy, base, **{"control_points": (4, 4)} | own
        ),
        "sweep": lambda **own: document.make_swept_surface(
            doc, rails, profiles, wavy, **{"model": "blend", "control_points": (4, 4)} | own
        ),
        "plain sweep": lambda **own: document.make_swept_surface(
            doc, rails, profiles, **{"model": "blend"} | own
        ),
        "extended": lambda **own: document.make_extended_surface(doc, base, **own),
        "intersection": lambda **own: document.make_surface_intersection(doc, base, wall, **own),
        "shell": lambda **own: document.make_trimmed_shell(doc, [base], rim, **own),
        "network": lambda **own: document.make_edge_network(doc, ridge, **own),
        "boundary": lambda **own: document.make_scanned_boundary(
            doc, ridge, **{"at": (20, 15, 15), "inside": (20, 10, 10)} | own
        ),
        "edge": lambda **own: document.make_scanned_edge(doc, ridge, at=(20, 15, 15), **own),
    }
    made = {name: Made(make(), make) for name, make in makers.items()}
    doc.recompute()
    yield made
    FreeCAD.closeDocument(doc.Name)


def result_of(obj: Any) -> Any:
    """What was computed: the number of points, or the shape's size."""
    if hasattr(obj, "Points") and hasattr(obj.Points, "CountPoints"):
        return obj.Points.CountPoints
    return obj.Shape.Length, obj.Shape.Area


LENGTHS = [
    ("thinned", "pitch", "Pitch"),
    ("segment", "distance", "Distance"),
    ("map", "reach", "Reach"),
    ("map", "limit", "Limit"),
    ("simulated", "pitch", "Pitch"),
    ("simulated", "noise", "Noise"),
    ("simulated", "probe_radius", "ProbeRadius"),
    ("section", "reach", "Reach"),
    ("section", "thickness", "Thickness"),
    ("section", "share", "Share"),
    ("fit", "distance", "Distance"),
    ("fit", "tolerance", "Tolerance"),
    ("sweep", "distance", "Distance"),
    ("extended", "ratio", "Ratio"),
    ("intersection", "tolerance", "Tolerance"),
    ("shell", "tolerance", "Tolerance"),
    ("network", "min_length", "MinLength"),
    ("network", "max_sigma", "MaxSigma"),
]


def test_all_kinds_have_a_result_to_lose(scene: dict[str, Made]) -> None:
    for name, (obj, _) in scene.items():
        assert np.all(np.array(result_of(obj)) >= 0.0) and np.any(result_of(obj)), name
        assert obj.isValid(), f"{name}: {obj.Message}"


@pytest.mark.parametrize("value", NO_LENGTHS)
@pytest.mark.parametrize(("kind", "argument", "name"), LENGTHS)
def test_a_number_that_cannot_work_says_the_same_as_argument_and_as_property(
    scene: dict[str, Made], kind: str, argument: str, name: str, value: Any
) -> None:
    obj, make = scene[kind]
    doc, kept = obj.Document, result_of(obj)
    before = list(doc.Objects)
    with pytest.raises(ValueError, match=r"^The .* is .*; give .*\.$") as refused:
        make(**{argument: value})
    assert doc.Objects == before
    if isinstance(value, str):
        return  # a property takes no text
    good = getattr(obj, name)
    setattr(obj, name, value)
    try:
        doc.recompute()
        assert obj.Message == str(refused.value)
        assert not obj.isValid()
        assert result_of(obj) == kept
    finally:
        setattr(obj, name, good)
        doc.recompute()
    assert obj.isValid() and result_of(obj) == pytest.approx(kept, rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "arguments", "properties"),
    [
        ("simulated", {"seed": -1}, {"Seed": -1}),
        ("fit", {"control_points": (3, 4)}, {"PolesU": 3}),
        ("fit", {"control_points": (4, -2)}, {"PolesV": -2}),
        ("fit", {"control_points": (0, 4)}, {"PolesU": 0}),
        ("fit", {"degree": (3, 0)}, {"DegreeV": 0}),
        ("sweep", {"control_points": (3, 4)}, {"RailPoles": 3}),
        ("sweep", {"control_points": (4, 0)}, {"ProfilePoles": 0}),
        ("network", {"min_angle": 0.0}, {"MinAngle": 0.0}),
        ("network", {"min_angle": math.radians(-20.0)}, {"MinAngle": -20.0}),
        ("network", {"min_angle": math.pi}, {"MinAngle": 180.0}),
        ("extended", {"tau": math.nan}, {"UseTau": True, "Tau": math.nan}),
        ("boundary", {"at": (math.nan, 0.0, 0.0)}, {"At": V(math.nan, 0.0, 0.0)}),
        ("boundary", {"inside": (0.0, math.inf, 0.0)}, {"Inside": V(0.0, math.inf, 0.0)}),
    ],
)
def test_counts_angles_and_places_are_refused_alike(
    scene: dict[str, Made], kind: str, arguments: dict[str, Any], properties: dict[str, Any]
) -> None:
    obj, make = scene[kind]
    doc, kept = obj.Document, result_of(obj)
    before = list(doc.Objects)
    with pytest.raises(ValueError, match="; give ") as refused:
        make(**arguments)
    assert doc.Objects == before
    good = {name: getattr(obj, name) for name in properties}
    for name, value in properties.items():
        setattr(obj, name, value)
    try:
        doc.recompute()
        assert obj.Message == str(refused.value)
        assert result_of(obj) == kept
    finally:
        for name, value in good.items():
            setattr(obj, name, value)
        doc.recompute()
    assert obj.isValid()


@pytest.mark.parametrize(
    ("kind", "name", "value", "said"),
    [
        ("boundary", "MinAngle", -20.0, "The least angle is -0.349066 rad (-20°); give"),
        ("sweep", "LargestGap", -1.0, "The largest gap is -1; give 0 or a positive length in mm."),
        (
            "plain sweep",
            "Tolerance",
            math.nan,
            "The tolerance is nan; give a positive length in mm.",
        ),
        ("edge", "Amplitude", math.nan, "The amplitude is nan; give a positive length"),
        ("edge", "EdgePitch", math.inf, "The edge pitch is inf; give a positive length"),
        ("edge", "MinAngle", 200.0, "The least angle is 3.49"),
        ("edge", "At", V(math.nan, 0.0, 0.0), "The click is (nan, 0.0, 0.0); give"),
    ],
)
def test_properties_that_are_no_arguments_are_refused_too(
    scene: dict[str, Made], kind: str, name: str, value: Any, said: str
) -> None:
    obj = scene[kind].obj
    kept, good = result_of(obj), getattr(obj, name)
    setattr(obj, name, value)
    try:
        obj.Document.recompute()
        assert obj.Message.startswith(said)
        assert result_of(obj) == kept
    finally:
        setattr(obj, name, good)
        obj.Document.recompute()
    assert obj.isValid()


@pytest.mark.parametrize("value", [2.5, math.nan, math.inf, "many", None, -1])
def test_what_is_no_whole_number_is_named(scene: dict[str, Made], value: Any) -> None:
    with pytest.raises(ValueError, match=r"^The seed is .*; give a whole number of 0 or more\.$"):
        scene["simulated"].make(seed=value)


@pytest.mark.parametrize("value", NO_LENGTHS)
def test_clouds_are_refused_before_they_are_made(doc: Any, value: Any) -> None:
    points = np.eye(3)
    with pytest.raises(ValueError, match=r"^The probe radius is .* Give 0"):
        document.make_cloud(doc, points, probe_radius=value)
    with pytest.raises(ValueError, match=r"^The pitch is .*; give a positive length in mm"):
        document.make_core_box(doc, pitch=value, small=True)
    assert not doc.Objects


@pytest.mark.parametrize("approach", [(0, 0, 0), (math.nan, 0, 1), (0, 1), "down"])
def test_an_approach_without_a_direction_makes_no_cloud(doc: Any, approach: Any) -> None:
    with pytest.raises(ValueError, match="has no direction"):
        document.make_cloud(doc, np.eye(3), approach=approach)
    assert not doc.Objects


@pytest.mark.parametrize("given", [{"share": math.nan}, {"share": 0.5, "thickness": -1.0}])
def test_an_arc_profile_takes_only_places_and_lengths(
    scene: dict[str, Made], given: dict[str, float]
) -> None:
    section = scene["section"].obj
    with pytest.raises(ValueError, match=r"^The .* is .*; give "):
        document.make_arc_profile(
            section.Document, section.Cloud, (section.Rail, section.Towards), **given
        )
