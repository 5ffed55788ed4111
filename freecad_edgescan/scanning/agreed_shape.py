# SPDX-License-Identifier: LGPL-2.1-or-later
"""What neighbouring sections agree on: how curved both sides are, and how wide the rounding is.

The three are known badly, and together: a rounding that is a little wider between sides that are a
little more bent looks the same. What each section says of them, its own place and slopes left
open, is therefore kept as a matrix and summed over neighbours. Half of all sides are planes: each
side is a plane or bent, and the four cases are averaged with their posterior probabilities
(Hoeting and others, Statistical Science 14, 1999).
"""

from __future__ import annotations

from itertools import product

import numpy as np
from scipy.ndimage import convolve1d

from .normal_equations import PRIOR_SIGMA
from .positive_definite import inverses
from .rounded_rows import CURVATURES_AND_RADIUS, equations
from .side_fit import MOST_CURVED

__all__ = ["agreed_shape", "curvatures_of_each", "shape_evidence"]

_WIDTHS = (8, 24, 72)  # sections on each side that may agree
# Squared Mahalanobis distance beyond which two estimates of the three differ, or of the two
# curvatures with the radius given (99 %).
_AGREE, _AGREE_OF_TWO = 11.3, 9.2
_PLANE = 3e-3  # curvature of a plane, in inverse reaches: that of a sagitta far below any noise
_ANY_RADIUS = 1e3  # reaches
_FIXED = 1e-6  # variance, in reaches², of a radius that is given
_REST = np.setdiff1d(np.arange(9), CURVATURES_AND_RADIUS)


