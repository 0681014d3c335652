"""Source of the motion of drives and mechanisms with closed chains in all coordinates, for simulation.

Accelerations are those under which the cuts stay closed. After each step of the integration `settle` puts
positions and speeds back on the closed chains, by the least change in the metric of the masses, so that what
is left between the frames does not add up (E. Hairer, G. Wanner: Solving Ordinary Differential Equations II,
2nd ed., Springer 1996, section VII.2: projection).
"""

from collections.abc import Sequence

from ropsim.codegen import Formula, Scalar, SourceFunction
from ropsim.core import frozen_dataclass
from ropsim.dynamics.fastened import CutPlaces
from ropsim.dynamics.loops.solver import DEPENDENT, NOTHING
from ropsim.dynamics.loops.solver_code import solver_code
from ropsim.dynamics.traced.loop_rows import trace_drift, trace_loops
from ropsim.dynamics.traced.mass_matrix import trace_mass_matrix
from ropsim.dynamics.traced.newton_euler import trace_inverse
from ropsim.dynamics.traced.traced_arm import TracedArm

GAP = 1e-9
"""Frames that are farther apart than this have come apart [m, rad]."""

SETTLED = 1e-9
"""Residual between frames that needs no second step [m, rad]: its square remains after the first."""

LOOP_NUMBERS = 3
"""Numbers of closed chains in a state besides coordinates and speeds."""

NEAR = 0.02
"""Share of the usual volume of the watched rows below which chains are next to a dead centre."""

ROUNDS = 8
"""Most steps of Newton's method behind a step of the integration."""


@frozen_dataclass
class LoopState:
    """Where coordinates and speeds stand in the integrated part of a state.

    Attributes:
        n: number of axes, whose coordinates and speeds stand in front.
        passive: places of the coordinates that closed chains determine.
        passive_speeds: places of their speeds.
        rates: places of the states of drives.
        gap: place of the residual between the frames; behind it are `side` and `passed`.
    """

    n: int
    passive: range
    passive_speeds: range
    rates: range
    gap: int

    @property
    def side(self) -> int:
        """Return the place of the usual volume of the watched rows, with the sign of the present one.

        It is 0 where dead centres are not told.
        """
        return self.gap + 1

    @property
    def passed(self) -> int:
        """Return the place of what becomes 1.0 where that sign changes, and next to a dead centre."""
        return self.gap + 2

    @property
    def stop(self) -> int:
        """Return how many numbers the state has."""
        return self.gap + LOOP_NUMBERS

    @property
    def places(self) -> list[int]:
        """Return the place of each coordinate."""
        return [*range(self.n), *self.passive]

    @property
    def speed_places(self) -> list[int]:
        """Return the place of the speed of each coordinate."""
        return [*range(self.n, 2 * self.n), *self.passive_speeds]


def plant_formulas(
    arm: TracedArm,
    cuts: Sequence[CutPlaces],
    speeds: Sequence[Scalar],
    axes: tuple[Sequence[Scalar], Sequence[Scalar]],
    rates: Sequence[Scalar],
) -> tuple[Formula, Formula]:
    """Return `plant(x, u, constants, out)` and `stance(x, constants, out)`, which `motion_code` calls.

    `plant` enters the mass matrix (N·N), the efforts without accelerations of the coordinates (N), the slopes
    of the residuals between the frames (r·N), minus their second derivatives without accelerations (r), and
    rates of drives; `stance` the mass matrix, the slopes, and minus the residuals (r).

    Args:
        arm: the mechanism.
        cuts: of it.
        speeds: of its coordinates.
        axes: efforts of the drives, less friction, at the axes, and inertias that they add.
        rates: of states of the drives.
    """
    zero = arm.tracer.constant(0.0)
    net, inertias = axes
    rows, lower = trace_loops(arm, cuts), trace_mass_matrix(arm)
    efforts = [-one for one in trace_inverse(arm, speeds, [zero] * arm.n)]
    for k, (effort, inertia) in enumerate(zip(net, inertias, strict=True)):
        efforts[k] = efforts[k] + effort
        lower[k][k] = lower[k][k] + inertia
    mass, slopes = whole_matrix(lower), [one for row in rows.slopes for one in row]
    drift = [-one for one in trace_drift(arm, rows, speeds)]
    return (
        Formula("plant", ("x", "u", "out"), entered([*mass, *efforts, *slopes, *drift, *rates])),
        Formula("stance", ("x", "out"), entered([*mass, *slopes, *(-one for one in rows.left)])),
    )


def entered(values: Sequence[Scalar]) -> list[tuple[str, Scalar]]:
    """Return values as results of a formula that enters them one behind the other."""
    return [(f"out[{k}]", value) for k, value in enumerate(values)]


def whole_matrix(lower: Sequence[Sequence[Scalar]]) -> list[Scalar]:
    """Return a symmetric matrix by rows from its lower triangle."""
    n = len(lower)
    return [lower[max(i, j)][min(i, j)] for i in range(n) for j in range(n)]


