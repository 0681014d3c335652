"""Messages of the server to a page over `/ws/studio`: JSON texts, distinguished by `type`.

Binary messages are state frames of a live run (`desk/live/frame.py`). `frontend/src/wire/messages.ts` is
written from these records by `tools/wire_types.py`.
"""

from collections.abc import Mapping
from typing import Literal, TypeAlias

import msgspec
from msgspec import Struct

from ropsim.core import Diagnostic
from ropsim.studio.wire.command_messages import CommandLineState, LineAnswered, WordsOffered
from ropsim.studio.wire.content import Finding, Result, Scene, Ways
from ropsim.studio.wire.jobs import Level, PoseNumbers
from ropsim.studio.wire.live_messages import Happened, LiveLayout, LiveStatus, Placed, SignalStamped
from ropsim.studio.wire.task_messages import (
    TaskFormChecked,
    TaskFormOpened,
    TaskList,
    TasksChecked,
    TasksEstimated,
)


class DocumentState(Struct, frozen=True):
    """A text of the project.

    Attributes:
        name: path inside the project, such as `programs/main.task` or `cell.toml`.
        uri: of the document at the language server.
        language: by the ending of its name.
        text: None where the tab has it already.
        version: the last one of the editing tab that the server has; 0 for the text of the file.
        unsaved: differs from its file.
        conflict: the file has changed on the disk since it was read.
        recovered: unsaved text of an earlier session has been brought back.
        base: names the content of the file on which the text was written; an edit returns it.
    """

    name: str
    uri: str
    language: Literal["task", "toml", "icr", "prolog"]
    text: str | None
    version: int
    unsaved: bool
    conflict: bool
    recovered: bool
    base: str


class TrustState(Struct, frozen=True):
    """Whether the project folder is trusted, and its files of code.

    Attributes:
        trusted: whether code in the project may run.
        code: files that are code and stay inert until the project is trusted.
    """

    trusted: bool
    code: tuple[str, ...]


class ExampleState(Struct, frozen=True):
    """An example from which a project can be made."""

    name: str
    summary: str


class Welcome(Struct, frozen=True, tag_field="type", tag="welcome"):
    """The project; sent on connection and when documents were added or removed.

    Attributes:
        ropsim: version of the server.
        project: name of the project.
        folder: in which it lies.
        programs: names of its programs.
        program: the one that runs when none is named.
        documents: all texts.
        editing: whether this tab may edit; one tab at a time does.
        trust: of the folder.
        recent: folders of other projects that were open last, newest first.
        examples: from which a project can be made.
    """

    ropsim: str
    project: str
    folder: str
    programs: tuple[str, ...]
    program: str
    documents: tuple[DocumentState, ...]
    editing: bool
    trust: TrustState
    recent: tuple[str, ...] = ()
    examples: tuple[ExampleState, ...] = ()


class TrustChanged(Struct, frozen=True, tag_field="type", tag="trust"):
    """The user has trusted the folder, or does no more."""

    trusted: bool
    code: tuple[str, ...]


class SceneMessage(Struct, frozen=True, tag_field="type", tag="scene"):
    """The scene of the cell; sent on connection and when the cell file changes.

    Attributes:
        scene: None while the cell is broken.
        findings: of cell file and geometry.
    """

    scene: Scene | None
    findings: tuple[Finding, ...]


class DocumentsChanged(Struct, frozen=True, tag_field="type", tag="documents"):
    """States of documents after an edit, save, revert or change on the disk; texts where new to the tab."""

    documents: tuple[DocumentState, ...]


class PointNames(Struct, frozen=True, tag_field="type", tag="points"):
    """The names of the points in the tables of the project, where it has some, and when they change."""

    names: tuple[str, ...]


class EditingRight(Struct, frozen=True, tag_field="type", tag="editing"):
    """Whether the tab may edit."""

    editing: bool


class RunStatus(Struct, frozen=True, tag_field="type", tag="run"):
    """How the newest run stands.

    `done`: its pack is at `/run/<id>.pack`. `refused`: the program has errors, the run before stays and is
    stale. `failed`: the simulator gave up; `message` says why.

    Attributes:
        id: number of the run.
        state: how it stands.
        program: its name.
        message: why there is no run.
        findings: of compiling, and also of planning if `planned`; findings of a finished run are in its pack.
        inputs: number of key presses that the run took as inputs.
        planned: whether planning has come to its end.
        simulated: the run that was carried out: an earlier one where the texts still say the same; 0 while
            not known.
        versions: of the documents to which lines in findings and run refer.
        age: `older` where the text has changed while the run went on live: it stays the result.
        results: keys of the lines of its programs (`ropsim.icr.line_contents`), by document, once it is done.
    """

    id: int
    state: Literal["waiting", "running", "done", "refused", "cancelled", "failed"]
    program: str
    message: str = ""
    findings: tuple[Finding, ...] = ()
    inputs: int = 0
    planned: bool = False
    simulated: int = 0
    versions: Mapping[str, int] = {}
    age: Literal["newest", "older"] = "newest"
    results: Mapping[str, tuple[str, ...]] = {}


