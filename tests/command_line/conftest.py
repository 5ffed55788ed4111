# SPDX-License-Identifier: LGPL-2.1-or-later
"""The roof as a file."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from .roof import roof


@pytest.fixture
def roof_file(tmp_path: Path) -> Path:
    path = tmp_path / "roof.xyz"
    np.savetxt(path, roof())
    return path
