"""What the web process asks of its workers and what they answer: records that travel by pickle.

What a page says and a worker is told in the same words is one record of `msgspec`: it comes as JSON and
goes on by pickle.

`folder` is the absolute path of a project. Texts are named by their path inside the project with `/`, such as
`programs/main.task`: in the `texts` of jobs, and as the source of every span in findings, events and packs.
"""

from collections.abc import Mapping
from dataclasses import field
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
"""How much something matters that the user is told."""

PoseNumbers: TypeAlias = tuple[float, float, float, float, float, float, float]
"""Position x, y, z [m] and unit quaternion w, x, y, z; in W unless told otherwise."""


@frozen_dataclass
class InputChange:
    """A change of an input that a key made: from `time` [s of simulated time] on, `signal` has `value`."""

    signal: str
    time: float
    value: float


# ---- jobs: each is answered by exactly one final reply, before it any number of messages -----------------


@frozen_dataclass
class OpenScene:
    """Read the project and tell how its cell looks (`SceneReply`); jogs that follow are for this cell.

    `texts` maps names inside the project, such as `programs/main.task`, to unsaved texts that count instead
    of the files.
    """

    folder: str
    texts: Mapping[str, str]


Cause: TypeAlias = Literal["asked", "text", "text_beside_live"]
"""Why a run is wanted: the user asks, a text has changed, or one has changed while a live run was under way.

A text that has changed beside a live run is not simulated: the live run stays the result, on the lines of the
text where that still says the same. Nor is it later, until it says something else.
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

    Orders may only be to give it up.
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
    """A task as it is typed.

    Attributes:
        name: of the task.
        points: what is typed for each location; blank for none.
        values: what is typed for each other parameter, with its unit; blank for none.
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
    """Tell the form of a task (`TasksReply`)."""

    folder: str
    texts: Mapping[str, str]
    task: str


