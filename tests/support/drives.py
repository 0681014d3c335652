"""The formulas of drives as functions of plain numbers."""

from collections.abc import Callable

import numpy as np

from ropsim.codegen import Engine, Tracer, emit, load
from ropsim.dynamics import arm_numbers, chain_of, structure_of
from ropsim.model import Drive, RobotModel
from ropsim.simulation.testing import plant_code
from ropsim.spatial import Array


def rates_of(drive: Drive) -> Callable[[Array, float, float, float], Array]:
    """Return the function of states, joint coordinate, joint speed and valve current to effort and rates.

    Args:
        drive: with four states.
    """
    chain, tracer = chain_of(drive), Tracer()
    x = tracer.variables("x", 7)
    p = [tracer.constant(value) for value in chain.numbers(drive)]
    carried = chain.trace(p, x[4], x[5], x[:4], x[6])
    results = [carried.effort, *carried.rates]
    code = load(
        "drive",
        (emit("drive", ("x", "out"), [(f"out[{i}]", one) for i, one in enumerate(results)]),),
        Engine.PYTHON,
    )

    def rates(states: Array, q: float, speed: float, current: float) -> Array:
        out = [0.0] * 5
        code([*states.tolist(), q, speed, current], out)
        return np.array(out)

    return rates


def slopes_of(robot: RobotModel) -> Callable[[Array, float], Array]:
    """Return the rates of the integrated state of a one-axis arm over state and command."""
    code = plant_code(structure_of(robot))
    (source,) = (one for one in code.functions if one.name == "derivative")
    function, constants = load("slopes", (source,), Engine.PYTHON), code.constants(arm_numbers(robot))

    def rates(x: Array, command: float) -> Array:
        dx = np.empty(len(x))
        function(x, np.array([command]), constants, dx)
        return dx

    return rates
