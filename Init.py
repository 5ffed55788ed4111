# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD runs this at each start, with and without a window: nothing to register."""
