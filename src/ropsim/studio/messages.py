"""What the server says to a page over `/ws/studio`; `frontend/src/wire/messages.ts` is the other side."""

from collections.abc import Mapping
from typing import Literal, TypeAlias

import msgspec
from msgspec import Struct

from ropsim.core import Diagnostic
from ropsim.studio.jobs import PoseNumbers

Finding: TypeAlias = Mapping[str, object]
"""A finding as plain JSON values; its `time` [s] is null where it has none."""


class DocumentState(Struct, frozen=True):
    """A text of the project; `text` is None where the tab has it already."""

    name: str
    uri: str
    language: Literal["task", "toml", "icr"]
    text: str | None
    version: int
    unsaved: bool
    conflict: bool
    recovered: bool


class TrustState(Struct, frozen=True):
    """Whether the project folder is trusted, and what in it is code."""

    trusted: bool
    code: tuple[str, ...]


class ExampleState(Struct, frozen=True):
    """An example from which a project can be made."""

    name: str
    summary: str


class Welcome(Struct, frozen=True, tag_field="type", tag="welcome"):
    """The project; sent on connection and when documents have come or gone."""

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
    """The cell as it is drawn, None while it is broken."""

    scene: Mapping[str, object] | None
    findings: tuple[Finding, ...]


class DocumentsChanged(Struct, frozen=True, tag_field="type", tag="documents"):
    """States of documents after an edit, save, revert or change on the disk."""

    documents: tuple[DocumentState, ...]


class EditingRight(Struct, frozen=True, tag_field="type", tag="editing"):
    """Whether the tab may edit."""

    editing: bool


class RunStatus(Struct, frozen=True, tag_field="type", tag="run"):
    """How a run stands; a `done` one has its pack at `/run/<id>.pack`.

    `findings` are those of compiling, and of planning where `planned` says so; a finished run has its own.
    `simulated` is the run that was carried out: an earlier one where the texts still say the same, 0 before
    that is known. `versions` are those of the texts, to which lines in findings and run refer.
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


class LiveStatus(Struct, frozen=True, tag_field="type", tag="live"):
    """How a live run stands."""

    state: Literal["starting", "running", "paused", "over"]
    speed: float
    program: str


class JogWords(Struct, frozen=True):
    """What limits, reach or singularity have to say."""

    level: str
    text: str


class JogBody(Struct, frozen=True):
    """World pose of a body of the jogged arm."""

    body: int
    pose: PoseNumbers


class Jogged(Struct, frozen=True, tag_field="type", tag="jogged"):
    """Answer to a jog."""

    id: int
    q: tuple[float, ...]
    tcp: PoseNumbers
    bodies: tuple[JogBody, ...]
    reached: bool
    words: tuple[JogWords, ...]


class Notice(Struct, frozen=True, tag_field="type", tag="notice"):
    """Something to tell the user."""

    level: Literal["error", "warning", "info"]
    code: str
    text: str
    hint: str


Message: TypeAlias = (
    Welcome
    | TrustChanged
    | SceneMessage
    | DocumentsChanged
    | EditingRight
    | RunStatus
    | LiveStatus
    | Jogged
    | Notice
    | Mapping[str, object]
)
"""Mappings are messages of a live run, which the simulator has put together."""


def wire(message: Message) -> bytes:
    """Return the JSON text of a message; numbers that are not finite become null.

    Names of files may hold what is no Unicode; it becomes `�`.
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
    levels: dict[str, Literal["error", "warning", "info"]] = {"error": "error", "warning": "warning"}
    level = levels.get(finding.severity.value, "info")
    return Notice(level, finding.code, finding.message, finding.hint)
