# SPDX-License-Identifier: LGPL-2.1-or-later
"""One face of a shape as numbers: its triangles, and its exact surface for many points at once.

1. OpenCASCADE turns the face into an exact rational B-spline, whatever surface it was.
2. Its triangles know the trimmed region; their chord error only matters at the rim.
3. Points on the triangles are moved onto the surface by Gauss-Newton steps in (u, v), all at once.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

from .native_surface import as_nurbs

__all__ = ["NurbsFace"]

Array = NDArray[np.float64]

_STEPS = 30


class NurbsFace:
    """A face as triangles and as an exact surface.

    Parameters
    ----------
    face : Part.Face
    chord : float
        Largest distance between triangles and surface, mm.

    Attributes
    ----------
    triangles : (k, 3, 3) array of corners, mm
    chord : largest distance between triangles and surface, mm; 0 for a plane
    """

    def __init__(self, face: Any, chord: float) -> None:
        nurbs = as_nurbs(face)
        corners, triples = nurbs.tessellate(chord)
        xyz = np.array([(p.x, p.y, p.z) for p in corners]).reshape(-1, 3)
        self.triangles: Array = xyz[np.array(triples, dtype=np.intp).reshape(-1, 3)]
        self.chord = 0.0 if face.Surface.TypeId == "Part::GeomPlane" else chord
        self._face = nurbs
        self._sign = -1.0 if nurbs.Orientation == "Reversed" else 1.0
        surface = nurbs.Surface.copy()
        if surface.isUPeriodic():
            surface.setUNotPeriodic()
        if surface.isVPeriodic():
            surface.setVNotPeriodic()
        poles = np.array([[(p.x, p.y, p.z) for p in row] for row in surface.getPoles()])
        weights = np.array(surface.getWeights(), dtype=float)
        net = np.concatenate([poles * weights[..., None], weights[..., None]], axis=2)
        u_knots = np.repeat(surface.getUKnots(), surface.getUMultiplicities()).astype(float)
        v_knots = np.repeat(surface.getVKnots(), surface.getVMultiplicities()).astype(float)
        u_degree, v_degree = surface.UDegree, surface.VDegree
        self._low = np.array([u_knots[u_degree], v_knots[v_degree]])
        self._high = np.array([u_knots[-u_degree - 1], v_knots[-v_degree - 1]])
        self._maps = (
            (net, u_knots, v_knots, u_degree, v_degree),
            (_derived(net, u_knots, u_degree), u_knots[1:-1], v_knots, u_degree - 1, v_degree),
            (
                _derived(net.swapaxes(0, 1), v_knots, v_degree).swapaxes(0, 1),
                u_knots,
                v_knots[1:-1],
                u_degree,
                v_degree - 1,
            ),
        )

    def locate(self, points: Array) -> tuple[Array, Array, Array]:
        """Nearest places on the surface of points that lie near it.

        Parameters
        ----------
        points : (n, 3) array, mm

        Returns
        -------
        (n, 2) parameters, (n, 3) places on the surface, (n, 3) outward unit normals.
        """
        nodes = self._clipped(np.array(self._face.getUVNodes(), dtype=float).reshape(-1, 2))
        place, along_u, along_v = self._evaluate(nodes)
        size = np.linalg.norm(np.cross(along_u, along_v), axis=1)
        usable = size > 1e-6 * size.max()
        uv = nodes[usable][cKDTree(place[usable]).query(points)[1]]
        active = np.arange(len(points))
        for _ in range(_STEPS):
            step = self._newton_step(uv[active], points[active])
            moved = self._clipped(uv[active] + step)
            change = np.abs(moved - uv[active]).max(axis=1, initial=0.0)
            uv[active] = moved
            active = active[change > 1e-9 * (self._high - self._low).max()]
            if not len(active):
                break
        place, normal = self.at(uv)
        lost = np.flatnonzero(np.linalg.norm(place - points, axis=1) > 3.0 * self.chord + 1e-6)
        if len(lost):
            uv[lost] = self._located_by_kernel(points[lost])
            place[lost], normal[lost] = self.at(uv[lost])
        return uv, place, normal

    def at(self, uv: Array) -> tuple[Array, Array]:
        """Places (n, 3) and outward unit normals (n, 3) at parameters (n, 2)."""
        place, along_u, along_v = self._evaluate(uv)
        normal = np.cross(along_u, along_v)
        size = np.linalg.norm(normal, axis=1)
        return place, self._sign * normal / np.where(size > 0.0, size, 1.0)[:, None]

    def offset_growth(self, uv: Array, offset: float) -> Array:
        """Area of the surface offset outwards, in shares of the area it comes from; (n,)."""
        step = 1e-6 * (self._high - self._low)
        low, high = self._clipped(uv - step), self._clipped(uv + step)
        _, along_u, along_v = self._evaluate(uv)
        area = np.linalg.norm(np.cross(along_u, along_v), axis=1)
        grown = []
        for axis, tangent in enumerate((along_u, along_v)):
            before, after = uv.copy(), uv.copy()
            before[:, axis], after[:, axis] = low[:, axis], high[:, axis]
            width = (after - before)[:, axis, None]
            grown.append(tangent + offset * (self.at(after)[1] - self.at(before)[1]) / width)
        return np.linalg.norm(np.cross(grown[0], grown[1]), axis=1) / np.where(
            area > 0.0, area, 1.0
        )

    def _evaluate(self, uv: Array) -> tuple[Array, Array, Array]:
        """Places and both first derivatives (n, 3)."""
        value, by_u, by_v = (_tensor(uv, *one) for one in self._maps)
        weight = value[:, 3:]
        place = value[:, :3] / weight
        return (
            place,
            (by_u[:, :3] - place * by_u[:, 3:]) / weight,
            (by_v[:, :3] - place * by_v[:, 3:]) / weight,
        )

    def _newton_step(self, uv: Array, points: Array) -> Array:
        place, along_u, along_v = self._evaluate(uv)
        away = points - place
        uu, uv_, vv = (
            np.einsum("ij,ij->i", a, b)
            for a, b in ((along_u, along_u), (along_u, along_v), (along_v, along_v))
        )
        uu, vv = uu + 1e-14 * (uu + vv), vv + 1e-14 * (uu + vv)
        u_side, v_side = (np.einsum("ij,ij->i", a, away) for a in (along_u, along_v))
        size = uu * vv - uv_ * uv_
        size = np.where(size > 0.0, size, 1.0)
        return np.column_stack(
            [(vv * u_side - uv_ * v_side) / size, (uu * v_side - uv_ * u_side) / size]
        )

    def _located_by_kernel(self, points: Array) -> Array:
        """Ask OpenCASCADE, point by point, where Newton's steps have strayed."""
        import FreeCAD

        surface = self._face.Surface
        found = [surface.parameter(FreeCAD.Vector(*point)) for point in points]
        return self._clipped(np.array(found, dtype=float).reshape(-1, 2))

    def _clipped(self, uv: Array) -> Array:
        """Parameters inside the surface's range; periodic ones of the kernel are wrapped first."""
        if np.any(uv < self._low) or np.any(uv > self._high):
            surface = self._face.Surface
            for axis, periodic in enumerate((surface.isUPeriodic(), surface.isVPeriodic())):
                if periodic:
                    width = self._high[axis] - self._low[axis]
                    outside = (uv[:, axis] < self._low[axis]) | (uv[:, axis] > self._high[axis])
                    wrapped = self._low[axis] + np.mod(uv[:, axis] - self._low[axis], width)
                    uv[:, axis] = np.where(outside, wrapped, uv[:, axis])
        return np.clip(uv, self._low, self._high)