def motion_code(state: LoopState, rows: int, watched: Sequence[int] = ()) -> tuple[SourceFunction, ...]:
    """Return `settle(x, constants)` and `derivative(x, u, constants, dx)`, with the solver before them.

    They call the functions of `plant_formulas`.

    Args:
        state: where coordinates and speeds stand in it.
        rows: number of directions that cuts hold.
        watched: of these, whose determinant tells the side of a dead centre; none where it is not told.
    """
    count = len(state.places)
    square = count * count
    moved = "".join(
        f"    dx[{place}] = x[{speed}]\n    dx[{speed}] = y[{k}]\n"
        for k, (place, speed) in enumerate(zip(state.places, state.speed_places, strict=True))
    )
    ends = square + count + rows * count + rows
    moved += "".join(f"    dx[{place}] = t[{ends + k}]\n" for k, place in enumerate(state.rates))
    sizes = {
        "N": count,
        "r": rows,
        "M": square,
        "A": square + count,
        "b": square + count + rows * count,
        "rates": ends,
        "size": ends + len(state.rates),
        "stance": square + rows * count + rows,
        "left": square + rows * count,
        "moved": moved,
        "gap": state.gap,
        "watch": _watch(state, watched) if watched else "",
        "side": state.side,
        "passed": state.passed,
        "rounds": ROUNDS,
        "settled": repr(SETTLED),
        "nothing": repr(NOTHING),
        "dependent": repr(DEPENDENT),
        "placed": _added(state.places),
        "sped": _added(state.speed_places),
        "speeds": "".join(f"        v[{k}] = x[{place}]\n" for k, place in enumerate(state.speed_places)),
    }
    return (
        *solver_code(),
        SourceFunction("settle", "void(f8[::1], f8[::1])", _SETTLE % sizes),
        SourceFunction("derivative", "void(f8[::1], f8[::1], f8[::1], f8[::1])", _DERIVATIVE % sizes),
    )


def _watch(state: LoopState, rows: Sequence[int]) -> str:
    """Return the statements of `settle` that tell the side, from slopes that it has anyway."""
    p = len(rows)
    picked = "".join(f"        D[{i}, j] = A[{row}, {state.n} + j]\n" for i, row in enumerate(rows))
    return f"""\
    D = np.empty(({p}, {p}))
    for j in range({p}):
{picked}    volume, usual = signed_volume(D), x[{state.side}]
    if volume * usual < 0.0 or abs(volume) < {NEAR!r} * abs(usual):
        x[{state.passed}] = 1.0
    if volume * usual < 0.0:
        x[{state.side}] = -usual
"""


def _added(places: list[int]) -> str:
    return "".join(f"        x[{place}] += y[{k}]\n" for k, place in enumerate(places))


_DERIVATIVE = """\
def derivative(x, u, constants, dx):
    t, y = np.empty(%(size)d), np.empty(%(N)d)
    plant(x, u, constants, t)
    L, Q = np.empty((%(N)d, %(N)d)), np.empty((%(r)d, %(N)d))
    R, order, parts = np.empty((%(r)d, %(r)d)), np.empty(%(r)d + 1), np.empty(%(r)d)
    A = t[%(A)d:%(b)d].reshape((%(r)d, %(N)d))
    factor_mass(t[:%(M)d].reshape((%(N)d, %(N)d)), A, %(nothing)s, L)
    factor_rows(A, L, %(dependent)s, Q, R, order)
    solve_rows(L, Q, R, order, t[%(M)d:%(A)d], t[%(b)d:%(rates)d], parts, y)
%(moved)s    dx[%(gap)d] = dx[%(side)d] = dx[%(passed)d] = 0.0
"""

_SETTLE = """\
def settle(x, constants):
    t, y, v, f = np.empty(%(stance)d), np.empty(%(N)d), np.empty(%(N)d), np.zeros(%(N)d)
    L, Q = np.empty((%(N)d, %(N)d)), np.empty((%(r)d, %(N)d))
    R, order, parts, b = np.empty((%(r)d, %(r)d)), np.empty(%(r)d + 1), np.empty(%(r)d), np.empty(%(r)d)
    for _ in range(%(rounds)d):
        stance(x, constants, t)
        A = t[%(M)d:%(left)d].reshape((%(r)d, %(N)d))
        factor_mass(t[:%(M)d].reshape((%(N)d, %(N)d)), A, %(nothing)s, L)
        factor_rows(A, L, %(dependent)s, Q, R, order)
        most = 0.0
        for k in range(%(r)d):
            if not abs(t[%(left)d + k]) <= most:
                most = abs(t[%(left)d + k])
        x[%(gap)d] = most
        solve_rows(L, Q, R, order, f, t[%(left)d:], parts, y)
%(placed)s%(speeds)s        for k in range(%(r)d):
            b[k] = 0.0
            for i in range(%(N)d):
                b[k] -= A[k, i] * v[i]
        solve_rows(L, Q, R, order, f, b, parts, y)
%(sped)s        if not most > %(settled)s:
            break
%(watch)s"""
