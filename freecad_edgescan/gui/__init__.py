# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench: commands, panels and what is drawn on the screen."""
