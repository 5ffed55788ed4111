# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fits of both sides of an edge that were fitted together with the rounding between them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .side_fit import SideFits

__all__ = ["RoundedFits"]

_SURELY = 2.0  # standard deviations of a radius that is measured


@dataclass(frozen=True)
class RoundedFits(SideFits):
    """Sides that were fitted together with the rounding between them.

    Attributes
    ----------
    radius : (m,) of the rounding, in reaches
    joint : (m, 9, 9) covariance of the coefficients of both sides and the radius, in reaches²
    joint_shared : (m, 9, 9) the part of it that neighbouring sections share
    """

    radius: np.ndarray
    joint: np.ndarray
    joint_shared: np.ndarray

    def position_covariance(self, terms: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Covariance (m, 2, 2) of the two sides' positions, and its shared part; see `SideFits`."""
        of_both = np.zeros((len(terms), 2, 9))
        of_both[:, 0, :4], of_both[:, 1, 4:8] = terms[:, 0], terms[:, 1]
        turned, astray = np.swapaxes(of_both, 1, 2), self.astray[..., None] * np.eye(2)
        return of_both @ self.joint @ turned + astray, of_both @ self.joint_shared @ turned + astray

    def or_else(self, other: RoundedFits, share: float) -> RoundedFits:
        """These fits, or others with a probability: their mean, and the covariance about it."""
        mine = self._unknowns()
        apart = other._unknowns() - mine
        mean, between = mine + share * apart, share * (1.0 - share)
        spread = between * apart[:, :, None] * apart[:, None, :]
        joint, shared = (
            (1.0 - share) * one + share * another + spread
            for one, another in (
                (self.joint, other.joint),
                (self.joint_shared, other.joint_shared),
            )
        )
        blocks = np.stack([joint[:, :4, :4], joint[:, 4:8, 4:8]], axis=1)
        return replace(
            self,
            coefficients=mean[:, :8].reshape(-1, 2, 4),
            inverse=blocks / self.variance[..., None, None],
            radius=mean[:, 8],
            joint=joint,
            joint_shared=shared,
            astray=(1.0 - share) * self.astray + share * other.astray,
        )

    def _unknowns(self) -> np.ndarray:
        return np.concatenate([self.coefficients.reshape(-1, 8), self.radius[:, None]], axis=1)

    def backward(self) -> RoundedFits:
        """The same sections in the other order, walked the other way."""
        turn = np.append(np.tile([1.0, 1.0, 1.0, -1.0], 2), 1.0)
        turned = super().backward()
        assert isinstance(turned, RoundedFits)
        return replace(
            turned,
            joint=turned.joint * np.outer(turn, turn),
            joint_shared=turned.joint_shared * np.outer(turn, turn),
        )

    @property
    def radius_sigma(self) -> np.ndarray:
        """Standard deviation of the radius, (m,), in reaches."""
        return np.sqrt(self.joint[:, -1, -1])

    def measured_radius(self) -> tuple[np.ndarray, np.ndarray]:
        """Radius and its standard deviation (m,), in reaches; nan where it may as well be none."""
        measurable = self.radius > _SURELY * self.radius_sigma
        return (
            np.where(measurable, self.radius, np.nan),
            np.where(measurable, self.radius_sigma, np.nan),
        )
