# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine that touches a wedge of two planes, whose every contact is known exactly."""

import numpy as np

from freecad_edgescan.scanning import Gate, ScanParameters, Start, scan_edge

BLUNT = np.radians(100.0)


class WedgeMachine:
    """Two half-planes that meet in the y axis, each falling off from it at an angle.

    In the section the sides are s0 = (-cos a, -sin a) and s1 = (cos a, -sin a), with a half of the
    turn π - θ; a negative turn makes an inner edge. A probe of radius r is touched at the distance
    r from the planes and from the edge.
    """

    def __init__(self, angle=BLUNT, reach=30.0, length=(-20.0, 100.0), radius=0.0):
        fall = 0.5 * (np.pi - angle)
        self.sides = np.array([[-np.cos(fall), -np.sin(fall)], [np.cos(fall), -np.sin(fall)]])
        self.normals = np.array([[-np.sin(fall), np.cos(fall)], [np.sin(fall), np.cos(fall)]])
        self.reach, self.length, self.probe_radius = reach, length, radius
        self.approach = np.array([0.0, 0.0, -1.0])
        self.touches, self.moves = [], []
        self.holes = []  # (low, high) along y where nothing is touched

    def _first(self, start, way, low, high):
        """Smallest parameter in (low, high] at which the probe meets the part."""
        p, d = start[[0, 2]], way[[0, 2]]
        found = []
        for side, normal in zip(self.sides, self.normals, strict=True):
            speed = normal @ d
            if abs(speed) > 1e-12:
                t = (self.probe_radius - normal @ p) / speed
                s = side @ (p + t * d)
                if 0.0 <= s <= self.reach:
                    found.append(t)
        if self.probe_radius:
            b, c = p @ d, p @ p - self.probe_radius**2
            root = b * b - (d @ d) * c
            if root > 0.0:
                for t in ((-b - np.sqrt(root)) / (d @ d), (-b + np.sqrt(root)) / (d @ d)):
                    if np.all(self.sides @ (p + t * d) <= 1e-12):
                        found.append(t)
        good = []
        for t in found:
            y = start[1] + t * way[1]
            hole = any(a < y < b for a, b in self.holes)
            if low < t <= high and self.length[0] <= y <= self.length[1] and not hole:
                good.append(t)
        return min(good) if good else None

    def move(self, start, end):
        self.moves.append((start, end))
        way = end - start
        t = self._first(start, way, 1e-9, 1.0)
        return None if t is None else start + t * way

    def touch(self, start, direction, prehit_distance, search_distance):
        self.touches.append(start)
        t = self._first(start, direction, 0.0, prehit_distance + search_distance)
        return None if t is None else start + t * direction


DEFAULTS = {
    "amplitude": 8.0,
    "line_pitch": 0.8,
    "edge_pitch": 1.0,
    "tolerance": 0.02,
    "degree": 1,
    "pattern": "square",
    "probe_radius": 0.0,
    "approach": (0.0, 0.0, -1.0),
    "prehit_distance": 1.0,
    "search_distance": 10.0,
}


def parameters(literal=False, **values):
    values = {**DEFAULTS, **values}
    return ScanParameters.literal(**values) if literal else ScanParameters(**values)


def start(machine, amplitude=8.0, y=0.0):
    """On side 0, half an amplitude from the edge, across it, walking towards growing y."""
    side = np.array([machine.sides[0][0], 0.0, machine.sides[0][1]])
    return Start(0.5 * amplitude * side + [0.0, y, 0.0], -side, [0.0, 1.0, 0.0])


def gate(machine, y, amplitude=8.0):
    begin = start(machine, amplitude, y)
    return Gate(begin.point, begin.across)


def scan(machine, to=30.0, literal=False, **values):
    values.setdefault("probe_radius", machine.probe_radius)
    amplitude = values.get("amplitude", DEFAULTS["amplitude"])
    return scan_edge(
        machine,
        at=start(machine, amplitude),
        gate=gate(machine, to, amplitude),
        parameters=parameters(literal, **values),
    )


def off_the_edge(edge):
    return np.hypot(edge.points[:, 0], edge.points[:, 2])