class RunWays(Struct, frozen=True, tag_field="type", tag="ways"):
    """The collisions of a finished run, once they are checked.

    Attributes:
        run: its number.
        findings: all of the run, instead of the findings in its pack.
        result: its figures, instead of the figures in its pack.
        ways: its contacts; null for a cell in which nothing can collide.
    """

    run: int
    findings: tuple[Finding, ...]
    result: Result
    ways: Ways | None = None


class JogWords(Struct, frozen=True):
    """Words on limits, reach or singularity."""

    level: Level
    text: str


class JogBody(Struct, frozen=True):
    """World pose of a body of the jogged arm."""

    body: int
    pose: PoseNumbers


class Jogged(Struct, frozen=True, tag_field="type", tag="jogged"):
    """Answer to a jog.

    Attributes:
        id: of the jog.
        q: joint coordinates that were reached; coordinates of the request if the target cannot be reached.
        tcp: pose of the TCP in W.
        bodies: world poses of the bodies of the arm.
        reached: whether the arm stands where it was to.
        words: worst first; empty when all is well.
        location: pose of the TCP as programs write it; empty where there is none.
        typed: the same as a point of a task is typed, X Y Z Pitch Roll Yaw [mm, deg]; empty without one.
    """

    id: int
    q: tuple[float, ...]
    tcp: PoseNumbers
    bodies: tuple[JogBody, ...]
    reached: bool
    words: tuple[JogWords, ...]
    location: str = ""
    typed: str = ""


class Notice(Struct, frozen=True, tag_field="type", tag="notice"):
    """Notice for the user."""

    level: Level
    code: str
    text: str
    hint: str


class Answered(Struct, frozen=True, tag_field="type", tag="answered"):
    """Result of a dialog of the page: a new program, a new project, another project.

    Attributes:
        refusal: why it was not done; none where it was.
    """

    refusal: Notice | None


class FolderState(Struct, frozen=True):
    """A folder from which one may be chosen.

    Attributes:
        name: its last part.
        path: all of it.
        project: whether it is one of a project.
    """

    name: str
    path: str
    project: bool


class Folders(Struct, frozen=True, tag_field="type", tag="folders"):
    """The folders in a place of this machine.

    Attributes:
        place: path; empty if there is none to list.
        parent: of the place; empty if that is not to be listed.
        folders: by name.
    """

    place: str
    parent: str
    folders: tuple[FolderState, ...]


class Robots(Struct, frozen=True, tag_field="type", tag="robots"):
    """The built-in robots, for which a project can be made, by name."""

    names: tuple[str, ...]


Message: TypeAlias = (
    Welcome
    | TrustChanged
    | SceneMessage
    | DocumentsChanged
    | PointNames
    | EditingRight
    | RunStatus
    | RunWays
    | LiveStatus
    | LiveLayout
    | Placed
    | SignalStamped
    | Happened
    | Jogged
    | TaskList
    | TasksChecked
    | TasksEstimated
    | TaskFormOpened
    | TaskFormChecked
    | CommandLineState
    | LineAnswered
    | WordsOffered
    | Notice
    | Answered
    | Folders
    | Robots
    | Mapping[str, object]
)
"""Mappings are messages of a live run and of tasks, as they come from a worker: see `plain`."""


def plain(message: Struct) -> Mapping[str, object]:
    """Return a message as the plain JSON values that it is sent as."""
    values: Mapping[str, object] = msgspec.to_builtins(message)
    return values


def wire(message: Message) -> bytes:
    """Return the JSON text of a message; numbers that are not finite become null.

    Names of files may contain invalid Unicode; it becomes `�`.
    """
    try:
        return msgspec.json.encode(message)
    except UnicodeEncodeError:
        return msgspec.json.encode(_sendable(msgspec.to_builtins(message)))


def _sendable(value: object) -> object:
    match value:
        case str():
            return value.encode("utf-16", "surrogatepass").decode("utf-16", "replace")
        case dict():
            return {_sendable(key): _sendable(item) for key, item in value.items()}
        case list() | tuple():
            return [_sendable(item) for item in value]
        case _:
            return value


def notice(finding: Diagnostic) -> Notice:
    """Return a diagnostic as a notice."""
    levels: dict[str, Level] = {"error": "error", "warning": "warning"}
    level = levels.get(finding.severity.value, "info")
    return Notice(level, finding.code, finding.message, finding.hint)
