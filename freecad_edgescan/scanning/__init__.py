# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanning of edges: from a cloud and a click to edge points with their uncertainty."""

from .analytic_cmm import AnalyticCmm
from .boundary import scan_boundary
from .cmm import Cmm
from .errors import ScanError
from .network import EdgeNetwork, Region, find_edges
from .parameters import Compensation, Pattern, ScanParameters, Steering, Tangent
from .point_cloud_cmm import PointCloudCmm
from .probed_lines import ProbedLines
from .progress import Progress, SoFar
from .recommendation import Recommendation, recommend_parameters
from .safeguards import Safeguards
from .scan import scan_edge
from .scan_lines import ScanLine, ScanLines
from .scanned_edge import ScannedEdge
from .section import Frames, Section, Station
from .section_outline import SectionOutline, section_outline
from .start import Gate, Start
from .stop import Stop

__all__ = [
    "AnalyticCmm",
    "Cmm",
    "EdgeNetwork",
    "Region",
    "find_edges",
    "PointCloudCmm",
    "ProbedLines",
    "Safeguards",
    "Compensation",
    "Frames",
    "Gate",
    "Pattern",
    "Progress",
    "Recommendation",
    "ScanError",
    "ScanLine",
    "ScanLines",
    "ScanParameters",
    "ScannedEdge",
    "Section",
    "SectionOutline",
    "SoFar",
    "Start",
    "Station",
    "Steering",
    "Stop",
    "Tangent",
    "recommend_parameters",
    "scan_boundary",
    "scan_edge",
    "section_outline",
]