def agreed_shape(
    summed: np.ndarray, radius: np.ndarray, counted: float, closed: bool, fixed: bool = False
) -> tuple[np.ndarray, np.ndarray, int]:
    """Curvatures and radius (m, 3) that neighbours agree on, and their covariance (m, 3, 3).

    And how many sections on each side mostly agree.

    Parameters
    ----------
    summed : (m, 12, 12) rows of each section's own points near a model
    radius : (m,) of that model, in reaches
    counted : how often sums over neighbours count each point
    closed : whether the last section leads back to the first
    fixed : whether the radius is given
    """
    information, said = _of_shape(summed, radius)
    mode = "wrap" if closed else "constant"
    taken: tuple[np.ndarray, np.ndarray] | None = None
    agreeing, still = np.zeros(len(summed), dtype=np.int64), np.ones(len(summed), dtype=bool)
    for width in _WIDTHS:
        width = min(width, (len(summed) - 1) // 2)
        window = np.ones(2 * width + 1) / counted
        known, told = (convolve1d(part, window, axis=0, mode=mode) for part in (information, said))
        if fixed:
            mean, covariance = _given(known, told, radius)
        else:
            mean, covariance, _ = _perhaps_planes(known, told)
        if taken is None:
            taken = mean, covariance
            agreeing[:] = width
            continue
        apart = mean - taken[0]
        # The wider one is made of the narrower one and others.
        free = taken[1] - covariance + 1e-3 * taken[1]
        off = np.einsum("mi,mij,mj->m", apart, np.linalg.inv(free), apart)
        still &= np.abs(off) <= (_AGREE_OF_TWO if fixed else _AGREE)
        # What curls like a rounding says nothing about the side.
        still |= np.any(np.abs(taken[0][:, :2]) > MOST_CURVED, axis=1)
        taken = (
            np.where(still[:, None], mean, taken[0]),
            np.where(still[:, None, None], covariance, taken[1]),
        )
        agreeing[still] = width
    assert taken is not None
    return *taken, int(np.median(agreeing))


def curvatures_of_each(
    summed: np.ndarray, coefficients: np.ndarray, radius: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Curvatures (m, 2) that each section's own points say, and their variances (m, 2).

    Parameters
    ----------
    summed : (m, 12, 12) rows of each section's own points near a model
    coefficients, radius : of the model, (m, 2, 4) and (m,); near it the curvatures are expected
    """
    information, said = _of_shape(summed, radius)
    loose = np.append(PRIOR_SIGMA[[2, 2]], 1.0)
    there = np.concatenate([coefficients[..., 2], radius[:, None]], axis=1)
    covariance = inverses(information + np.diag(1.0 / loose**2))
    mean = np.einsum("mij,mj->mi", covariance, said + there / loose**2)
    return mean[:, :2], covariance[:, [0, 1], [0, 1]]


def shape_evidence(
    summed: np.ndarray, coefficients: np.ndarray, radius: np.ndarray, counted: float
) -> float:
    """What is to be added to a model's misfit, times −½, for the logarithm of its likelihood.

    That is then the average over one pair of curvatures for the whole edge, planes among them: two
    bent sides follow points well by chance, so that their best pair says too much.

    Parameters
    ----------
    summed : (m, 12, 12) rows of each section's own points near a model
    coefficients, radius : of the model, (m, 2, 4) and (m,)
    counted : how often sums over neighbours count each point
    """
    information, said = _of_shape(summed, radius)
    said = said[:, :2] - information[:, :2, 2] * radius[:, None]
    known, told = information[:, :2, :2].sum(axis=0) / counted, said.sum(axis=0) / counted
    best = np.linalg.solve(known + 1e-9 * np.eye(2), told)
    apart = coefficients[..., 2].mean(axis=0) - best
    _, _, average = _perhaps_planes(known[None], told[None])
    return float(average[0] + 0.5 * apart @ known @ apart - 0.5 * told @ best)


def _given(
    information: np.ndarray, said: np.ndarray, radius: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The three with the radius as it is."""
    of_curvatures, covariance = np.empty((len(said), 3)), np.zeros(information.shape)
    of_curvatures[:, 2], covariance[:, 2, 2] = radius, _FIXED
    said = said[:, :2] - information[:, :2, 2] * radius[:, None]
    of_curvatures[:, :2], covariance[:, :2, :2], _ = _perhaps_planes(information[:, :2, :2], said)
    return of_curvatures, covariance


def _of_shape(summed: np.ndarray, radius: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Information (m, 3, 3) on the three and what it says (m, 3), all else left open."""
    normal, right = equations(summed)
    # The rows' unknown is a change of the model's radius; here it is the radius itself.
    right = right + normal[:, :, -1] * radius[:, None]
    open_ = normal[:, _REST][:, :, _REST] + np.diag(
        1.0 / np.tile(np.delete(PRIOR_SIGMA, 2), 2) ** 2
    )
    between = normal[:, CURVATURES_AND_RADIUS][:, :, _REST]
    through = between @ inverses(open_)
    information = normal[:, CURVATURES_AND_RADIUS][:, :, CURVATURES_AND_RADIUS]
    information = information - through @ np.swapaxes(between, 1, 2)
    said = right[:, CURVATURES_AND_RADIUS] - np.einsum("mij,mj->mi", through, right[:, _REST])
    return information, said


def _perhaps_planes(
    information: np.ndarray, said: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Mean (m, k) and covariance (m, k, k) over the four cases of planes and bent sides.

    And the logarithm (m,) of their evidence, but for what is the same in all cases. The first two
    unknowns are the curvatures; nothing is known of others before.
    """
    means, covariances, evidence = [], [], []
    for sigmas in product((PRIOR_SIGMA[2], _PLANE), repeat=2):
        expected = np.append(sigmas, np.full(said.shape[1] - 2, _ANY_RADIUS))
        covariance = inverses(information + np.diag(1.0 / expected**2))
        mean = np.einsum("mij,mj->mi", covariance, said)
        means.append(mean)
        covariances.append(covariance)
        evidence.append(
            0.5 * np.einsum("mi,mi->m", said, mean)
            + 0.5 * np.linalg.slogdet(covariance)[1]
            - np.log(expected).sum()
        )
    odds = np.array(evidence)
    share = np.exp(odds - odds.max(axis=0))
    average = odds.max(axis=0) + np.log(share.mean(axis=0))
    share /= share.sum(axis=0)
    agreed = np.einsum("km,kmi->mi", share, np.array(means))
    apart = np.array(means) - agreed
    spread = np.array(covariances) + apart[..., :, None] * apart[..., None, :]
    return agreed, np.einsum("km,kmij->mij", share, spread), average
