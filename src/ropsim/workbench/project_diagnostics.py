"""Diagnostics of projects (X843 to X849, X895, X911, X912 and X922)."""

from ropsim.core import Category, Severity, define

NO_PROJECT = define(
    "X843",
    "not-a-project",
    Severity.ERROR,
    "a folder without `cell.toml`, or a file of unknown kind",
    """
A project is a folder with a `cell.toml` (robot, tools, frames, parts) and a folder `programs` with tasks:

    my_cell/
      cell.toml
      programs/main.task

Give the folder, its `cell.toml`, or one of its programs.
""",
    Category.USAGE,
)

NO_PROGRAM = define(
    "X844",
    "no-such-program",
    Severity.ERROR,
    "a program that the project does not have",
    """
Programs are the files `programs/*.task` and `programs/*.icr`; their names are those of the files without the
ending. Without a name, the program named in `[cell] program` runs, or else `main`; a station of `[stations]`
runs its `program`, or else the one that has its name. A station with `program = ""` stands still.
""",
    Category.USAGE,
)

NO_CELL = define(
    "X845",
    "program-without-cell",
    Severity.ERROR,
    "a program that cannot be simulated because it belongs to no cell",
    """
A program can be checked alone, but to simulate it needs a cell: a robot, tools, frames. Put the file into the
folder `programs` of a project whose `cell.toml` describes them.
""",
)

UNBOUND = define(
    "X846",
    "unbound-name",
    Severity.ERROR,
    "a program uses a signal or tool that the cell does not have",
    """
A program names its channels and tools; the cell binds them. A signal that the program reads or sets must
stand under `[signals]` in `cell.toml`, a tool without a pose of its own under `[tools]` (verifier rule V11).
""",
)

NOT_WRITABLE = define(
    "X847",
    "cannot-write",
    Severity.ERROR,
    "a result file that cannot be written",
    """
Its folder does not exist and cannot be made, or may not be written; or its name is that of a folder, or has
another ending than the file is of: a recording ends in `.npz`. Or it is the file that is read: estimates, for
instance, do not replace what they are made from. Nothing was changed: result files are replaced in one step,
so an older report or recording is still whole.
""",
    Category.USAGE,
)

NO_EXAMPLE = define(
    "X848",
    "no-such-example",
    Severity.ERROR,
    "an example that does not come with ropsim",
    "`ropsim examples` lists the examples; `ropsim new DIR --example NAME` makes a project from one.",
    Category.USAGE,
)

PLACE_TAKEN = define(
    "X849",
    "place-taken",
    Severity.ERROR,
    "a new project cannot be made there",
    """
`ropsim new` makes a folder that is not there yet, or fills an empty one. It never changes files that exist:
choose another name, or remove the folder yourself.
""",
    Category.USAGE,
)

MOVES_SKIPPED = define(
    "X895",
    "moves-skipped",
    Severity.ERROR,
    "a run left out moves",
    """
`project.simulate(strict=True)` raises where the recording is not `ok`, with the first error of the run. This
code stands for a run that has no error and skipped moves all the same, as with a path planner of your own
that refuses a move with warnings only.
""",
)

UNKNOWN_ROBOT_FORMAT = define(
    "X911",
    "unknown-robot-format",
    Severity.ERROR,
    "a file of a robot has an ending that no reader knows",
    """
How a robot file is read depends on the ending of its name. The message lists the endings that are known;
`docs/reference/robot-file.md` describes files that end with `.toml`, `docs/reference/exchange-formats.md`
those of other systems: URDF (`.urdf`, `.xacro`) and MJCF (`.xml`); `docs/reference/nirox.md` those that end
with `.stp`.
""",
    Category.USAGE,
)

NOT_IN_SESSION = define(
    "X912",
    "not-in-a-session",
    Severity.ERROR,
    "a line that a session of commands cannot take now",
    """
The commands of a session, of `ropsim repl` or of the command line of the studio, make one run, which goes on
with every command. `program`, `units`, `classic` and
`strict` say how a whole text is read, so they stand in the program of the project, with which a session
begins. Behind `stop` nothing follows. Where texts of the project are changed so that the commands can no
longer be carried out, `restart` forgets them.

`save NAME` writes a program that does what the session did: NAME is letters, digits and `_`, and nothing else
has it, neither a word of the language nor a task of the program.
""",
)

REQUEST_UNUSED = define(
    "X922",
    "robot-request-unused",
    Severity.ERROR,
    "a tip, package or argument for a robot that takes none, or not that one",
    """
`--tip`, `--package` and `--arg`, and the keys `tip`, `package` and `arg` of a cell file, are for robots in
URDF, xacro and MJCF: such a file does not say which link carries the tool, names other packages, or has
arguments. Built-in robots, NIROX (`.stp`) and robot files (`.toml`) name their mechanical interface and need
no other file. A package is given under the name by which the robot file asks for it, as
`package://NAME/meshes/a.stl` or `$(find NAME)`; one that no file asks for is misspelt.
""",
    Category.USAGE,
)
