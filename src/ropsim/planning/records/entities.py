"""The entities of the generic controller as protocols; any one can be replaced.

Path planner, interpolator, inverse transform, joint interpolator and joint controller work in series, from
the move instructions to the control vectors for the actuators; the sensor interface is parallel to them
(generic controller model of ROPSIM, paper 2, Fig. 4.2). From its samples the path corrector may shift a path
between interpolator and inverse transform, while it is made. The joint controller runs inside the compiled
servo slice: see `ropsim.controller.law`.
"""

from collections.abc import Callable
from typing import Protocol

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.flow import JointReference, JointSamples, MoveInstruction, PathTracking, PoseSetpoints
from ropsim.model import Rates
from ropsim.motion import JointPath, ToolPath
from ropsim.planning.records.planned_path import PlannedPath
from ropsim.planning.records.sensed_cell import SensedCell
from ropsim.spatial import Array, Pose


@frozen_dataclass
class Refusal:
    """Why a move cannot be made."""

    diagnostics: tuple[Diagnostic, ...]


class PathPlanner(Protocol):
    """Turns a move instruction into a path from the command position reached so far."""

    def plan(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        """Return the path of a move, of the joints or of the tool.

        Args:
            move: the instruction with its modal state.
            q_start: command joint coordinates at the end of the move before [rad | m], shape (n,).
        """
        ...


class Interpolator(Protocol):
    """Samples a path of the tool, so densely that the joints are smooth between two samples."""

    def sample(self, path: ToolPath, sampling: int) -> PoseSetpoints:
        """Return the poses at equally spaced path parameters, from the start of the path to its end.

        Args:
            path: of the tool.
            sampling: 1 at first, then 2, 4, …, where the samples before were too far apart.
        """
        ...


class InverseTransform(Protocol):
    """Turns pose setpoints into joint samples on one branch (inverse kinematics)."""

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        """Return joint samples that continue `q_start` without a jump, or say where it is impossible."""
        ...


class JointInterpolator(Protocol):
    """Makes a smooth path of the joints from samples."""

    def refine(self, samples: JointSamples) -> JointPath:
        """Return a path of the samples' length that goes through them, with continuous derivatives."""
        ...


FineInterpolation = Callable[[JointReference, Array, Rates], JointReference]
"""What the joint interpolator makes of the trajectory of a motion that begins and ends at rest.

Given are its references at the control ticks 1, 2, …, the joint coordinates at its start [rad | m], of shape
(n,), and the rates; the result has as many ticks and the same end.
"""


def every_tick(reference: JointReference, q_start: Array, rates: Rates) -> JointReference:
    """Return the trajectory itself at each control tick: the standard fine interpolation."""
    del q_start, rates
    return reference


@frozen_dataclass
class Sample:
    """Sample of a sensor channel.

    Attributes:
        value: reading.
        valid: whether it may be used.
        age: time since it was taken [s].
    """

    value: bool | float
    valid: bool
    age: float


class SensorInterface(Protocol):
    """Delivers external signals to interpreter, planner, interpolator and controller."""

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        """Return the reading of `channel` at a simulated time.

        Args:
            channel: name of an input or output.
            time: [s].
            cell: the arms and their surroundings at that time.
        """
        ...


class PathCorrector(Protocol):
    """Computes the shift of a path at every interpolation tick, from a sensor reading."""

    def correct(self, measured: Sample, tracking: PathTracking, X_BT: Pose, correction: float) -> float:
        """Return the speed at which the shift along the direction of the tool is to change [m/s].

        It counts in nominal time. The controller takes it up as its limits and the joints allow.

        Args:
            measured: reading of the sensor at the beginning of the step.
            tracking: channel, value, direction and gain, as requested by the move.
            X_BT: pose of the tool on the planned path at the end of the step, in the base frame.
            correction: shift at the beginning of the step [m].
        """
        ...
