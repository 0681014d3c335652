"""Source of a step of the integration of a mechanism with closed chains, parted where coordinates are fast.

Coordinates of ball joints and universal joints are fast near the pose in which two of their axes are
parallel, however slow their bodies are. There a step is made of shorter ones of the classical Runge-Kutta
method.
"""

from ropsim.codegen import SourceFunction
from ropsim.dynamics.loops.plant_code import LoopState

LARGEST_TURN = 0.05
"""Most by which a coordinate of a closed chain may move in one step [rad | m]."""

MOST_PARTS = 1000
"""Most parts of a step."""


def step_code(state: LoopState) -> SourceFunction:
    """Return `loop_step(x, u, h, stages, constants)`: a step of h [s], behind which the chains are settled.

    It calls `derivative` and `settle` of `motion_code`; `stages` is room to work in, five times the
    integrated part of the state.

    Args:
        state: where coordinates and speeds stand in it.
    """
    fastest = "".join(
        f"        fastest = max(fastest, abs(k1[{place}]) / {LARGEST_TURN!r})\n" for place in state.passive
    )
    fastest += "".join(
        f"        fastest = max(fastest, math.sqrt(abs(k1[{place}]) / {LARGEST_TURN!r}))\n"
        for place in state.passive_speeds
    )
    sizes = {"size": state.stop, "fastest": fastest, "most": MOST_PARTS}
    return SourceFunction("loop_step", "void(f8[::1], f8[::1], f8, f8[:,::1], f8[::1])", _STEP % sizes)


_STEP = """\
def loop_step(x, u, h, stages, constants):
    y, k1, k2, k3, k4 = stages[0], stages[1], stages[2], stages[3], stages[4]
    left = h
    while left > 0.0:
        derivative(x, u, constants, k1)
        fastest = 1.0 / left
%(fastest)s        part = min(left, max(1.0 / fastest, h / %(most)d.0))
        if left - part < 1e-9 * h:
            part = left
        left -= part
        half = 0.5 * part
        for j in range(%(size)d):
            y[j] = x[j] + half * k1[j]
        derivative(y, u, constants, k2)
        for j in range(%(size)d):
            y[j] = x[j] + half * k2[j]
        derivative(y, u, constants, k3)
        for j in range(%(size)d):
            y[j] = x[j] + part * k3[j]
        derivative(y, u, constants, k4)
        for j in range(%(size)d):
            x[j] += part / 6.0 * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j])
        settle(x, constants)
"""
