# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: ``./edgescan scan …`` or ``python3 -m freecad_edgescan scan …``.

Each sub-command calls one public function and prints what it answers. Lengths are mm; angles
are degrees here and nowhere else. What a user got wrong is one sentence on stderr and exit
code 2. The numbers packages are imported when a command needs them, so that help is instant.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from freecad_edgescan.terminal_progress import TerminalProgress, tell

if TYPE_CHECKING:
    from freecad_edgescan.cloud import PointCloud
    from freecad_edgescan.scanning import ScannedEdge

Vector = tuple[float, float, float]

PICTURES = (".png", ".svg", ".pdf", ".jpg")

SCAN_EXAMPLES = """examples:
  edgescan scan part.ply --at 12.5,-3,40 -o edge.step
  edgescan scan part.xyz --at 1,2,3 --at 4,5,6 -o edges.csv -o edges.step --picture edges.png
  edgescan scan probed.asc --probe-radius 1 --approach 0,0,-1 --at 10,0,5 --gate 90,0,5 -o rim.step
  edgescan scan part.ply --start 0,-5,0 --across 0,1,0 --along 1,0,0 \\
                         --gate 80,-5,0 --gate-across 0,1,0 --amplitude 10
"""

ACCURACY_TEXT = """Simulates a scan of each part, clicks every sharp edge at its middle, and
compares what is found with the part's own edges.
  length   of the true edge           room    smallest distance to another edge
  traced   share of it found within one pitch
  rms max  distance of the edge points from it
  sigma    mean standard deviation that the scan states itself
"""


class _Parser(argparse.ArgumentParser):
    """Says what is wrong in one sentence instead of printing the whole usage."""

    def error(self, message: str) -> NoReturn:
        self.exit(2, f"{self.prog}: {message}; {self.prog} --help tells more.\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one sub-command and answer its exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    options = _parser().parse_args(_bind_negative_values(words))
    warnings.showwarning = _show_warning
    try:
        code = int(options.run(options))
        sys.stdout.flush()
        return code
    except BrokenPipeError:  # whoever read what is printed has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 141
    except (ValueError, OSError, ImportError, MemoryError) as error:
        if options.debug:
            raise
        tell(_sentence(error))
        return 2
    except KeyboardInterrupt:
        tell("stopped.")
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="edgescan", description="True sharp edges from scanned point clouds.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND", dest="command")

    scan = _add_command(commands, "scan", _scan, "scan edges of a cloud", SCAN_EXAMPLES)
    scan.add_argument("file", help=".xyz .txt .asc .csv .ply .pcd")
    scan.add_argument(
        "--at", type=_vector, action="append", default=[], metavar="X,Y,Z",
        help="a point near an edge, mm; repeat for more edges",
    )  # fmt: skip
    scan.add_argument("--start", type=_vector, metavar="X,Y,Z", help="first point, on one side")
    scan.add_argument("--across", type=_vector, metavar="DX,DY,DZ", help="from it over the edge")
    scan.add_argument("--along", type=_vector, metavar="DX,DY,DZ", help="from it along the edge")
    scan.add_argument(
        "--gate", type=_vector, metavar="X,Y,Z",
        help="walk towards this point and end there; with --gate-across the gate's first end",
    )  # fmt: skip
    scan.add_argument(
        "--gate-across", type=_vector, metavar="DX,DY,DZ", help="from the gate over the edge"
    )
    scan.add_argument("--amplitude", type=float, metavar="MM", help="both sides together")
    scan.add_argument("--edge-pitch", type=float, metavar="MM", help="distance of edge points")
    scan.add_argument(
        "--probe-radius", type=float, default=0.0, metavar="MM",
        help="the cloud holds centres of a ball of this radius",
    )  # fmt: skip
    scan.add_argument(
        "--approach", type=_vector, metavar="DX,DY,DZ", help="direction the probe came along"
    )
    scan.add_argument(
        "-o", "--output", type=Path, action="append", default=[], metavar="FILE",
        help=".step for CAD (needs FreeCAD), .csv for edge points with sigma; repeatable",
    )  # fmt: skip
    scan.add_argument("--picture", type=Path, metavar="FILE.png", help="cloud and edges, drawn")
    scan.add_argument(
        "--view", type=_vector, metavar="DX,DY,DZ",
        help="direction from the part to the viewer of the picture (default: the edges' air side)",
    )  # fmt: skip
    scan.add_argument(
        "--section", type=Path, metavar="FILE.png",
        help="the section of the first edge where it was clicked, drawn",
    )  # fmt: skip

    info = _add_command(commands, "info", _info, "what is in a cloud file")
    info.add_argument("file", help=".xyz .txt .asc .csv .ply .pcd")

    bench = _add_command(commands, "bench", _bench, "how fast this machine is")
    bench.add_argument("--points", type=int, default=1_000_000, metavar="N", help="cloud size")

    accuracy = _add_command(
        commands, "accuracy", _accuracy, "how exactly edges of CAD parts are found", ACCURACY_TEXT
    )
    accuracy.add_argument(
        "--parts", nargs="+", type=Path, default=[], metavar="FILE",
        help=".step .iges .brep; default: a block with a blind bore",
    )  # fmt: skip
    for option, value, text in (
        ("--pitch", 0.6, "of the simulated scan"),
        ("--noise", 0.12, "of the simulated scan, standard deviation along the normal"),
        ("--probe-radius", 0.0, "simulate centres of a ball of this radius"),
    ):
        accuracy.add_argument(
            option, type=float, default=value, metavar="MM", help=f"{text} (default: {value:g})"
        )
    accuracy.add_argument("--seed", type=int, default=0, metavar="N", help="of the random numbers")

    demo = _add_command(
        commands, "demo", _demo, "scan the edges of a simulated core box, sweep and loft"
    )
    demo.add_argument(
        "-o", "--output", type=Path, default=Path("demo"), metavar="FOLDER",
        help="where the document, STEP, table and pictures go (default: demo)",
    )  # fmt: skip
    return parser


