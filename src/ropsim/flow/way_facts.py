"""What a look at the ways of a run has seen: how near bodies came, and what was not looked at."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Clearance:
    """How near two bodies came at the least in a run.

    Attributes:
        one: name of a body.
        other: name of the other one.
        distance: between them [m]; negative where they were in each other.
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
    """What was seen on the ways of a run, and what was not looked at.

    Attributes:
        clearance: how near bodies came at the least, those of one robot against each other left out; null
            where nothing moved against anything.
        unseen: names of bodies of which no shape is known.
        met: pairs that were in each other at the start, or are drawn into each other.
    """

    clearance: Clearance | None = None
    unseen: tuple[str, ...] = ()
    met: tuple[BodyPair, ...] = ()
