"""What a law is given of the state of an arm: rows of true values, and values on their way from sensors."""

from dataclasses import dataclass

import numpy as np

from ropsim.controller import CompiledLaw, LawTraits, PythonLaw, compiled_half
from ropsim.model import ControllerModel
from ropsim.simulation.response.linear_plant import LinearPlant, differences
from ropsim.simulation.servo.sensing import sensing_of
from ropsim.spatial import Array


@dataclass(frozen=True, slots=True)
class SeenState:
    """What a law is given about a rest or a slow motion.

    Attributes:
        plant: the arm.
        constants: of it with its load.
        traits: of the law.
        point: the integrated state, and outputs of the amplifiers.
        late: for each row of a frame (see `Servo`) the control ticks by which it is late.
    """

    plant: LinearPlant
    constants: Array
    traits: LawTraits
    point: tuple[Array, Array]
    late: tuple[int, ...]

    def frame(self, x: Array) -> Array:
        """Return true values by rows, shape (r, n)."""
        layout = self.plant.layout
        found = np.zeros((len(self.late), layout.n))
        found[0], found[1] = x[list(layout.measured_coordinates)], x[list(layout.measured_speeds)]
        at_point, u = self.point
        self.plant.efforts(np.concatenate((x, at_point[len(x) :])), u, self.constants, found[2])
        for row, places in enumerate(layout.sensed(self.traits.sensed), start=4):
            found[row] = [0.0 if one is None else x[one] for one in places]
        return found

    def with_delays(self, F: Array, G: Array, x: Array) -> tuple[Array, Array, Array]:
        """Return the plant with values on their way from late sensors, and its state.

        In motion values on their way count as those of the moment: a law that is late sees no error by that.
        """
        n, s, late = self.plant.layout.n, len(x), sum(self.late)
        if not late:
            return F, G, x
        whole, C = np.zeros((s + late * n, s + late * n)), differences(lambda y: self.frame(y).ravel(), x)
        whole[:s, :s], first = F, s
        values, still = [x], self.frame(x)
        for row, ticks in enumerate(self.late):
            for k in range(ticks):
                here = slice(first, first + n)
                if k == 0:
                    whole[here, :s] = C[row * n : (row + 1) * n]
                else:
                    whole[here, first - n : first] = np.eye(n)
                values.append(still[row])
                first += n
        return whole, np.vstack((G, np.zeros((late * n, n)))), np.concatenate(values)

    def given(self, x: Array) -> Array:
        """Return measured values by rows; `x` has the numbers of the plant, and values on their way."""
        first, n = self.plant.layout.driven, self.plant.layout.n
        found = self.frame(x[:first])
        for row, ticks in enumerate(self.late):
            first += ticks * n
            if ticks:
                found[row] = x[first - n : first]
        return found


def lateness(controller: ControllerModel, law: CompiledLaw | PythonLaw, n: int) -> tuple[int, ...]:
    """Return for each row of a frame the control ticks by which sensors are late: delay and half a period."""
    late = [0] * (4 + len(law.traits.sensed))
    for channel in sensing_of(controller, compiled_half(law, np.zeros(n))).channels:
        late[channel.row] = channel.delay + channel.period // 2
    return tuple(late)
