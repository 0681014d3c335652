"""`ropsim icr`."""

from ropsim.cli.arguments.command import Commands, command

_PROGRAM = "a .task, .icr or .icb file, or a project: its program"


def icr(commands: Commands) -> None:
    """Add `ropsim icr`."""
    group = commands.add_parser(
        "icr",
        help="work with ICR, the neutral robot program",
        description=("ICR is the flat, verifiable, robot-independent program that the simulator runs."),
    )
    actions = group.add_subparsers(title="actions", metavar="ACTION", required=True)
    compile_ = command(actions, "compile", "icr:compile_", "print the ICR of a task program")
    compile_.add_argument("path", metavar="FILE.task", help=_PROGRAM)
    compile_.add_argument("-o", "--output", metavar="FILE.icr", help="write to a file instead")
    asm = command(actions, "asm", "icr:asm", "write the binary form of a program")
    asm.add_argument("path", metavar="FILE", help=_PROGRAM)
    asm.add_argument("-o", "--output", metavar="FILE.icb", required=True, help="file to write")
    dis = command(actions, "dis", "icr:dis", "print the text of a binary program")
    dis.add_argument("path", metavar="FILE.icb", help="a binary program")
    dis.add_argument("-o", "--output", metavar="FILE.icr", help="write to a file instead")
    verify = command(actions, "verify", "icr:verify", "check an ICR program against rules V1 to V9")
    verify.add_argument("path", metavar="FILE", help=_PROGRAM)
    run = command(
        actions, "run", "icr:run", "execute an ICR program without a robot and print its instructions"
    )
    run.add_argument("path", metavar="FILE", help=_PROGRAM)
