# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scanning: from a click or a start and a gate to the points of an edge."""
