"""How true a run is, and how it is recorded."""

from collections.abc import Callable, Mapping
from dataclasses import field

from ropsim.controller import CompiledLaw, PythonLaw
from ropsim.core import frozen_dataclass
from ropsim.flow import Fidelity, InputChange, OverrideChange
from ropsim.planning import MotionChain, MotionSequence, SensorInterface
from ropsim.simulation.records.adapting import Adaptation, as_programmed
from ropsim.simulation.records.planned_sequence import Planning, planned_anew
from ropsim.simulation.records.row_log import MOST_ROWS
from ropsim.simulation.servo.kept_drives import Driving, driven_anew
from ropsim.simulation.state.watch import NobodyWatches, Watch


def unheard(station: str, order: MotionSequence) -> None:
    """Ignore planned sequences."""
    del station, order


def silent(text: str) -> None:
    """Take no notice of progress."""
    del text


@frozen_dataclass
class RunOptions:
    """Options of a run.

    Attributes:
        fidelity: servo drives and arm dynamics, or the ideal arm.
        record_hz: recorded rows per second; every row falls on a control tick, so it may be a few more.
        longest: simulated time after which a program is stopped [s].
        progress: called after every move with a text.
        ordered: called with every motion sequence before it is planned, and the name of its station.
        plan: plans a sequence; one that keeps plans takes the standard entities for granted.
        drive: lets an arm under the joint controller of its model follow a reference.
        chains: other entities between instruction and joint controller, by station; the others take the
            standard ones.
        laws: joint controllers in place of those in the cell, by station.
        sensors: delivers the channels that the program reads; None takes the signals of the cell.
        inputs: changes of inputs in addition to those in the cell, from an earlier run.
        overrides: changes of the speed override, in order of time, as an earlier run was given them.
        stopped: when the run is ended by hand, as an earlier one was [s]; None for its own end.
        longest_wait: simulated time after which a wait for a signal ends the program [s].
        most_rows: recorded rows beyond which every second one is dropped, so that memory stays bounded.
        longest_step: simulated time that a station moves on at most before others and `watch` have their turn
            [s]; None for whole moves. It does not change the result.
        adapt: maps each move of a program to the executed one; identity without changes.
        watch: observes the run, may hold it and press inputs.
    """

    fidelity: Fidelity = Fidelity.DYNAMIC
    record_hz: int = 250
    longest: float = 3600.0
    progress: Callable[[str], None] = silent
    ordered: Callable[[str, MotionSequence], None] = unheard
    plan: Planning = planned_anew
    drive: Driving = driven_anew
    chains: Mapping[str, MotionChain] = field(default_factory=dict)
    laws: Mapping[str, CompiledLaw | PythonLaw] = field(default_factory=dict)
    sensors: SensorInterface | None = None
    inputs: tuple[InputChange, ...] = ()
    overrides: tuple[OverrideChange, ...] = ()
    stopped: float | None = None
    longest_wait: float = 600.0
    most_rows: int = MOST_ROWS
    longest_step: float | None = None
    adapt: Adaptation = as_programmed
    watch: Watch = field(default_factory=NobodyWatches)

    def record_ticks(self, control_hz: int) -> int:
        """Return the control ticks between two recorded rows."""
        return max(1, control_hz // self.record_hz)
