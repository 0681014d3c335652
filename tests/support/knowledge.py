"""Knowledge bases for tests: one Prolog for each test process, whose texts are exchanged."""

from collections.abc import Mapping
from functools import cache

from ropsim.core import SourceText
from ropsim.language import Environment
from ropsim.program import SignalUse, ValueType
from ropsim.tasks import InTheAir, KnowledgeBase, Missing, Obstruction, Overlap, Point

STANDING = (0.4, 0.0, 0.2, 0.0, 1.0, 0.0, 0.0)
"""A pose with the tool straight down [m, quaternion w x y z]."""
INPUTS = ("machine_ready", "screwed_home")
OUTPUTS = ("glue", "spindle", "chuck", "tool_lock")
CELL = Environment(
    signals={name: SignalUse(name, name in INPUTS, ValueType.BOOL) for name in (*INPUTS, *OUTPUTS)},
    locations={"s1": STANDING, "s2": STANDING},
)
"""A cell with all signals that tasks of the library name."""


class Refusing:
    """Geometry that refuses some conditions and counts what it is asked; parts are thin rods of 60 mm."""

    unchecked = ("draughts",)

    def __init__(self) -> None:
        self.revision = 0
        self.refused: set[tuple[str, ...]] = set()
        self.asked: list[tuple[str, ...]] = []

    def refuse(self, *refused: tuple[str, ...]) -> None:
        """Refuse these and nothing else, as a cell that has changed."""
        self.revision += 1
        self.refused = set(refused)
        self.asked = []

    def missing(self, robot: str, location: Point) -> Missing | None:
        """Return that a robot, or a location whose name begins with `no_`, is not there."""
        if robot != "arm":
            return Missing("robot", robot, ("arm",))
        if isinstance(location, str) and location.startswith("no_"):
            return Missing("location", location, ("s1", "s2"))
        return None

    def reachable(self, robot: str, location: Point) -> bool:
        """Return whether `(robot, location)` is not refused."""
        return self._answer((robot, str(location)))

    def obstruction(self, robot: str, part: str, location: Point) -> Obstruction | None:
        """Return that a part is in a post where `(robot, part, location)` is refused."""
        free = self._answer((robot, part, str(location)))
        return None if free else Obstruction(f"the part `{part}`", "`post`", 0.0123)

    def overlap(self, robot: str, part: str, x: float, y: float) -> Overlap | None:  # noqa: ARG002 - as the protocol has it
        """Return that rods along X lie in each other where `part` is `rod` and they are nearer."""
        return Overlap(0.06 - abs(x), 0.06) if part == "rod" and y == 0.0 and abs(x) < 0.06 else None

    def in_the_air(
        self, robot: str, part: str, location: Point, lying: Mapping[str, Point]
    ) -> InTheAir | None:
        """Return that a part at `cloud` is 12.3 mm above the table, unless another one lies at `stool`."""
        del robot, part
        is_loose = location == "cloud" and "stool" not in lying.values()
        return InTheAir("`table`", 0.0123, "parts stand on what they touch") if is_loose else None

    def prepare(self) -> None:
        """Do nothing."""

    def _answer(self, asked: tuple[str, ...]) -> bool:
        self.asked.append(asked)
        return asked not in self.refused


GEOMETRY = Refusing()


@cache
def last() -> KnowledgeBase:
    """Return the knowledge base as it is, with the texts that it was given last."""
    return KnowledgeBase((), GEOMETRY)


def base(*texts: str) -> KnowledgeBase:
    """Return the knowledge base of these texts, `kb/t0.pl` and so on, with geometry that refuses nothing."""
    GEOMETRY.refuse()
    found = last()
    found.take(SourceText(f"kb/t{index}.pl", text) for index, text in enumerate(texts))
    return found