def _derived(net: Array, knots: Array, degree: int) -> Array:
    """Poles of the derivative along the first axis."""
    width = knots[degree + 1 : -1] - knots[1 : -degree - 1]
    width = np.where(width > 0.0, width, 1.0)
    return degree * np.diff(net, axis=0) / width[:, None, None]


def _tensor(
    uv: Array, net: Array, u_knots: Array, v_knots: Array, u_degree: int, v_degree: int
) -> Array:
    """Tensor-product spline at parameters (n, 2)."""
    u_basis, u_first = _basis(uv[:, 0], u_knots, u_degree)
    v_basis, v_first = _basis(uv[:, 1], v_knots, v_degree)
    value = np.zeros((len(uv), net.shape[2]))
    for i in range(u_degree + 1):
        for j in range(v_degree + 1):
            share = u_basis[:, i] * v_basis[:, j]
            value += share[:, None] * net[u_first + i, v_first + j]
    return value


def _basis(x: Array, knots: Array, degree: int) -> tuple[Array, NDArray[np.intp]]:
    """The degree + 1 basis functions that are not zero, and the number of the first."""
    if not len(x):
        return np.zeros((0, degree + 1)), np.zeros(0, dtype=np.intp)
    matrix = BSpline.design_matrix(x, knots, degree)
    values = matrix.data.reshape(len(x), degree + 1)
    return values, matrix.indices.reshape(len(x), degree + 1)[:, 0].astype(np.intp)
