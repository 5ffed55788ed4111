# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGAL's Voronoi covariance measure as a peer: a small program, built when it is asked for."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from ..cloud import PointCloud

__all__ = ["VoronoiPeer"]

_SOURCE = Path(__file__).with_name("voronoi_covariance.cpp")
_EIGEN = "/usr/include/eigen3"
_OFFSET, _CONVOLUTION = 6.0, 3.0  # pitches
_THRESHOLD = 0.16  # as in CGAL's manual: edges that turn by 26 degrees and more
_HOW = "apt-get install g++ libcgal-dev libeigen3-dev gets it"


class VoronoiPeer:
    """Labels points on feature edges; a context, in which the program is there.

    Raises
    ------
    ValueError: it cannot be built here; what to install.
    """

    def __enter__(self) -> VoronoiPeer:
        compiler = shutil.which("g++")
        if compiler is None:
            raise ValueError(f"CGAL's program needs a compiler: {_HOW}.")
        self._folder = TemporaryDirectory(prefix="edgescan-")
        self._program = Path(self._folder.name) / "voronoi_covariance"
        options = ["-O2", "-DNDEBUG", "-DCGAL_EIGEN3_ENABLED", "-I", _EIGEN]
        built = subprocess.run(
            [compiler, *options, "-o", self._program, _SOURCE, "-lgmp", "-lmpfr"],
            capture_output=True,
            text=True,
        )
        if built.returncode:
            self._folder.cleanup()
            why = next((line for line in built.stderr.splitlines() if "error" in line), "no reason")
            raise ValueError(f"CGAL's program cannot be built ({why.strip()}): {_HOW}.")
        return self

    def __exit__(self, *_: object) -> None:
        self._folder.cleanup()

    def labelled(self, cloud: PointCloud) -> NDArray[np.float64]:
        """The points on feature edges, (k, 3) mm.

        Raises
        ------
        ValueError: the program failed.
        """
        lengths = (str(length * cloud.pitch) for length in (_OFFSET, _CONVOLUTION))
        answer = subprocess.run(
            [self._program, *lengths, str(_THRESHOLD)],
            input=np.ascontiguousarray(cloud.points).tobytes(),
            stdout=subprocess.PIPE,
        )
        if answer.returncode:
            raise ValueError(f"CGAL's program ended with code {answer.returncode}.")
        return cloud.points[np.frombuffer(answer.stdout, dtype=np.uint8) == 1]
