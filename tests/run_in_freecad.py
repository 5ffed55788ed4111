# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs pytest inside FreeCAD; given to `freecadcmd` or `freecad` by `./edgescan test`.

FreeCAD imports a script, runs it again when it raised, and exits 0 whatever happened.
So nothing may leave this file as an exception, and the code that counts is written to
a file: `exit-code` in the folder EDGESCAN_PYTEST_HOME, which also holds the arguments
for pytest, one a line. EDGESCAN_VENV is the virtual environment pytest lives in.
"""

import os
import sys
import traceback
from pathlib import Path


def run_pytest(arguments: list[str]) -> int:
    """Exit code of pytest, run from the repository with the development tools in reach."""
    repository = Path(__file__).resolve().parents[1]
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    tools = Path(os.environ["EDGESCAN_VENV"]) / "lib" / version / "site-packages"
    sys.path[:0] = [str(tools), str(repository)]
    os.chdir(repository)
    # Inside the window FreeCAD puts its report view in place of the two streams.
    sys.stdout, sys.stderr = sys.__stdout__, sys.__stderr__

    import pytest

    return int(pytest.main([f"--rootdir={repository}", *arguments]))


def close_documents() -> None:
    """Leave nothing open that FreeCAD could ask about on its way out."""
    import FreeCAD

    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


def main() -> int:
    """Run pytest and write its exit code, or what prevented it."""
    home = Path(os.environ["EDGESCAN_PYTEST_HOME"])
    code = 3
    try:
        code = run_pytest((home / "pytest-arguments").read_text().splitlines())
        close_documents()
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    (home / "exit-code").write_text(str(code))
    return code


sys.exit(main())
