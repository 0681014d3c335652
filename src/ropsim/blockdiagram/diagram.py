"""A controller as a diagram of blocks: the neutral form of a joint controller."""

from enum import StrEnum

from ropsim.blockdiagram.blocks import Block
from ropsim.blockdiagram.signals import Role, Signal
from ropsim.core import frozen_dataclass
from ropsim.model import InputKind


class OutputKind(StrEnum):
    """Kind of the output of a controller; `drive_input` is the own kind of each drive."""

    VOLTAGE = "voltage"
    EFFORT = "effort"
    VALVE_CURRENT = "valve_current"
    DRIVE_INPUT = "drive_input"


INPUT_KINDS = {
    OutputKind.VOLTAGE: InputKind.VOLTAGE,
    OutputKind.EFFORT: InputKind.EFFORT,
    OutputKind.VALVE_CURRENT: InputKind.CURRENT,
    OutputKind.DRIVE_INPUT: None,
}
"""Inputs of the amplifiers that outputs are for; None for each drive's own."""


@frozen_dataclass
class Link:
    """Elements of a signal that are elements of another one.

    Attributes:
        source: name of the signal that they come from.
        source_first: number of the first of them there, from 0.
        target: name of the signal that they are set in.
        target_first: number of the first of them there, from 0.
        count: number of elements.
    """

    source: str
    source_first: int
    target: str
    target_first: int
    count: int


@frozen_dataclass
class Diagram:
    """A joint controller as blocks and signals.

    Attributes:
        name: of the controller.
        description: where it comes from, for readers.
        arm: name of the robot model that it is made for; empty for any of the same axes.
        period: control period [s], the sample time of all blocks.
        output_kind: of its output.
        delay: control ticks between a measurement and the moment when the output made of it acts.
        signals: all of them.
        blocks: all of them.
        links: connections of elements.
        holding: name of the PID block or integrator whose integral holds the arm at the start; empty without.
    """

    name: str
    period: float
    signals: tuple[Signal, ...]
    blocks: tuple[Block, ...]
    output_kind: OutputKind = OutputKind.DRIVE_INPUT
    links: tuple[Link, ...] = ()
    holding: str = ""
    delay: int = 0
    arm: str = ""
    description: str = ""

    @property
    def axes(self) -> int:
        """Return the number of axes: the size of the output; 0 without one."""
        return next((one.size for one in self.signals if one.role is Role.OUTPUT), 0)