def _add_command(
    commands: Any, name: str, run: Any, summary: str, epilog: str | None = None
) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(
        name,
        help=summary,
        description=summary[0].upper() + summary[1:] + ". Lengths are mm.",
        epilog=epilog,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--debug", action="store_true", help="show where an error came from")
    parser.set_defaults(run=run)
    return parser


def _bind_negative_values(words: Sequence[str]) -> list[str]:
    """Write ``--at -1,2,3`` as ``--at=-1,2,3``, which argparse would take for an option."""
    bound: list[str] = []
    for word in words:
        if bound and re.match(r"-\.?\d", word) and re.fullmatch(r"--[a-z-]+", bound[-1]):
            bound[-1] += f"={word}"
        else:
            bound.append(word)
    return bound


def _vector(text: str) -> Vector:
    try:
        x, y, z = (float(number) for number in re.split(r"[,;\s]+", text.strip()))
    except ValueError:
        words = f"{text!r} is not three numbers such as 1.5,-2,30"
        raise argparse.ArgumentTypeError(words) from None
    return x, y, z


def _sentence(error: BaseException) -> str:
    if isinstance(error, OSError) and error.strerror:
        return f"{error.filename}: {error.strerror}." if error.filename else f"{error.strerror}."
    return str(error) or f"{type(error).__name__}; --debug tells where."


def _show_warning(message: Warning | str, category: type[Warning], *_: Any, **__: Any) -> None:
    if issubclass(category, UserWarning):  # the others speak to programmers
        tell(str(message))


# ---------------------------------------------------------------- sub-commands


def _scan(options: argparse.Namespace) -> int:
    from freecad_edgescan.cloud import read_cloud
    from freecad_edgescan.scanning import ScanParameters

    targets = _targets(options)
    _check_outputs(options, len(targets))
    parameters = ScanParameters(amplitude=options.amplitude, edge_pitch=options.edge_pitch)
    cloud = read_cloud(options.file, options.probe_radius, options.approach)
    edges, code = _scan_targets(cloud, targets, parameters)
    if not edges:
        return code
    written: list[Path] = []
    try:  # files first: who reads what is printed may go away
        for path in _write(options, cloud, targets, edges):
            written.append(path)
    finally:
        print(_table(edges))
        for path in written:
            print(f"Wrote {path}")
    return code


def _write(
    options: argparse.Namespace,
    cloud: PointCloud,
    targets: Sequence[tuple[Any, Any]],
    edges: dict[int, ScannedEdge],
) -> Iterator[Path]:
    """Write what was asked for, and name each file when it is written."""
    for path in options.output:
        if path.suffix.lower() == ".csv":
            for number, edge in edges.items():
                edge.to_csv(file := _numbered(path, number, len(targets)))
                yield file
        else:
            _write_step(edges, path)
            yield path
    if options.picture:
        from freecad_edgescan.experiments import draw_edges

        names = [f"edge {number}" for number in edges]
        draw_edges(cloud, list(edges.values()), options.picture, options.view, names)
        yield options.picture
    if options.section:
        from freecad_edgescan.experiments import draw_section

        number, edge = next(iter(edges.items()))
        at = targets[number - 1][0]
        draw_section(edge, getattr(at, "point", at), options.section)
        yield options.section


def _numbered(path: Path, number: int, of: int) -> Path:
    """The table of one click of several: name-1.csv, name-2.csv and so on."""
    return path if of == 1 else path.with_stem(f"{path.stem}-{number}")


def _write_step(edges: dict[int, ScannedEdge], path: Path) -> None:
    try:
        from freecad_edgescan.document import export_step
    except ImportError as error:
        raise ValueError(
            f"{path} needs FreeCAD, which did not load ({error}); write .csv instead."
        ) from error
    export_step(list(edges.values()), path)


def _targets(options: argparse.Namespace) -> list[tuple[Any, Any]]:
    """What to scan from and to: pairs of a click or Start, and a point, Gate or None."""
    from freecad_edgescan.scanning import Gate, Start

    gate: Any = options.gate
    if options.gate_across is not None:
        if gate is None:
            raise ValueError("--gate-across needs --gate, the gate's first end; give both.")
        gate = Gate(gate, options.gate_across)
    if options.start is None:
        if options.across is not None or options.along is not None:
            raise ValueError("--across and --along belong to --start; give it, or leave them out.")
        if not options.at:
            raise ValueError("no place to scan at was given; give --at X,Y,Z near an edge.")
        if gate is not None and len(options.at) > 1:
            raise ValueError(
                f"one --gate cannot end {len(options.at)} edges; give one --at with it."
            )
        return [(at, gate) for at in options.at]
    if options.at:
        raise ValueError("--at and --start both say where to begin; give one of them.")
    if options.across is None or options.along is None:
        raise ValueError("--start needs --across and --along; give these two directions.")
    return [(Start(options.start, options.across, options.along), gate)]


def _check_outputs(options: argparse.Namespace, clicks: int) -> None:
    """Refuse, before anything is read, what cannot be written or would write over the scan."""
    for path in options.output:
        _check_output(path, (".step", ".stp", ".csv"), options.file)
        if path.suffix.lower() == ".csv":
            for number in range(1, clicks + 1):
                _check_not_the_scan(_numbered(path, number, clicks), options.file)
    for picture in (options.picture, options.section):
        if picture:
            _check_output(picture, PICTURES, options.file)


def _check_output(path: Path, endings: Sequence[str], scan: str) -> None:
    _check_not_the_scan(path, scan)
    if path.suffix.lower() not in endings:
        raise ValueError(f"{path} has an unknown ending; use one of {' '.join(endings)}.")
    if not path.parent.is_dir():
        raise ValueError(f"{path} cannot be written: there is no folder {path.parent}.")


def _check_not_the_scan(path: Path, scan: str) -> None:
    if path.exists() and Path(scan).exists() and path.samefile(scan):
        raise ValueError(f"{path} is the scan itself, which is never overwritten; name another.")


def _scan_targets(
    cloud: PointCloud, targets: Sequence[tuple[Any, Any]], parameters: Any
) -> tuple[dict[int, ScannedEdge], int]:
    """Edges by their number, and the exit code: 2 after a failure, 130 after Ctrl-C.

    A target that fails is told and leaves the others alone.
    """
    from freecad_edgescan.scanning import scan_edge

    edges: dict[int, ScannedEdge] = {}
    for number, (at, gate) in enumerate(targets, 1):
        with TerminalProgress(f"edge {number} of {len(targets)}") as progress:
            try:
                edges[number] = scan_edge(
                    cloud, at=at, gate=gate, parameters=parameters, progress=progress
                )
            except ValueError as error:
                progress.clear()
                tell(f"edge {number}: {error}")
        if progress.cancelled:
            return edges, _exit_code(progress)
    return edges, 0 if len(edges) == len(targets) else 2


def _exit_code(progress: TerminalProgress) -> int:
    """0, or what a shell expects after Ctrl-C."""
    if not progress.cancelled:
        return 0
    tell("stopped; what was found so far is kept.")
    return 130


def _table(edges: dict[int, ScannedEdge]) -> str:
    import numpy as np

    lines = [
        "edge  points     length  stops at start / end       sigma   angle   fillet",
        "                     mm                             mean mm   deg  radius mm",
    ]
    for number, edge in edges.items():
        path = np.vstack([edge.points, edge.points[:1]]) if edge.closed else edge.points
        length = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
        stops = " / ".join(stop.name for stop in edge.stops)
        radii = edge.fillet_radius[np.isfinite(edge.fillet_radius)]
        radius = f"{np.median(radii):9.3f}" if len(radii) else "        -"
        sigma, angle = np.mean(edge.sigma), np.degrees(np.mean(edge.angle))
        lines.append(
            f"{number:4d}  {len(edge.points):6d}  {length:9.3f}  {stops:<24}"
            f"  {_digits(sigma):>7}  {angle:6.1f}  {radius}"
        )
        if edge.message:
            lines.append(f"      {edge.message}")
    return "\n".join(lines)


def _digits(sigma: float) -> str:
    """Four decimals, or two significant digits where these would say less."""
    return f"{sigma:.4f}" if sigma >= 0.00095 else f"{sigma:.2g}"


def _info(options: argparse.Namespace) -> int:
    import numpy as np

    from freecad_edgescan.cloud import read_cloud, require_surface

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the table below counts what was dropped
        cloud = read_cloud(options.file)
    lowest, highest = cloud.bounds
    print(f"points   {len(cloud)}")
    print(f"dropped  {cloud.dropped} rows without three finite numbers")
    for axis, low, high in zip("xyz", lowest, highest, strict=True):
        print(f"{axis}        {low:.6g} to {high:.6g} mm ({high - low:.6g})")
    require_surface(cloud)
    sample = cloud.points[:: max(1, len(cloud) // 500)]
    coarse, fine = np.nanmedian(cloud.local_pitch(sample), axis=0)
    print(f"pitch    {cloud.pitch:.4g} mm ({coarse:.4g} in the one direction, {fine:.4g} across)")
    print(f"noise    {cloud.noise:.4g} mm standard deviation along the normal")
    return 0


def _bench(options: argparse.Namespace) -> int:
    from freecad_edgescan.experiments import measure_speed

    with TerminalProgress("bench") as progress:
        speed = measure_speed(options.points, progress)
    print(f"cloud              {speed.points} points")
    for ending, seconds in speed.reading.items():
        ratio = seconds / speed.bare_indexing
        print(
            f"reading {ending}       {speed.per_million(seconds):.2f} s per million points "
            f"({ratio:.1f} x SciPy's bare KD-tree)"
        )
    print(
        f"indexing           {speed.per_million(speed.indexing):.2f} s per million points "
        f"({speed.indexing_ratio:.2f} x SciPy's bare KD-tree, "
        f"{speed.per_million(speed.bare_indexing):.2f} s)"
    )
    print(
        f"scanning           {speed.edge_points_per_second:.0f} edge points per second "
        f"({speed.edge_points} in {speed.scanning:.2f} s, mean error {speed.mean_error:.4f} mm)"
    )
    return 0


def _accuracy(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.part_report import block_with_bore, read_part, report_part

    parts = [(file.name, read_part(file)) for file in options.parts]
    for number, (name, shape) in enumerate(parts or [("block with bore", block_with_bore())]):
        with TerminalProgress(name) as progress:
            report = report_part(
                shape,
                name,
                options.pitch,
                options.noise,
                options.probe_radius,
                options.seed,
                progress,
            )
        print(("\n" if number else "") + report.text())
        if progress.cancelled:
            return _exit_code(progress)
    return 0


def _demo(options: argparse.Namespace) -> int:
    from freecad_edgescan.document.demo import make_demo

    options.output.mkdir(parents=True, exist_ok=True)
    with TerminalProgress("demo") as progress:
        result = make_demo(options.output, progress)
    if isinstance(result, str):
        print(result)
    return _exit_code(progress)


if __name__ == "__main__":
    sys.exit(main())
