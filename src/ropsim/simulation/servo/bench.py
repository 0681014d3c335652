"""The compiled slice of a servo, and the arrays that its calls share."""

from dataclasses import dataclass

import numpy as np

from ropsim.codegen import Compiled, Engine, bound, load
from ropsim.controller import CompiledLaw, PythonLaw, failed, rehearse
from ropsim.dynamics import identifier, structure_of
from ropsim.model import Payload, Rates, RobotModel
from ropsim.simulation.servo.judged import full_values
from ropsim.simulation.servo.sensing import Sensing
from ropsim.simulation.servo.source import frame_rows, servo_functions
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
        """Return the arrays of a servo.

        Args:
            kernel: its compiled slice.
            law: its law.
            sensors: numbers of its sensors, shape (r, n).
            layout: of its state vector.
            rates: with the stated or needed integration steps.
            robot: its arm.
        """
        values, model = np.zeros(layout.size), law.model.rows if law.model else sensors[:0]
        parameters = np.vstack((law.parameters, model, sensors))
        state = (values, layout.in_force(values), layout.waiting(values), layout.remembered(values))
        ends, full = np.array([robot.lower_limits, robot.upper_limits]), full_values(robot)
        room = (np.zeros((frame_rows(law), layout.n)), np.zeros((5, layout.integrated)), np.zeros(len(full)))
        given = (*state, parameters, *room, ends, full, rates.plant_steps, 1.0 / rates.control_hz)
        made = bound(kernel, *given)
        return cls(values, parameters, len(full), made, {})


def slice_of(
    robot: RobotModel,
    law: CompiledLaw,
    sensing: Sensing,
    engine: Engine,
    own: CompiledLaw | PythonLaw | None,
) -> Compiled:
    """Return the compiled slice of a servo.

    Args:
        robot: the arm.
        law: its law; for one in Python that which holds its output.
        sensing: the sensors between both.
        engine: who runs it.
        own: the law of a user, which is tried first; None for a built-in one.

    Raises:
        LawError: the law of the user does not work.
    """
    functions = servo_functions(structure_of(robot), law, sensing)
    name = f"{identifier(robot.name)}_servo_{law.name}"
    if not isinstance(own, CompiledLaw):
        return load(name, functions, engine)
    rehearse(law, robot.n)
    try:
        return load(name, functions, engine)
    except Exception as error:  # numba has a family of errors for code that it cannot compile
        raise failed(law, error) from error
