"""Messages of the server on a live run: its state, the layout of its frames, events."""

from typing import Literal

from msgspec import Struct

from ropsim.studio.wire.content import RunEvent
from ropsim.studio.wire.jobs import PoseNumbers


class LiveStatus(Struct, frozen=True, tag_field="type", tag="live"):
    """How a live run stands.

    Attributes:
        state: of the run.
        speed: simulated seconds per second.
        program: its name.
        override: share of the planned speed that is requested, 0 to 1.
    """

    state: Literal["starting", "running", "held", "over"]
    speed: float
    program: str
    override: float = 1.0


class LiveChannel(Struct, frozen=True):
    """Meaning of one number in the state frames of a live run.

    Attributes:
        name: of the channel.
        column: of the channel that it is, empty for a channel with one.
        unit: SI unit as text.
        description: description of the channel.
        group: heading in lists.
        subject: name of the station or device that it is of; empty for the cell.
        held: its value holds between changes, else it is linear.
    """

    name: str
    column: str
    unit: str
    description: str
    group: str
    subject: str
    held: bool


class LiveStation(Struct, frozen=True):
    """Program of a station of the cell.

    Attributes:
        name: of the station.
        program: name of its program; empty without one.
        source: name of the text whose lines its channel `line` counts.
    """

    name: str
    program: str
    source: str


class LiveLayout(Struct, frozen=True, tag_field="type", tag="layout"):
    """Names of the numbers in the state frames that follow.

    Attributes:
        channels: one for each number.
        bodies: indices of the scene's bodies whose poses are in the frames.
        stations: of the cell, with their programs.
    """

    channels: tuple[LiveChannel, ...]
    bodies: tuple[int, ...]
    stations: tuple[LiveStation, ...]


class Placed(Struct, frozen=True, tag_field="type", tag="placed"):
    """From a time on a body rides on another one, or is not there.

    Attributes:
        time: [s].
        body: index of the body in the scene.
        parent: index of the body that it rides on; -1 where it rests in W.
        pose: in the frame of the parent.
        visible: whether it is there.
    """

    time: float
    body: int
    parent: int
    pose: PoseNumbers
    visible: bool


class SignalStamped(Struct, frozen=True, tag_field="type", tag="stamped"):
    """An input that a key has set, with the simulated time [s] that it was given."""

    name: str
    value: float
    time: float


class Happened(Struct, frozen=True, tag_field="type", tag="happened"):
    """Something has happened in a live run.

    Attributes:
        event: as packs have it. A running task is sent repeatedly, each time longer.
    """

    event: RunEvent
