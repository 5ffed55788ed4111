# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: ``./edgescan scan …`` or ``python3 -m freecad_edgescan scan …``.

Each sub-command calls one public function and prints what it answers. Lengths are mm; angles
are degrees here and nowhere else. What a user got wrong is one sentence on stderr and exit
code 2. The numbers packages are imported when a command needs them, so that help is instant.
"""

from __future__ import annotations

import argparse
import os
import sys
import warnings
from collections.abc import Callable, Sequence
from typing import Any

from freecad_edgescan.cloud_file import cloud_of
from freecad_edgescan.command_options import read_options
from freecad_edgescan.output_files import PICTURES, check_output
from freecad_edgescan.terminal_progress import TerminalProgress, exit_code, tell


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one sub-command and answer its exit code."""
    try:
        try:
            return _run(read_options(sys.argv[1:] if arguments is None else arguments))
        finally:
            sys.stdout.flush()
    except BrokenPipeError:  # whoever read what is printed has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141


def _run(options: argparse.Namespace) -> int:
    warnings.showwarning = _show_warning
    try:
        return COMMANDS[options.command](options)
    except BrokenPipeError:
        raise
    except (ValueError, OSError, ImportError, MemoryError) as error:
        if options.debug:
            raise
        tell(_sentence(error))
        return 2
    except KeyboardInterrupt:
        tell("stopped.")
        return 130


def _sentence(error: BaseException) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}." if error.filename else f"{error.strerror}."
    return str(error) or f"{type(error).__name__}; --debug tells where."


def _show_warning(message: Warning | str, category: type[Warning], *_: Any, **__: Any) -> None:
    if issubclass(category, UserWarning):  # the others speak to programmers
        tell(str(message))


# ---------------------------------------------------------------- sub-commands


def _scan(options: argparse.Namespace) -> int:
    from freecad_edgescan.scan_command import scan_file

    return scan_file(options)


def _find(options: argparse.Namespace) -> int:
    from freecad_edgescan.find_command import find_in_file

    return find_in_file(options)


def _recommend(options: argparse.Namespace) -> int:
    from freecad_edgescan.recommend_command import recommend_for_file

    return recommend_for_file(options)


def _info(options: argparse.Namespace) -> int:
    import numpy as np

    from freecad_edgescan.cloud import require_surface
    from freecad_edgescan.geometry.plain_number import plain

    if options.picture:
        check_output(options.picture, PICTURES, options.file)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the table below counts what was dropped
        cloud = cloud_of(options)
    if options.picture:  # before anything is printed: its reader may go away
        from freecad_edgescan.experiments import draw_cloud

        require_surface(cloud)
        draw_cloud(cloud, options.picture)
    lowest, highest = cloud.bounds
    print(f"points   {len(cloud)}")
    print(f"dropped  {cloud.dropped} rows without three finite numbers")
    for axis, low, high in zip("xyz", lowest, highest, strict=True):
        first, last = plain(low, 6, 2), plain(high, 6, 2)
        print(f"{axis}        {first} to {last} mm ({plain(high - low, 6)})")
    require_surface(cloud)
    sample = cloud.points[:: max(1, len(cloud) // 500)]
    coarse, fine = np.nanmedian(cloud.local_pitch(sample), axis=0)
    pitches = f"{plain(coarse, 4)} in the one direction, {plain(fine, 4)} across"
    print(f"pitch    {plain(cloud.pitch, 4)} mm ({pitches})")
    print(f"noise    {plain(cloud.noise, 4)} mm standard deviation along the normal")
    if options.picture:
        print(f"Wrote {options.picture}")
    return 0


def _bench(options: argparse.Namespace) -> int:
    from freecad_edgescan.bench_command import bench

    return bench(options)


def _accuracy(options: argparse.Namespace) -> int:
    from freecad_edgescan.accuracy_command import measure

    return measure(options)


def _doe(options: argparse.Namespace) -> int:
    from freecad_edgescan.doe_command import scan_experiments

    return scan_experiments(options)


def _demo(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.demo import make_demo

    if options.output.is_file():
        raise ValueError(f"{options.output} is a file; give -o a folder, which is made if need be.")
    options.output.mkdir(parents=True, exist_ok=True)
    with TerminalProgress("demo") as progress:
        result = make_demo(options.output, progress)
    if isinstance(result, str):
        print(result)
    return exit_code(progress)


def _casestudy(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.casestudy import make_casestudy

    if options.output.is_file():
        raise ValueError(f"{options.output} is a file; give -o a folder, which is made if need be.")
    with TerminalProgress("casestudy") as progress:
        result = make_casestudy(options.output, progress, pitch=options.pitch)
    print(result)
    return exit_code(progress)


def _sweep(options: argparse.Namespace) -> int:
    from freecad_edgescan.sweep_command import sweep_file

    return sweep_file(options)


def _surfaces(options: argparse.Namespace) -> int:
    from freecad_edgescan.surfaces_command import measure_surfaces

    return measure_surfaces()


COMMANDS: dict[str, Callable[[argparse.Namespace], int]] = {
    "scan": _scan,
    "find": _find,
    "recommend": _recommend,
    "info": _info,
    "bench": _bench,
    "accuracy": _accuracy,
    "doe": _doe,
    "demo": _demo,
    "casestudy": _casestudy,
    "sweep": _sweep,
    "surfaces": _surfaces,
}

if __name__ == "__main__":
    sys.exit(main())
