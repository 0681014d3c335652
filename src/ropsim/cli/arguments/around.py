"""Commands about ropsim itself: explanations, the studio, trust, the language server."""

from ropsim.cli.arguments.command import Commands, command, lazy


def explain(commands: Commands) -> None:
    """Add `ropsim explain`."""
    parser = command(commands, "explain", "explain:explain", "explain a diagnostic code such as M502")
    parser.add_argument("code", metavar="CODE", nargs="?", help="without a code: list all")


def studio(commands: Commands) -> None:
    """Add `ropsim studio`."""
    parser = commands.add_parser(
        "studio",
        help="see, edit and run a project in the browser",
        description="See, edit and run a project in the browser. Prints the address; Ctrl+C ends the studio.",
    )
    parser.add_argument(
        "path", metavar="PROJECT", nargs="?", default=".", help="project folder (default: this folder)"
    )
    parser.add_argument(
        "--port",
        metavar="N",
        type=int,
        default=0,
        help="port (default: that of the last time, else any free one)",
    )
    parser.add_argument("--no-browser", action="store_true", help="do not open the browser")
    parser.set_defaults(command=lazy("servers:studio"), json=False)


def trust(commands: Commands) -> None:
    """Add `ropsim trust`."""
    parser = command(
        commands,
        "trust",
        "trust:trust",
        "let code inside a project folder run",
        "Controllers in Python, FMUs and the like stay inert until their project is trusted.",
    )
    parser.add_argument("path", metavar="PATH", help="project folder")
    parser.add_argument("--revoke", action="store_true", help="trust it no longer")


def lsp(commands: Commands) -> None:
    """Add `ropsim lsp`."""
    parser = commands.add_parser(
        "lsp",
        help="language server for editors, on standard input and output",
        description="Diagnostics, completion and hover for task programs and cell files. Editors start it.",
    )
    parser.set_defaults(command=lazy("servers:lsp"), json=False)
