"""Messages of a page to the server over `/ws/studio`: JSON texts, distinguished by `type`.

`frontend/src/wire/commands.ts` is written from these records by `tools/wire_types.py`.
"""

from typing import Annotated, TypeAlias

import msgspec
from msgspec import Meta, Struct

from ropsim.studio.wire import jobs
from ropsim.studio.wire.jobs import Fidelity, Name
from ropsim.studio.wire.orders import LiveControl, LiveOverride, LiveSpeed, SetSignal

Place: TypeAlias = Annotated[str, Meta(min_length=1, max_length=4000)]
"""A path that the user has typed."""
Typed: TypeAlias = Annotated[str, Meta(max_length=20_000)]
"""Text typed on a command line."""
Number: TypeAlias = Annotated[int, Meta(ge=0, le=2**53 - 1)]
"""Whole numbers of a page; larger ones are not exact there."""

Base: TypeAlias = Annotated[str, Meta(max_length=64)]
"""SHA-256 of the content of a file in hexadecimal digits, empty for no file."""


class Hello(Struct, frozen=True, tag_field="type", tag="hello"):
    """First message of a connection; `tab` is a random name that lives as long as the tab."""

    tab: Name


class Edit(Struct, frozen=True, tag_field="type", tag="edit"):
    """New text of a document; the server journals it, then compiles and simulates in the background.

    Attributes:
        document: its name.
        text: all of it.
        version: counts up in the tab; comes back in `documents`.
        base: that of the state on which the text was written; without it, that which the server has.
    """

    document: Name
    text: str
    version: Number
    base: Base | None = None


class Save(Struct, frozen=True, tag_field="type", tag="save"):
    """Write a document to its file; `overwrite` also over a file that has changed since it was read."""

    document: Name
    overwrite: bool


class Revert(Struct, frozen=True, tag_field="type", tag="revert"):
    """Discard unsaved text and read the file again."""

    document: Name


class Create(Struct, frozen=True, tag_field="type", tag="create"):
    """Make a new `programs/NAME.task`, `.icr` or `kb/NAME.pl` with a text; never over one that is there.

    Attributes:
        document: its name.
        text: its content.
        points: of the program, written to `points/NAME.csv`, unless another list is there; empty for none.
    """

    document: Name
    text: str
    points: str = ""


class KeepPoints(Struct, frozen=True, tag_field="type", tag="keep_points"):
    """Write `points/NAME.csv` of a program, over an existing list, as requested.

    Attributes:
        program: `programs/NAME.task`.
        points: the text of the list.
    """

    program: Name
    points: str


class OpenProject(Struct, frozen=True, tag_field="type", tag="open_project"):
    """Open another project in place of this one; relative paths begin at the parent folder of this one."""

    path: Place


class ListFolders(Struct, frozen=True, tag_field="type", tag="list_folders"):
    """List the folders in a place; empty for where projects are."""

    path: Annotated[str, Meta(max_length=4000)]


class NewProject(Struct, frozen=True, tag_field="type", tag="new_project"):
    """Make a project in a new folder, from an example or for a built-in robot, and open it.

    Attributes:
        path: of the folder.
        example: from which it is made.
        robot: for which it is made; empty for a project from the example.
    """

    path: Place
    example: Name
    robot: Name = ""


class ListRobots(Struct, frozen=True, tag_field="type", tag="list_robots"):
    """List the robots for which a project can be made."""


class TakeOver(Struct, frozen=True, tag_field="type", tag="take_over"):
    """Take the right to edit from another tab."""


class RunNow(Struct, frozen=True, tag_field="type", tag="run"):
    """Simulate now. Empty program: the cell's."""

    program: Name
    fidelity: Fidelity


class CancelRun(Struct, frozen=True, tag_field="type", tag="cancel"):
    """Cancel the simulation that is running."""


