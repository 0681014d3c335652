"""Messages of the server on tasks that an operator chooses: their list, the state of each step, the time."""

from typing import TypeAlias

from msgspec import Struct

from ropsim.studio.wire.content import Finding
from ropsim.studio.wire.jobs import PoseNumbers, TaskFormFields

SixNumbers: TypeAlias = tuple[float, float, float, float, float, float]


class TaskParameter(Struct, frozen=True):
    """A parameter of a task.

    Attributes:
        name: its name.
        kind: `location`, `length`, `int` and so on.
        default: as typed; empty without one.
        units: that a value may have; empty for a plain number.
        told: whether the state of the cell determines it, instead of the operator.
        word: label for users; its name if it has none.
        sentence: remark for users, with the bounds of its value.
    """

    name: str
    kind: str
    default: str
    units: tuple[str, ...]
    told: bool
    word: str
    sentence: str


class TaskChoice(Struct, frozen=True):
    """A task that may be chosen.

    Attributes:
        name: how it is called.
        doc: purpose.
        group: file of the library that it comes from; `yours` for one of the user's own folder, empty for
            one of the project.
        needs: its preconditions, in words.
        parameters: in their order.
    """

    name: str
    doc: str
    group: str
    needs: tuple[str, ...]
    parameters: tuple[TaskParameter, ...]


class PlaceChoice(Struct, frozen=True):
    """Choice for points.

    Attributes:
        list: the list of points to which it belongs; empty for a location of the cell.
        name: of a location or of a point in the list; empty for the whole list.
        text: text typed for it.
        count: points that it stands for.
        frame: it is the origin of a frame of the cell.
    """

    list: str
    name: str
    text: str
    count: int
    frame: bool = False


class PartPlace(Struct, frozen=True):
    """Where a part lies; the place is empty if unknown."""

    part: str
    place: str


class WorldNow(Struct, frozen=True):
    """Facts at one time.

    Attributes:
        gripper: `open` or `closed`; `none` if the tool has no gripper, empty if unknown.
        held: part in the gripper; empty for none.
        parts: that lie somewhere.
        others: all else in words.
    """

    gripper: str
    held: str
    parts: tuple[PartPlace, ...]
    others: tuple[str, ...]


class TaskList(Struct, frozen=True, tag_field="type", tag="task_list"):
    """Tasks and places to choose from.

    Attributes:
        revision: counts how often cell, tasks or lists of points were others.
        tasks: tasks of the library first.
        kinds: that parameters of tasks may have.
        places: locations of the cell, then lists of points with their points.
        begin: facts before the first step.
        findings: of cell, tasks and lists.
        problem: why nothing is known of tasks; empty where it is, and then all else counts.
    """

    revision: int
    tasks: tuple[TaskChoice, ...]
    kinds: tuple[str, ...]
    places: tuple[PlaceChoice, ...]
    begin: WorldNow
    findings: tuple[Finding, ...]
    problem: str


class StepState(Struct, frozen=True):
    """State of a step.

    Attributes:
        call: the call that it is, as task text.
        accepted: whether it is possible.
        message: `accepted`, or the reason against it.
        hint: next action.
        warning: doubts about a possible step; empty for none.
        told: the parameters determined by the state, with their values.
        world: after it.
        points: places in the list of points.
    """

    call: str
    accepted: bool
    message: str
    hint: str
    warning: str
    told: tuple[PartPlace, ...]
    world: WorldNow
    points: tuple[int, ...]


class ProgramPoint(Struct, frozen=True):
    """A point of the control program.

    Attributes:
        name: in the program; empty where its step is refused.
        numbers: X Y Z [mm] Pitch Roll Yaw [deg] in the base frame; null where it has no pose.
        pose: of the tool in W; null without a point.
    """

    name: str
    numbers: SixNumbers | None
    pose: PoseNumbers | None


class TasksChecked(Struct, frozen=True, tag_field="type", tag="tasks_checked"):
    """Answer to `check_tasks`.

    Attributes:
        id: of the command.
        revision: of the choices; if it differs from that of the list, request a new list.
        steps: one for each that was sent.
        points: of all steps, each once.
        text: the program of the steps that are accepted; empty without one.
        listed: its points that are typed as numbers, as a list of points in a file; empty without one.
        problem: why there is no answer or no text; empty where there is.
        unchecked: omitted checks, as one line; empty for none.
    """

    id: int
    revision: int
    steps: tuple[StepState, ...]
    points: tuple[ProgramPoint, ...]
    text: str
    listed: str
    problem: str
    unchecked: str


class TasksEstimated(Struct, frozen=True, tag_field="type", tag="tasks_estimated"):
    """How long the program of the steps takes, planned without drives.

    Attributes:
        id: of the command that it follows.
        seconds: cycle time [s]; null where the program does not come to its end.
        message: first finding of planning; empty for none.
    """

    id: int
    seconds: float | None
    message: str


class TaskFormOpened(Struct, frozen=True, tag_field="type", tag="task_form"):
    """Answer to `open_task_form`.

    Attributes:
        task: name of the task.
        document: text of the project that has it, or that is to have it where it is of the library.
        form: its fields; null where a form cannot show it.
        problem: why not; empty where it can.
        kinds: that parameters may have.
    """

    task: str
    document: str
    form: TaskFormFields | None
    problem: str
    kinds: tuple[str, ...]


class FormFault(Struct, frozen=True):
    """Finding on a field.

    Attributes:
        field: `name`, `parameters`, or a property of the clause, such as `pre` or `body`.
        place: which of several fields, from 0; -1 where it is not known.
        severity: `error`, `warning` or `hint`.
        message: in words.
        hint: next action; empty for none.
    """

    field: str
    place: int
    severity: str
    message: str
    hint: str


class TaskFormChecked(Struct, frozen=True, tag_field="type", tag="task_form_checked"):
    """Answer to `check_task_form`.

    Attributes:
        id: of the command.
        text: the whole text of the document with the form in it; empty where the form is no clause yet.
        clause: the clause alone, as in that text.
        faults: of the fields.
    """

    id: int
    text: str
    clause: str
    faults: tuple[FormFault, ...]
