# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known about the part, the probe and the cloud round an edge, and what follows from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .error_model import gap_to_edge, rounding_half_angle

__all__ = ["Surroundings"]


@dataclass(frozen=True)
class Surroundings:
    """What is known about the part, the probe and the cloud round an edge.

    Attributes
    ----------
    section_radius : R of the surfaces across the edge, mm, with the centre outside of their
        smaller wedge; negative: the centre is on the wedge's side; infinite: planes
    angle : intersection angle θ in (0, π), rad
    fillet_radius : R_f, mm
    probe_radius : R_p, mm
    cloud_pitch : ρ_c, mm
    noise_level : η, mm
    convex : whether material fills the smaller wedge, so that the probe goes round the edge;
        otherwise it goes into the corner
    """

    section_radius: float
    angle: float
    fillet_radius: float
    probe_radius: float
    cloud_pitch: float
    noise_level: float
    convex: bool = True

    @property
    def radii(self) -> tuple[float, float, float]:
        """R, R_f, R_p as the error model takes them, mm."""
        if self.convex:
            return self.section_radius, self.fillet_radius, self.probe_radius
        return self.section_radius, max(self.fillet_radius, self.probe_radius), -self.probe_radius

    @property
    def arc_radius(self) -> float:
        """Radius of the arc of the probe's centres, r = |R - R_p|, mm."""
        section, _, probe = self.radii
        return abs(section - probe)

    @property
    def rounding(self) -> float:
        """Length df = 2φ(R_p + R_f) of the way round the edge, mm (Schreve 5.3.4.6)."""
        section, fillet, probe = self.radii
        half = rounding_half_angle(section, self.angle, fillet)
        return 2.0 * float(half) * (probe + fillet)

    @property
    def cut_off(self) -> float:
        """What the way round the edge leaves out of each side, up to where the sides meet, mm."""
        _, fillet, probe = self.radii
        return (fillet + probe) * float(np.tan(0.5 * (np.pi - self.angle)))

    @property
    def gap(self) -> float:
        """Length over which a line section is drawn out to the edge, mm."""
        section, fillet, probe = self.radii
        return gap_to_edge(section, self.angle, fillet, probe)

    def line_section(self, amplitude: float) -> float:
        """What a scan line of this amplitude leaves for each side, s = (A - df)/2, mm."""
        return 0.5 * (amplitude - self.rounding)
