"""A law about a rest or a slow motion, linear, from its own code."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from ropsim.controller import (
    CompiledLaw,
    LawInput,
    LawModel,
    PythonLaw,
    compiled_half,
    in_python,
    law_arrays,
    law_model,
)
from ropsim.dynamics import barycentric
from ropsim.model import Payload, RobotModel
from ropsim.simulation.response.linear_plant import differences
from ropsim.simulation.response.steady_law import at_rest, in_motion
from ropsim.simulation.servo.held_state import remember_chains
from ropsim.spatial import Array

Called = Callable[[Mapping[str, Array]], None]
"""A law as a function of its arrays by name, `out` among them."""


@dataclass(frozen=True, slots=True)
class LinearLaw:
    """A law as a function, to be linearised at many places.

    Attributes:
        law: the law.
        called: it with a load.
        arrays: its arguments.
        senses: of the transmissions, shape (n,).
        period: control period [s].
    """

    law: CompiledLaw | PythonLaw
    called: Callable[[Payload], Called]
    arrays: dict[str, Array]
    senses: Array
    period: float

    @classmethod
    def of(cls, law: CompiledLaw | PythonLaw, robot: RobotModel, period: float) -> "LinearLaw":
        """Return a law of an arm."""
        arrays = law_arrays(compiled_half(law, np.zeros(robot.n)), robot.n)
        senses = np.array([drive.sense for drive in robot.drives])
        return cls(law, _called(law, robot), arrays, senses, period)

    def matrices(
        self,
        given: Callable[[Array], Array],
        state: tuple[Array, Array, Array],
        qd: Array,
        payload: Payload,
    ) -> tuple[Array, Array]:
        """Return how outputs and next states of the law follow from state, law and reference: two matrices.

        Args:
            given: from the state of the plant to measured values by rows; see `SeenState`.
            state: that state x, with values on their way; outputs u of the amplifiers; coordinates that
                closed chains determine.
            qd: speeds of the axes [rad/s | m/s], shape (n,), 0 at rest.
            payload: tool and part.
        """
        x, u, passive = state
        n, size, function = len(u), len(x), self.called(payload)
        arrays = self.arrays | {"load": np.array(barycentric(payload.mass, payload.com, payload.inertia))}

        def answer(found: Array, memory: Array, q_ref: Array, speeds: Array = qd) -> Array:
            out, kept = np.zeros(n), memory.reshape(-1, n).copy()
            ref = np.array([q_ref, speeds, np.zeros(n)])
            rows = {"sensed": found[4:].copy(), "state": kept, "ref": ref, "meas": found[:3].copy()}
            function({**arrays, **rows, "out": out})
            return np.concatenate((out, kept.ravel()))

        found, q = given(x), x[:n]
        held = np.zeros((len(self.law.traits.state_names), n))
        if self.law.traits.hold_row is not None:
            held[self.law.traits.hold_row] = u * self.senses
        remember_chains(self.law.traits, held, passive)
        memory, behind = held.ravel(), np.zeros(n)
        if self._comes_to_rest:
            stands, still = found.copy(), np.zeros(n)
            stands[1] = still
            memory = at_rest(lambda kept: answer(stands, kept, q, still), memory, n)
        if qd.any():
            memory, behind = in_motion(answer, (found, q), memory, (qd * self.period, u * self.senses))

        def answers(values: Array) -> Array:
            return answer(given(values[:size]), values[size:-n], values[-n:])

        J = differences(answers, np.concatenate((x, memory, q + behind)))
        return J[:n], J[n:]

    @property
    def _comes_to_rest(self) -> bool:
        """Return whether more is remembered than what an output is held by."""
        return not isinstance(self.law, CompiledLaw) or self.law.model is not None


def _called(law: CompiledLaw | PythonLaw, robot: RobotModel) -> Callable[[Payload], Called]:
    if isinstance(law, CompiledLaw):
        compiled = in_python(law)
        return lambda _: compiled
    model: LawModel = law_model(robot)

    def with_load(payload: Payload) -> Called:
        def call(arrays: Mapping[str, Array]) -> None:
            now = LawInput(
                0.0, arrays["ref"], arrays["meas"], payload, arrays["aux"], arrays["sensed"], model
            )
            arrays["out"][:] = law.step(now, arrays["state"])

        return call

    return with_load
