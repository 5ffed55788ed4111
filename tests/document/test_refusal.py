# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user did wrong is said in one sentence; a fault of ours keeps its trace."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from freecad_edgescan.document.refusal import RefusalError


def test_a_refusal_that_was_dropped_leaves_the_printing_of_traces_as_it_was() -> None:
    def refuse() -> None:
        raise RefusalError("No")

    before = getattr(sys, "tracebacklimit", None)
    with pytest.raises(RefusalError, match="No") as refusal:
        refuse()
    del refusal
    import gc

    gc.collect()
    assert getattr(sys, "tracebacklimit", None) == before


def test_only_the_sentence_of_a_refusal_is_printed() -> None:
    program = "from freecad_edgescan.document.refusal import RefusalError\n"
    program += "raise RefusalError('The amplitude is too small.')"
    run = subprocess.run(
        ["/usr/bin/python3", "-c", program],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parents[2],
    )
    assert "The amplitude is too small." in run.stderr
    assert "File" not in run.stderr


def test_an_edge_that_refuses_its_inputs_leaves_the_printing_of_traces_as_it_was(doc: Any) -> None:
    from freecad_edgescan import document

    cloud = document.make_cloud(doc, [(0.1 * i, 0.01 * i * i, i % 3) for i in range(50)])
    edge = document.make_scanned_edge(doc, cloud, at=(1e3, 0, 0))
    before = getattr(sys, "tracebacklimit", None)
    doc.recompute()
    assert "Invalid" in edge.State
    assert edge.getStatusString() == edge.Message
    assert getattr(sys, "tracebacklimit", None) == before
