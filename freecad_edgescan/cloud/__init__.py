# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds: reading, writing, pitch and noise, simulated clouds with known truth."""
