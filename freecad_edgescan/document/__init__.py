# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parametric FreeCAD objects and the bridge between numpy and FreeCAD, without a screen."""
