"""Reports of a worker on a job, and its final reply."""

from collections.abc import Mapping
from dataclasses import field
from typing import Literal, TypeAlias

from ropsim.core import frozen_dataclass
from ropsim.studio.wire.jobs import InputChange, Level, PoseNumbers


@frozen_dataclass
class Progress:
    """How far a simulation has come, in words."""

    text: str


@frozen_dataclass
class Planned:
    """Findings of compiling and planning, while the drives are still being simulated."""

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
    """The cell as plain JSON values, None while it is broken; findings in this form; GLB files by address."""

    scene: Mapping[str, object] | None
    findings: tuple[Mapping[str, object], ...]
    meshes: Mapping[str, bytes]


@frozen_dataclass
class RunReply:
    """The end of a run.

    `done`: `pack` is the finished run for the page. `refused`: the program has errors, they are in
    `findings`. `failed`: `message` says in words why there is no run. `inputs` are the inputs that a live run
    has used. `made`: whether it was simulated, is the run before on other lines, or whether nothing was made,
    as the live run before stays the result of changed texts. `ways`: whether its collision check is done.
    `results`: keys of the lines of its programs, by document.
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
    """Present position of the arm of a station, and words on limits, reach and singularity, worst first.

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
"""Outcome of a line.

`open`: more lines must follow. `moved`: the robot has acted or an action is taken back. `answered`: the line
was answered. `refused`: nothing was done. `over`: it ends the dialogue.
"""


@frozen_dataclass
class ToldReply:
    """Answer to a line.

    Attributes:
        commands: executed so far, including this one if it was executed.
        outcome: its outcome.
        told: lines of the answer.
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


@frozen_dataclass
class Answer:
    """From the worker: a report on the job of that number or its final reply."""

    number: int
    content: Report | Reply
