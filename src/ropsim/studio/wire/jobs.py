"""Requests of the web process to its workers, and their answers: records that travel by pickle.

A message that a page sends and a worker receives unchanged is one record of `msgspec`: it comes as JSON and
goes on by pickle.

`folder` is the absolute path of a project. Texts are named by their path inside the project with `/`, such as
`programs/main.task`: in the `texts` of jobs, and as the source of every span in findings, events and packs.
"""

from collections.abc import Mapping
from typing import Annotated, Literal, TypeAlias

from msgspec import Meta, Struct

from ropsim.core import frozen_dataclass

Name: TypeAlias = Annotated[str, Meta(max_length=1000)]
Coordinates: TypeAlias = Annotated[tuple[float, ...], Meta(max_length=64)]
Share: TypeAlias = Annotated[float, Meta(ge=0.0, le=1.0)]
Fidelity: TypeAlias = Literal["dynamic", "kinematic"]
RunForm: TypeAlias = Literal["recording", "inputs", "report", "code"]
"""A run as a file: NPZ, inputs as `ropsim run --inputs` takes them, HTML, text of the neutral code."""

Level: TypeAlias = Literal["error", "warning", "info"]
"""Severity of a message to the user."""

PoseNumbers: TypeAlias = tuple[float, float, float, float, float, float, float]
"""Position x, y, z [m] and unit quaternion w, x, y, z; in W unless stated otherwise."""


@frozen_dataclass
class InputChange:
    """A change of an input that a key made: from `time` [s of simulated time] on, `signal` has `value`."""

    signal: str
    time: float
    value: float


@frozen_dataclass
class OpenScene:
    """Read the project and return its scene (`SceneReply`); jogs that follow are for this cell.

    `texts` maps names inside the project, such as `programs/main.task`, to unsaved texts that count instead
    of the files.
    """

    folder: str
    texts: Mapping[str, str]


Cause: TypeAlias = Literal["asked", "text", "text_beside_live"]
"""Reason of a run: the user requests it, a text has changed, or one has changed while a live run was under
way.

A text that has changed during a live run is not simulated: the live run stays the result, on the lines of the
text if its content is unchanged. It is simulated later only after another change.
"""


@frozen_dataclass
class Simulate:
    """Compile and simulate a program (`RunReply`, before it `Progress`). Empty program: the cell's."""

    folder: str
    texts: Mapping[str, str]
    program: str
    fidelity: Fidelity
    inputs: tuple[InputChange, ...] = ()
    cause: Cause = "asked"


LiveBegin: TypeAlias = Literal["running", "held"]
"""How a live run stands at its start."""


@frozen_dataclass
class LiveStart:
    """Run a program in real time, inputs coming from `SetSignal` (live messages, at last a `RunReply`).

    It runs from its start on, or is held there until it is let go on or makes a step.
    """

    folder: str
    texts: Mapping[str, str]
    program: str
    speed: float
    begin: LiveBegin = "running"


@frozen_dataclass
class SaveRun:
    """Return the finished run of the job of this number as a file (`SavedRun`); the newest one is kept."""

    number: int
    form: RunForm


@frozen_dataclass
class LookAtWays:
    """Check the collisions of the finished run of the job of this number (`WaysReply`).

    The only order is to cancel it.
    """

    number: int


class JogJoints(Struct, frozen=True):
    """Put the arm of a station of the last opened scene at joint coordinates `q` [rad | m] (`JogReply`)."""

    station: Name
    q: Coordinates
    tool: Name


class JogTcp(Struct, frozen=True):
    """Move the TCP of a station's arm, standing at `q`, to the pose `target` in W (`JogReply`)."""

    station: Name
    q: Coordinates
    tool: Name
    target: PoseNumbers


class TaskStep(Struct, frozen=True):
    """A typed task.

    Attributes:
        name: of the task.
        points: text typed for each location; blank for none.
        values: text typed for each other parameter, with its unit; blank for none.
    """

    name: Name
    points: Annotated[tuple[Name, ...], Meta(max_length=64)]
    values: Annotated[tuple[Name, ...], Meta(max_length=64)]


TaskSteps: TypeAlias = Annotated[tuple[TaskStep, ...], Meta(max_length=200)]


Texts: TypeAlias = Annotated[tuple[Name, ...], Meta(max_length=100)]


class FormParameterFields(Struct, frozen=True):
    """The fields of a parameter in the form of a task, as `ropsim.tasks.FormParameter` has them."""

    name: Name
    kind: Name
    default: Name
    word: Name
    sentence: Name
    bounds: Texts
    called: Name


class TaskFormFields(Struct, frozen=True):
    """The fields of a form of a task, as `ropsim.tasks.TaskForm` has them."""

    name: Name
    doc: Annotated[str, Meta(max_length=4000)]
    parameters: Annotated[tuple[FormParameterFields, ...], Meta(max_length=30)]
    needs: Texts
    effects: Texts
    geometry: Texts
    body: Annotated[str, Meta(max_length=100_000)]


@frozen_dataclass
class OpenTaskForm:
    """Return the form of a task (`TasksReply`)."""

    folder: str
    texts: Mapping[str, str]
    task: str


@frozen_dataclass
class CheckTaskForm:
    """Return the findings on a form, and the text with it (`TasksReply`); `id` comes back.

    Attributes:
        document: the text into which the form is written, `kb/NAME.pl`.
        task: name of the task there that is changed; empty for a new one.
    """

    folder: str
    texts: Mapping[str, str]
    id: int
    document: str
    task: str
    form: TaskFormFields


@frozen_dataclass
class ListTasks:
    """List tasks and places (`TasksReply`)."""

    folder: str
    texts: Mapping[str, str]


@frozen_dataclass
class CheckTasks:
    """Return the states of steps (`TasksReply`); `id` comes back."""

    folder: str
    texts: Mapping[str, str]
    id: int
    steps: TaskSteps


@frozen_dataclass
class EstimateTasks:
    """Plan a program that is in no file and return its time (`TasksReply`); `id` comes back."""

    folder: str
    texts: Mapping[str, str]
    id: int
    program: str


@frozen_dataclass
class Tell:
    """Let the simulated robot execute a line behind earlier commands (`ToldReply`).

    An empty line requests its position.
    """

    folder: str
    texts: Mapping[str, str]
    commands: tuple[str, ...]
    line: str


@frozen_dataclass
class OfferWords:
    """Return completions of a line behind earlier commands (`OfferedReply`)."""

    folder: str
    texts: Mapping[str, str]
    commands: tuple[str, ...]
    line: str


TasksJob: TypeAlias = ListTasks | CheckTasks | EstimateTasks | OpenTaskForm | CheckTaskForm
LineJob: TypeAlias = Tell | OfferWords
RunJob: TypeAlias = Simulate | LiveStart | SaveRun | LookAtWays
Job: TypeAlias = OpenScene | RunJob | JogJoints | JogTcp | TasksJob | LineJob
