"""The compiled slice of a servo, and the arrays that its calls share."""

from dataclasses import dataclass

import numpy as np

from ropsim.codegen import Compiled, Engine, SourceFunction, bound, load
from ropsim.controller import CompiledLaw, PythonLaw, failed, rehearse
from ropsim.dynamics import identifier
from ropsim.model import Payload, Rates, RobotModel
from ropsim.simulation.servo.judged import limit_values
from ropsim.simulation.servo.source import frame_rows
from ropsim.simulation.servo.state import StateLayout
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True, eq=False)
class Bench:
    """Arrays shared by the calls of a slice; their contents do not persist between calls.

    Attributes:
        values: the state vector while it is worked on.
        parameters: of the law, and below them its model and the sensors.
        slice: the compiled slice with room to work in, parameters of the law and rates.
        slices: the same for a payload.
        width: numbers in a row of the log.
    """

    values: Array
    parameters: Array
    width: int
    slice: Compiled
    slices: dict[Payload, Compiled]

    @classmethod
    def of(
        cls,
        kernel: Compiled,
        law: CompiledLaw,
        sensors: Array,
        layout: StateLayout,
        rates: Rates,
        robot: RobotModel,
    ) -> "Bench":
        """Return the arrays for a compiled slice.

        Args:
            kernel: the slice.
            law: that it carries out.
            sensors: rows of their numbers.
            layout: of the state vector.
            rates: with the integration steps of the arm.
            robot: the arm.
        """
        values, model = np.zeros(layout.size), law.model.rows if law.model else sensors[:0]
        parameters = np.vstack((law.parameters, model, sensors))
        state = (values, layout.in_force(values), layout.waiting(values), layout.remembered(values))
        ends, full = np.array([robot.lower_limits, robot.upper_limits]), limit_values(robot)
        width = len(full) // 2
        room = (np.zeros((frame_rows(law), layout.n)), np.zeros((5, layout.integrated)), np.zeros(width))
        given = (*state, parameters, *room, ends, full, rates.plant_steps, 1.0 / rates.control_hz)
        made = bound(kernel, *given)
        return cls(values, parameters, width, made, {})


def compiled_slice(
    robot: RobotModel,
    law: CompiledLaw,
    functions: tuple[SourceFunction, ...],
    engine: Engine,
    own: CompiledLaw | PythonLaw | None,
) -> Compiled:
    """Return the compiled slice.

    Args:
        robot: the arm.
        law: the compiled law.
        functions: source of the slice.
        engine: who runs it.
        own: law of a user, which is tried first; None for a law of ours.

    Raises:
        LawError: the law of a user does not work.
    """
    name = f"{identifier(robot.name)}_servo_{law.name}"
    if not isinstance(own, CompiledLaw):
        return load(name, functions, engine)
    rehearse(law, robot.n)
    try:
        return load(name, functions, engine)
    except Exception as error:  # numba has a family of errors for code that it cannot compile
        raise failed(law, error) from error
