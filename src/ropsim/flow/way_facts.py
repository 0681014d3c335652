"""Collision facts of a run: contacts, the least distance, and omitted checks."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Clearance:
    """How near two bodies came at the least in a run.

    Attributes:
        one: name of a body.
        other: name of the other one.
        distance: between them [m]; negative: depth of a penetration; 0 where they touch.
        time: when [s].
        station: whose arm it was; empty for none.
        line: its source line then, from 1; 0 for none.
    """

    one: str
    other: str
    distance: float
    time: float
    station: str = ""
    line: int = 0


@frozen_dataclass
class Contact:
    """Two bodies that penetrate each other, or come nearer than the cell allows, without a break.

    Attributes:
        one: name of a body; the one that moves, if only one does.
        other: name of the other one.
        begin: first recorded time of it [s].
        end: last recorded time of it [s].
        distance: least distance in between [m]; negative: the depth of the penetration.
        time: when that was [s].
        place: where that was, in the world frame [m], three numbers.
        bodies: names of the two in findings, such as `jaws – pallet`; a part of a supply by the name of that.
        station: whose arm it was; empty for none.
        line: its source line at the beginning, from 1; 0 for none.
        visit: loop pass of that line, from 1; 0 where unknown.
    """

    one: str
    other: str
    begin: float
    end: float
    distance: float
    time: float
    place: tuple[float, ...]
    bodies: str = ""
    station: str = ""
    line: int = 0
    visit: int = 0


@frozen_dataclass
class BodyPair:
    """Two bodies.

    Attributes:
        one: name of a body.
        other: name of the other one.
    """

    one: str
    other: str


@frozen_dataclass
class WayFacts:
    """Contacts and the least distance of a run, and omitted checks.

    Attributes:
        clearance: least distance of the run, bodies of one robot against each other left out; null where
            nothing moved against anything.
        unseen: names of bodies without a known shape.
        met: pairs that are drawn into each other, or parts that are in something at the start.
        contacts: penetrations, in order of time.
        near: bodies that came nearer than the cell requires, in order of time.
        required: clearance that the cell requires [m]; 0 for none.
        filled: bodies of these contacts that count without their hollows: meshes, rings and cups.
        undecided: bodies so near that recorded rows do not tell whether they penetrate, in order of time;
            their distance is the depth that cannot be excluded.
    """

    clearance: Clearance | None = None
    unseen: tuple[str, ...] = ()
    met: tuple[BodyPair, ...] = ()
    contacts: tuple[Contact, ...] = ()
    near: tuple[Contact, ...] = ()
    required: float = 0.0
    filled: tuple[str, ...] = ()
    undecided: tuple[Contact, ...] = ()


def body_title(name: str) -> str:
    """Return the name of a body in findings: a tool `left/tool:jaws` is `left/jaws`."""
    station, mark, tool = name.rpartition("tool:")
    return f"{station}{tool}" if mark else name
