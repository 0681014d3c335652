"""Commands about the controller of a cell."""

import argparse

from ropsim.cli.arguments.command import Commands, command
from ropsim.cli.arguments.quantities import FREQUENCY, band, coordinate, reader, speed, step


def controller(commands: Commands) -> None:
    """Add `ropsim controller`."""
    group = commands.add_parser(
        "controller",
        help="show how the loops of a cell answer steps, ramps and sines; find gains",
        description="The joint controller of a cell: responses, stability margins, gains.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    _response(actions)
    _tune(actions)


def _response(actions: Commands) -> None:
    parser = command(
        actions,
        "response",
        "controllers.response:response",
        "print responses of the axes and the stability margins of their loops",
        "Without an option each axis makes a small step.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder, its cell.toml, or one of its programs")
    parser.add_argument("--axis", metavar="NAME", help="number of one axis, from 1, or name of its joint")
    parser.add_argument("--station", metavar="NAME", help="whose controller (default: the first one)")
    excitation = parser.add_mutually_exclusive_group()
    excitation.add_argument(
        "--step", metavar="SIZE", type=step, help="step of the reference, such as 5deg or 2mm"
    )
    excitation.add_argument(
        "--ramp", metavar="SPEED", type=speed, help="speed of the reference from rest, such as 20deg/s"
    )
    excitation.add_argument(
        "--sweep", metavar="F1..F2", type=band, help="sines of these frequencies, such as 1..50Hz"
    )
    place = parser.add_mutually_exclusive_group()
    place.add_argument("--at", metavar="LOCATION", help="where the tool is (default: where the cell begins)")
    place.add_argument(
        "--joints",
        metavar="DEG",
        nargs="+",
        type=coordinate,
        help="joint coordinates in degrees (mm for sliding joints)",
    )
    parser.add_argument(
        "--report", metavar="FILE.html", help="also write a page with the curves of all tested axes"
    )


def _tune(actions: Commands) -> None:
    parser = command(
        actions,
        "tune",
        "controllers.tune:tune",
        "find gains of a station, and show what its loops bear over the places of its arm",
        "Without --bandwidth it finds the largest ones with Ms up to 2 and a gain margin of at least 2.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder, its cell.toml, or one of its programs")
    parser.add_argument("--station", metavar="NAME", help="whose controller (default: the first one)")
    parser.add_argument(
        "--bandwidth",
        metavar="HZ",
        nargs="+",
        type=reader("frequency", FREQUENCY),
        help="of all axes, or one for each axis, such as 5Hz",
    )
    parser.add_argument(
        "--damping", metavar="D", type=_ratio, help="damping ratio of the axes (default: 0.91)"
    )


def _ratio(text: str) -> float:
    """Return a damping ratio."""
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.1 <= value <= 10.0:
        raise argparse.ArgumentTypeError(f"`{text}` is no damping ratio from 0.1 to 10")
    return value
