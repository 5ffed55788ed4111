# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pure mathematics: lines, planes, polynomial and B-spline curves."""
