"""The servo loop of an arm, linear about rests and slow motions, from the code of plant and law."""

from collections.abc import Sequence
from dataclasses import dataclass

from ropsim.controller import CompiledLaw, PythonLaw, joint_law
from ropsim.model import ControllerModel, Payload, RobotModel
from ropsim.simulation.response.linear_law import LinearLaw
from ropsim.simulation.response.linear_loop import LinearLoop
from ropsim.simulation.response.linear_plant import LinearPlant
from ropsim.simulation.response.seen_state import SeenState, lateness
from ropsim.simulation.response.slow_motions import SlowMotion, rest_of
from ropsim.simulation.servo.held_state import steady_state
from ropsim.spatial import Array, frozen


@dataclass(frozen=True, slots=True)
class ServoLoop:
    """Plant and law as functions, to be linearised at many places.

    Attributes:
        plant: arm and drives.
        law: their law.
        late: for each row of measured values the control ticks by which it is late.
    """

    plant: LinearPlant
    law: LinearLaw
    late: tuple[int, ...]

    @classmethod
    def of(
        cls, robot: RobotModel, controller: ControllerModel, law: CompiledLaw | PythonLaw | None = None
    ) -> "ServoLoop":
        """Return the loop of an arm with drives, under another law than that of the controller model if any.

        Args:
            robot: with drives.
            controller: of the arm.
            law: another law than that of the controller model.
        """
        chosen = law or joint_law(controller, robot)
        return cls(
            LinearPlant.of(robot, controller.rates),
            LinearLaw.of(chosen, robot, controller.rates.control_period),
            lateness(controller, chosen, robot.n),
        )

    def about(self, q: Array, payload: Payload, motions: Sequence[SlowMotion]) -> tuple[LinearLoop, ...]:
        """Return plant and law about rests and slow motions at a place, see `linear_loop`.

        In motion a ball screw passes on η₁ of a force that lifts its load, and 1/η₂ of one that lets it down.

        Args:
            q: coordinates [rad | m], shape (n,).
            payload: tool and part; the law knows it.
            motions: rests and slow motions.
        """
        return tuple(self._about(q, payload, motion.qd) for motion in motions)

    def _about(self, q: Array, payload: Payload, qd: Array) -> LinearLoop:
        plant, law = self.plant, self.law.law
        constants = plant.constants(q, qd, payload)
        point = steady_state(plant.arm, q, qd, payload)
        seen = SeenState(plant, constants, law.traits, point, self.late)
        stands = point[0].copy()
        stands[[*range(*plant.layout.qd.indices(len(stands))), *plant.layout.measured_speeds]] = 0.0
        F, G = plant.matrices(constants, (stands, point[1]))
        F, G, x = seen.with_delays(F, G, point[0][: plant.layout.driven])
        passive = point[0][list(plant.layout.loops.passive)] if plant.layout.passive else x[:0]
        K, L = self.law.matrices(seen.given, (x, point[1], passive), qd, payload)
        return LinearLoop(frozen(F), frozen(G), frozen(K), frozen(L), plant.period, law.traits.delay)


def linear_loop(
    robot: RobotModel,
    controller: ControllerModel,
    q: Array,
    payload: Payload,
    law: CompiledLaw | PythonLaw | None = None,
) -> LinearLoop:
    """Return plant and law about a rest, without dry friction, which would damp the loop.

    Near standstill dry friction is a steep smooth curve in simulations: a loop that only this damps is not
    damped in motion. The losses of ball screws are alike: here they have none, see `ServoLoop.about` for slow
    motions. Amplifiers are away from their limits, gears on their flanks, valves beyond their overlap.
    Sensors of the controller are late by their delay and by half of their period; their steps and their noise
    have no part in it.

    Args:
        robot: with drives.
        controller: of the arm.
        q: coordinates of the rest [rad | m], shape (n,).
        payload: tool and part; the law knows it.
        law: another law than that of the controller model.
    """
    (found,) = ServoLoop.of(robot, controller, law).about(q, payload, (rest_of(robot),))
    return found
