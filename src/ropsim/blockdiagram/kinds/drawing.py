"""A diagram while it is drawn: signals of an arm, and blocks that are put behind each other."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.blockdiagram import blocks as b
from ropsim.blockdiagram.checks.check import check_diagram
from ropsim.blockdiagram.diagnostics import WRONG_SIZE, DiagramError
from ropsim.blockdiagram.diagram import Diagram, Link, OutputKind
from ropsim.blockdiagram.signals import SLIDING, TURNING, Role, Signal, Unit
from ropsim.core import frozen_dataclass
from ropsim.model import JointType

Given = npt.ArrayLike
"""A number for all axes, or one for each."""
_NAMES = {
    Role.REFERENCE_COORDINATE: "q_ref",
    Role.REFERENCE_SPEED: "qd_ref",
    Role.REFERENCE_ACCELERATION: "qdd_ref",
    Role.COORDINATE: "q",
    Role.SPEED: "qd",
    Role.EFFORT: "tau",
}
OUTPUT_UNITS = {OutputKind.VOLTAGE: Unit.VOLT, OutputKind.VALVE_CURRENT: Unit.AMPERE}


@frozen_dataclass
class Axes:
    """The axes that a controller is for.

    Attributes:
        measures: which of them turn and which slide.
        period: control period [s].
        output_kind: the input of the drives; with `drive_input` efforts become it by the model of the drives.
    """

    measures: tuple[JointType, ...]
    period: float
    output_kind: OutputKind = OutputKind.DRIVE_INPUT

    @property
    def n(self) -> int:
        """Return their number."""
        return len(self.measures)

    def units(self, role: Role) -> tuple[Unit, ...]:
        """Return the units of a quantity of the axes."""
        if role is Role.OUTPUT or role not in TURNING:
            return (OUTPUT_UNITS.get(self.output_kind, Unit.OTHER),)
        return tuple((TURNING if one is JointType.REVOLUTE else SLIDING)[role] for one in self.measures)

    @property
    def efforts(self) -> tuple[Unit, ...]:
        """Return the units of efforts."""
        return self.units(Role.EFFORT)


def rows_of(matrix: npt.ArrayLike) -> b.Matrix:
    """Return a matrix as its rows."""
    return tuple(tuple(row) for row in np.atleast_2d(np.asarray(matrix, np.float64)).tolist())


class Drawing:
    """A diagram while it is drawn.

    Args:
        name: of the controller.
        axes: that it is for.
    """

    def __init__(self, name: str, axes: Axes) -> None:
        self.axes = axes
        self._name = name
        self._signals: dict[str, Signal] = {}
        self._blocks: list[b.Block] = []
        self._links: list[Link] = []

    def signal(self, role: Role, channel: str = "", units: Sequence[Unit] = ()) -> str:
        """Return the name of a signal from outside, which is made when it is needed first."""
        name = _NAMES.get(role, channel)
        self._signals.setdefault(
            name, Signal(name, self.axes.n, tuple(units) or self.axes.units(role), role, channel)
        )
        return name

    def inner(self, name: str, units: Sequence[Unit]) -> str:
        """Make an inner signal with an element for each axis and return its name."""
        self._signals[name] = Signal(name, self.axes.n, tuple(units))
        return name

    def add(self, block: b.Block) -> str:
        """Add a block and return the name of its output."""
        self._blocks.append(block)
        return block.output

    def link(self, link: Link) -> None:
        """Add a link."""
        self._links.append(link)

    def gain(self, name: str, factors: Given, signal: str, units: Sequence[Unit]) -> str:
        """Add a gain with an output of its own."""
        return self.add(b.Gain(name, (signal,), self.inner(f"{name}_out", units), self.each(name, factors)))

    def sum(self, name: str, signals: Sequence[str], signs: Sequence[int], units: Sequence[Unit]) -> str:
        """Add a sum with an output of its own."""
        return self.add(b.Sum(name, tuple(signals), self.inner(f"{name}_out", units), tuple(signs)))

    def difference(self, name: str, reference: Role, measured: Role) -> str:
        """Add the difference of a reference and a measurement."""
        pair = self.signal(reference), self.signal(measured)
        return self.sum(name, pair, (1, -1), self.axes.units(measured))

    def each(self, name: str, values: Given) -> tuple[float, ...]:
        """Return a number for each axis.

        Raises:
            DiagramError: C621, there are more or fewer.
        """
        found = np.asarray(values, np.float64)
        if found.shape not in ((), (self.axes.n,)):
            allowed = f"a number, or one for each of {self.axes.n} axes"
            message = f"`{name}` has shape {found.shape}; allowed is {allowed}"
            raise DiagramError(WRONG_SIZE.at(None, message))
        return tuple(np.broadcast_to(found, (self.axes.n,)).tolist())

    def matrix(self, name: str, values: Given) -> b.Matrix:
        """Return a matrix with a row and a column for each axis.

        Raises:
            DiagramError: C621, it has another shape.
        """
        found = np.asarray(values, np.float64)
        if found.shape != (self.axes.n, self.axes.n):
            message = f"`{name}` has shape {found.shape}; allowed is {(self.axes.n, self.axes.n)}"
            raise DiagramError(WRONG_SIZE.at(None, message))
        return rows_of(found)

    def output(self) -> str:
        """Return the name of the output."""
        return self.signal_of(Signal("u", self.axes.n, self.axes.units(Role.OUTPUT), Role.OUTPUT))

    def signal_of(self, signal: Signal) -> str:
        """Add a given signal and return its name."""
        self._signals[signal.name] = signal
        return signal.name

    def put_out(self, effort: str) -> None:
        """Let efforts be the output, as inputs of the drives at their speeds."""
        if self.axes.output_kind is OutputKind.EFFORT:
            signal = Signal("u", self.axes.n, self.axes.efforts, Role.OUTPUT)
            self.add(b.Gain("efforts", (effort,), self.signal_of(signal), (1.0,)))
        else:
            self.add(b.DriveCommand("drives", (effort, self.signal(Role.SPEED)), self.output()))

    def done(self, holding: str = "", description: str = "") -> Diagram:
        """Return the diagram, checked.

        Raises:
            DiagramError: C621 to C625, numbers that were given cannot be.
        """
        made = Diagram(
            name=self._name,
            period=self.axes.period,
            signals=tuple(self._signals.values()),
            blocks=tuple(self._blocks),
            output_kind=self.axes.output_kind,
            links=tuple(self._links),
            holding=holding,
            description=description,
        )
        check_diagram(made)
        return made