@frozen_dataclass
class CheckTaskForm:
    """Tell what is said of a form, and the text with it (`TasksReply`); `id` comes back.

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
    """Tell what tasks and places there are (`TasksReply`)."""

    folder: str
    texts: Mapping[str, str]


@frozen_dataclass
class CheckTasks:
    """Tell what is said of steps (`TasksReply`); `id` comes back."""

    folder: str
    texts: Mapping[str, str]
    id: int
    steps: TaskSteps


@frozen_dataclass
class EstimateTasks:
    """Plan a program that is in no file and tell how long it takes (`TasksReply`); `id` comes back."""

    folder: str
    texts: Mapping[str, str]
    id: int
    program: str


@frozen_dataclass
class Tell:
    """Let the simulated robot carry out a line behind commands that it was told before (`ToldReply`).

    An empty line asks where it stands.
    """

    folder: str
    texts: Mapping[str, str]
    commands: tuple[str, ...]
    line: str


@frozen_dataclass
class OfferWords:
    """Tell what can end a line behind commands that were told before (`OfferedReply`)."""

    folder: str
    texts: Mapping[str, str]
    commands: tuple[str, ...]
    line: str


# ---- orders: they carry the number of the job that they are for and have no answer of their own ----------


@frozen_dataclass
class Cancel:
    """Give up the job of this number; its reply says `cancelled`."""


@frozen_dataclass
class Renew:
    """The texts have changed: go on if they still say the same (`Renewed`), else give the job up.

    `run` is the number under which the run goes on.
    """

    run: int
    job: Simulate


class LiveControl(Struct, frozen=True, tag_field="type", tag="live_control"):
    """Hold a live run on its path, let it go on or make one step, or end it; the recording is kept."""

    action: Literal["hold", "continue", "step", "stop"]


class LiveOverride(Struct, frozen=True, tag_field="type", tag="live_override"):
    """Share of their planned speed at which the motions of the live run are followed, 0 to 1."""

    value: Share


class LiveSpeed(Struct, frozen=True, tag_field="type", tag="live_speed"):
    """Simulated seconds per second of the live run."""

    speed: float


class SetSignal(Struct, frozen=True, tag_field="type", tag="signal"):
    """Set an input of the cell in a live run; the simulator stamps it with simulated time."""

    name: Name
    value: float


@frozen_dataclass
class Stop:
    """End the worker process (number 0); a running job is given up."""


TasksJob: TypeAlias = ListTasks | CheckTasks | EstimateTasks | OpenTaskForm | CheckTaskForm
LineJob: TypeAlias = Tell | OfferWords
RunJob: TypeAlias = Simulate | LiveStart | SaveRun | LookAtWays
Job: TypeAlias = OpenScene | RunJob | JogJoints | JogTcp | TasksJob | LineJob
LiveOrder: TypeAlias = LiveControl | LiveOverride | LiveSpeed | SetSignal
Order: TypeAlias = Cancel | Renew | LiveOrder | Stop


# ---- answers ---------------------------------------------------------------------------------------------


@frozen_dataclass
class Progress:
    """How far a simulation has come, in words."""

    text: str


@frozen_dataclass
class Planned:
    """What compiling and planning have found, while the drives are still being simulated."""

    findings: tuple[Mapping[str, object], ...]


@frozen_dataclass
class Renewed:
    """The run goes on for newer texts of the same content, under another number."""

    run: int


@frozen_dataclass
class LiveMessage:
    """A message of a live run, as the page gets it: `live`, `layout`, `placed`, `stamped` or `happened`."""

    payload: Mapping[str, object]


@frozen_dataclass
class LiveFrame:
    """A state frame of a live run, as the page gets it."""

    content: bytes


@frozen_dataclass
class SceneReply:
    """The cell as plain JSON values, None while it is broken; findings likewise; GLB files by address."""

    scene: Mapping[str, object] | None
    findings: tuple[Mapping[str, object], ...]
    meshes: Mapping[str, bytes]


@frozen_dataclass
class RunReply:
    """The end of a run.

    `done`: `pack` is the finished run for the page. `refused`: the program has errors, they are in
    `findings`. `failed`: `message` says in words why there is no run. `inputs` are those that a live run
    was given and has used. `made`: whether it was simulated, is the run before on other lines, or whether
    nothing was made, as the live run before stays the result beside texts that say something else. `ways`:
    whether its ways have been looked at. `results`: what those of the lines of its programs hang on, by
    document.
    """

    state: Literal["done", "refused", "cancelled", "failed"]
    program: str
    message: str = ""
    pack: bytes | None = None
    findings: tuple[Mapping[str, object], ...] = ()
    inputs: tuple[InputChange, ...] = ()
    made: Literal["simulated", "kept", "nothing"] = "simulated"
    ways: bool = False
    results: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


@frozen_dataclass
class SavedRun:
    """A finished run as a file."""

    content: bytes


@frozen_dataclass
class WaysReply:
    """The collisions of a run.

    Attributes:
        findings: all of the run, as its pack has them.
        result: its figures, as its pack has them.
        ways: its contacts, as the facts of its pack have them; None for a cell in which nothing can collide.
    """

    findings: tuple[Mapping[str, object], ...]
    result: Mapping[str, object]
    ways: Mapping[str, object] | None = None


@frozen_dataclass
class JogReply:
    """Where the arm of a station stands now, and what limits, reach and singularity have to say, worst first.

    `q` is that of the request where the target cannot be reached. `bodies` are pairs of a body's index in
    the scene and its pose in W, `words` pairs of a level (`error`, `warning`, `info`) and a text.
    `location` is the pose of the TCP as the task language writes it, `typed` the same as a point of a task is
    typed, X Y Z Pitch Roll Yaw [mm, deg]; both are empty where there is no arm.
    """

    q: tuple[float, ...]
    tcp: PoseNumbers
    bodies: tuple[tuple[int, PoseNumbers], ...]
    reached: bool
    words: tuple[tuple[Level, str], ...]
    location: str = ""
    typed: str = ""


@frozen_dataclass
class TasksReply:
    """A message about tasks, as the page gets it: `task_list`, `tasks_checked` or `tasks_estimated`."""

    payload: Mapping[str, object]


LineOutcome: TypeAlias = Literal["open", "moved", "answered", "refused", "over"]
"""What became of a line.

`open`: more lines must follow. `moved`: the robot has done something or is taken back. `answered`: something
was told. `refused`: nothing was done. `over`: it ends what is said.
"""


@frozen_dataclass
class ToldReply:
    """What is answered to a line.

    Attributes:
        commands: that were told, this one included where it was carried out.
        outcome: what became of it.
        told: lines that are answered.
        findings: about it; the text `session` in their spans are the commands.
        first: line of that text in which it begins.
        pack: the run of all commands; None where it is as before.
        since: when the motion of this command begins in that run [s].
        program: name and text of a program that is to be written; None for none.
    """

    commands: tuple[str, ...]
    outcome: LineOutcome
    told: tuple[str, ...] = ()
    findings: tuple[Mapping[str, object], ...] = ()
    first: int = 1
    pack: bytes | None = None
    since: float = 0.0
    program: tuple[str, str] | None = None


@frozen_dataclass
class OfferedReply:
    """The words that can end a line, and how far the word at its end has been typed."""

    begun: str
    words: tuple[str, ...]


@frozen_dataclass
class Failed:
    """A job other than a run could not be done; the reason in words."""

    message: str


LineReply: TypeAlias = ToldReply | OfferedReply
Reply: TypeAlias = SceneReply | RunReply | SavedRun | WaysReply | JogReply | TasksReply | LineReply | Failed

Report: TypeAlias = Progress | Planned | Renewed | LiveMessage | LiveFrame


# ---- envelopes: what goes through the pipe ---------------------------------------------------------------


@frozen_dataclass
class Request:
    """To the worker: a job with its number, or an order for the job of that number."""

    number: int
    content: Job | Order


@frozen_dataclass
class Answer:
    """From the worker: a report on the job of that number or its final reply."""

    number: int
    content: Report | Reply
