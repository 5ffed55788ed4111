# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every value a scan needs and nobody gave: chosen from the cloud, each with its reason."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..cloud.point_cloud import PointCloud
from ..geometry.plain_number import plain
from .errors import ScanError
from .evened import one_per_cell
from .parameters import ScanParameters
from .patch_section import PatchSettings
from .seed import Seed

MIN_ANGLE = 0.26  # rad, least turn between the two sides of an edge
_AMPLITUDE = 44.0  # pitches
_ROUNDED = 1.6  # times half an amplitude: how far the sides of a rounded edge may reach
# Times what a rounding seems to take away, as far a side has to reach to be as long as the way
# round the edge (Schreve 5.3.4.6.1); where it is shorter, the rounding seems smaller than it is.
_SIDE = 3.5
_EDGE_PITCH = 2.0  # pitches
_LEAST_NOISE = 0.03  # pitches: below it a surface's own form matters more than noise
_NEIGHBOURHOOD = 15.0  # pitches round the start in which the pitch is measured
_FEWEST_PITCHES = 6.0  # an amplitude below this has no room for two sides


@dataclass(frozen=True)
class Chosen:
    """Parameters with every value filled in, the reason of each, and the patch's settings."""

    parameters: ScanParameters
    reasons: dict[str, str]
    settings: PatchSettings

    @property
    def for_seed(self) -> PatchSettings:
        """Settings to find the first section with: a given amplitude may hide a rounding."""
        given = self.reasons.get("amplitude") == "given"
        return self.settings.with_reach(_ROUNDED * self.settings.reach) if given else self.settings

    def with_seed(self, seed: Seed) -> Chosen:
        """The same with the slab and the reach that suit the edge found."""
        settings = replace(self.settings, spacing=seed.spacing)
        return replace(self, settings=settings)._with_reach_of(seed)

    def _with_reach_of(self, seed: Seed) -> Chosen:
        """The same with the reach that suits the edge found.

        A given amplitude is measured along the surface, round the rounding; the reach straight
        from the edge that is not there. An automatic one is what knows the edge best.
        """
        if self.reasons.get("amplitude") == "given":
            half_turn = 0.5 * float(seed.station.frame.turn[0])
            begins = float(np.mean(seed.station.begins))
            cut_off = begins * (1.0 - half_turn / np.tan(half_turn))
            reach = self.settings.reach + min(cut_off, (_ROUNDED - 1.0) * self.settings.reach)
            if reach >= _SIDE * begins:
                return replace(self, settings=self.settings.with_reach(reach))
            reason = (
                f"given; {plain(2.0 * seed.reach, 3)} mm are used, since a rounding of this edge "
                "leaves less of the sides than it takes away"
            )
            return Chosen(
                self.parameters,
                {**self.reasons, "amplitude": reason},
                self.settings.with_reach(max(reach, seed.reach)),
            )
        if seed.reach >= self.settings.reach:
            return self
        reason = "farther from the edge the two sides do not tell more about it"
        return Chosen(
            replace(self.parameters, amplitude=2.0 * seed.reach),
            {**self.reasons, "amplitude": reason},
            self.settings.with_reach(seed.reach),
        )


def choose_parameters(
    cloud: PointCloud, near: np.ndarray, given: ScanParameters, min_angle: float = MIN_ANGLE
) -> Chosen:
    """Fill in the parameters that were not given.

    Parameters
    ----------
    near : (3,) mm, where the scan begins; pitch is measured there
    given : what the user asked for

    Raises
    ------
    ScanError: values that cannot work with this cloud or with each other.
    """
    reasons = dict.fromkeys(given.given(), "given")
    pitch = _pitch_around(cloud, near)
    probe = given.probe_radius
    if probe is None:
        probe = cloud.probe_radius
        reasons["probe_radius"] = "the cloud's own"
    approach = given.approach
    if approach is None:
        approach = cloud.approach
        reasons["approach"] = "the cloud's own" if approach is not None else "unknown"
    edge_pitch = given.edge_pitch
    if edge_pitch is None:
        edge_pitch = _EDGE_PITCH * pitch
        reasons["edge_pitch"] = f"{_EDGE_PITCH:g} times the cloud pitch of {plain(pitch, 3)} mm"
    elif edge_pitch < pitch:
        raise ScanError(
            f"The edge pitch of {edge_pitch:g} mm is below the cloud pitch of {plain(pitch, 3)} "
            f"mm; give at least {plain(pitch, 3)} mm, better {plain(_EDGE_PITCH * pitch, 3)} mm."
        )
    amplitude = given.amplitude
    if amplitude is None:
        amplitude = _AMPLITUDE * pitch + 2.0 * probe
        reasons["amplitude"] = (
            f"{_AMPLITUDE:g} times the cloud pitch of {plain(pitch, 3)} mm"
            + (" and the probe's diameter" if probe else "")
            + "; each side is used as far as it is one smooth surface"
        )
    elif amplitude < _FEWEST_PITCHES * pitch:
        raise ScanError(
            f"The amplitude of {amplitude:g} mm has no room for points on both sides of the edge "
            f"in a cloud of pitch {plain(pitch, 3)} mm; give at least "
            f"{plain(_FEWEST_PITCHES * pitch, 3)} mm."
        )
    extent = float(np.linalg.norm(cloud.size))
    if probe > 0.25 * extent or probe >= 0.5 * amplitude:
        raise ScanError(
            f"The probe radius of {probe:g} mm is larger than what is to be scanned (amplitude "
            f"{plain(amplitude, 3)} mm, cloud {plain(extent, 3)} mm across); check the "
            "radius and its unit."
        )
    noise = max(cloud.noise, _LEAST_NOISE * pitch)
    reasons["cloud_pitch"] = "measured near the start" if given.cloud_pitch is None else "given"
    chosen = replace(
        given,
        amplitude=amplitude,
        edge_pitch=edge_pitch,
        probe_radius=probe,
        approach=approach,
        cloud_pitch=pitch if given.cloud_pitch is None else given.cloud_pitch,
    )
    settings = PatchSettings(0.5 * amplitude, edge_pitch, pitch, noise, probe, min_angle)
    return Chosen(chosen, reasons, settings)


def _pitch_around(cloud: PointCloud, near: np.ndarray) -> float:
    """Pitch of the surfaces round a place, mm, by area: scans crowd points on roundings."""
    index = cloud.tree.query_ball_point(near, _NEIGHBOURHOOD * cloud.pitch)
    points = one_per_cell(cloud.points[np.asarray(index, dtype=np.int64)], 3.0 * cloud.pitch)
    if len(points) < 5:
        return cloud.pitch
    local = np.sqrt(np.prod(cloud.local_pitch(points[:100]), axis=1))
    return float(np.clip(np.nanpercentile(local, 70), 0.3 * cloud.pitch, 4.0 * cloud.pitch))