class LiveStart(Struct, frozen=True, tag_field="type", tag="live_start"):
    """Start a run in real time whose inputs come from keys; it may be held at its start."""

    program: Name
    speed: float
    begin: jobs.LiveBegin = "running"


class ForgetInputs(Struct, frozen=True, tag_field="type", tag="forget_inputs"):
    """Forget recorded key presses: the next runs take the cell's own signal changes only."""


class JogJoints(jobs.JogJoints, frozen=True, tag_field="type", tag="jog_joints"):
    """Put the arm of a station at joint coordinates `q` [rad | m]; `id` comes back in `jogged`."""

    id: Number


class JogTcp(jobs.JogTcp, frozen=True, tag_field="type", tag="jog_tcp"):
    """Move the TCP of the arm of a station, standing at `q`, to a pose in W; `id` comes back in `jogged`."""

    id: Number


class OpenTasks(Struct, frozen=True, tag_field="type", tag="open_tasks"):
    """Request tasks and places; answered by `task_list`."""


class CheckTasks(Struct, frozen=True, tag_field="type", tag="check_tasks"):
    """Request the states of steps; answered by `tasks_checked`, then possibly by `tasks_estimated`.

    Attributes:
        id: comes back in the answers.
        steps: all of them, in their order.
    """

    id: Number
    steps: jobs.TaskSteps


class OpenTaskForm(Struct, frozen=True, tag_field="type", tag="open_task_form"):
    """Request the form of a task; answered by `task_form`."""

    task: Name


class CheckTaskForm(Struct, frozen=True, tag_field="type", tag="check_task_form"):
    """Request the findings on a form; answered by `task_form_checked`.

    Attributes:
        id: comes back.
        document: the text into which it is to be written, `kb/NAME.pl`.
        task: name of the task there that is changed; empty for a new one.
        form: its fields.
    """

    id: Number
    document: Name
    task: Annotated[str, Meta(max_length=500)]
    form: jobs.TaskFormFields


class OpenCommandLine(Struct, frozen=True, tag_field="type", tag="open_command_line"):
    """Request the dialogue of the command line so far; answered by `command_line`."""


class TellRobot(Struct, frozen=True, tag_field="type", tag="tell_robot"):
    """Let the robot of the command line carry out a line; answered by `line_answered`.

    Attributes:
        id: comes back in the answer.
        line: a statement, of several lines where it is a block, or a word to the command line.
    """

    id: Number
    line: Typed


class CompleteLine(Struct, frozen=True, tag_field="type", tag="complete_line"):
    """Request completions of a line of the command line; answered by `words_offered`.

    Attributes:
        id: comes back in the answer.
        line: up to the place where one types.
    """

    id: Number
    line: Typed


class GiveUpLine(Struct, frozen=True, tag_field="type", tag="give_up_line"):
    """Cancel the line that the robot of the command line executes; the robot is unchanged."""


class Trust(Struct, frozen=True, tag_field="type", tag="trust"):
    """Let code inside the project folder run, or no more."""

    trusted: bool


Command: TypeAlias = (
    Hello
    | Edit
    | Save
    | Revert
    | Create
    | KeepPoints
    | OpenProject
    | ListFolders
    | NewProject
    | ListRobots
    | TakeOver
    | RunNow
    | CancelRun
    | LiveStart
    | LiveControl
    | LiveOverride
    | LiveSpeed
    | SetSignal
    | ForgetInputs
    | JogJoints
    | JogTcp
    | OpenTasks
    | CheckTasks
    | OpenTaskForm
    | CheckTaskForm
    | OpenCommandLine
    | TellRobot
    | CompleteLine
    | GiveUpLine
    | Trust
)

_DECODER = msgspec.json.Decoder(Command)


def read_command(text: str | bytes) -> tuple[Command | None, str]:
    """Return the command in a JSON text, or None and the error in words."""
    try:
        return _DECODER.decode(text), ""
    except (msgspec.MsgspecError, UnicodeError, RecursionError) as error:
        return None, str(error)
