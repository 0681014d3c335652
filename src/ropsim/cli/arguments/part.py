"""`ropsim part`."""

from ropsim.cli.arguments.command import Commands, command


def part(commands: Commands) -> None:
    """Add `ropsim part`."""
    group = commands.add_parser(
        "part",
        help="show the library of grippers, conveyors, fences, pallets and so on",
        description="Parts of the library, for the key `part` of a cell file.",
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    command(actions, "list", "part:list_", "list the kinds of parts")
    show = command(
        actions, "show", "part:show", "print parameters, models and where the numbers of a kind come from"
    )
    show.add_argument("kind", metavar="KIND", help="name of a kind, see `ropsim part list`")
    show.add_argument(
        "--model", metavar="MODEL", default="", help="of which the picture is (default: the kind as it is)"
    )
    show.add_argument("--png", metavar="FILE", help="draw it into this picture, too")
