"""Source of the inverse dynamics of closed chains for joint controllers, which know the axes only.

The coordinates z of the chains follow from those of the axes by Newton's method from where they were at the
control tick before; their speeds and accelerations from the rows A of the cuts, Az·ż = -Aq·q̇ and
Az·z̈ = -(Aq·q̈ + γ). The efforts of the tree are brought to the axes by virtual work, as in `closed_code`.
"""

from functools import lru_cache

from ropsim.codegen import SourceFunction, Tracer, emit
from ropsim.dynamics.loops.solver import DEPENDENT
from ropsim.dynamics.loops.solver_code import solver_code
from ropsim.dynamics.structure import ArmStructure, split_numbers
from ropsim.dynamics.traced.loaded_arm import trace_loaded_tree
from ropsim.dynamics.traced.loop_rows import trace_drift, trace_loops
from ropsim.dynamics.traced.traced_arm import trace_arm
from ropsim.dynamics.traced.traced_drives import joint_sides

LOAD = 10
ROUNDS = 2
"""Steps of Newton's method at a control tick: chains move some milliradians from one to the next."""

LONGEST = 0.5
"""Longest step of a coordinate [rad | m]."""


@lru_cache(maxsize=16)
def closed_law_code(structure: ArmStructure) -> tuple[SourceFunction, ...]:
    """Return `closed_inverse(z, q, qd, qdd, speeds, model, load, tau)`, behind the functions that it calls.

    It brings z (p,) from near to the coordinates of the chains for axes at q (n,), and enters the torques of
    the drives at the axes that a motion takes, with tool and part, inertia and friction of the drives, whose
    friction is that at `speeds` (n,). `model` are the numbers of the arm, `load` the barycentric parameters
    of tool and part.

    Args:
        structure: of an arm with closed chains and rigid gears.
    """
    n, p, r = structure.n, structure.passive, structure.rows
    sizes: dict[str, int | str] = {"n": n, "p": p, "r": r, "N": n + p, "size": r * (1 + n + p)}
    sizes |= {"rounds": ROUNDS, "longest": repr(LONGEST), "dependent": repr(DEPENDENT)}
    vectors = ", ".join(["f8[::1]"] * 8)
    inverse = SourceFunction("closed_inverse", f"void({vectors})", _INVERSE % sizes)
    return (*solver_code(), *_rows(structure), _efforts(structure), _sides(structure), inverse)


def _rows(structure: ArmStructure) -> tuple[SourceFunction, SourceFunction]:
    """Return `chain_rows(y, out)`, residuals and slopes, and `chain_drift(y, yd, out)`."""
    tracer = Tracer()
    y, yd = (tracer.variables(name, structure.count) for name in ("y", "yd"))
    zero = tracer.constant(0.0)
    numbers = split_numbers(structure, [zero] * len(structure.present))
    arm = trace_arm(tracer, structure, numbers, y)
    rows = trace_loops(arm, structure.cuts)
    values = [*rows.left, *(one for row in rows.slopes for one in row)]
    drift = trace_drift(arm, rows, yd)
    return (
        emit("chain_rows", ("y", "out"), [(f"out[{k}]", one) for k, one in enumerate(values)]),
        emit("chain_drift", ("y", "yd", "out"), [(f"out[{k}]", one) for k, one in enumerate(drift)]),
    )


def _efforts(structure: ArmStructure) -> SourceFunction:
    """Return `chain_efforts(y, yd, ydd, model, load, out)`: of bodies and springs, at all coordinates."""
    tracer = Tracer()
    y, yd, ydd = (tracer.variables(name, structure.count) for name in ("y", "yd", "ydd"))
    zero = tracer.constant(0.0)
    given = [tracer.variable(f"model[{k}]") if there else zero for k, there in enumerate(structure.present)]
    numbers, load = split_numbers(structure, given), tracer.variables("load", LOAD)
    found = trace_loaded_tree(tracer, structure, numbers, (y, yd, ydd), load)
    results = [(f"out[{k}]", one) for k, one in enumerate(found)]
    return emit("chain_efforts", ("y", "yd", "ydd", "model", "load", "out"), results)


def _sides(structure: ArmStructure) -> SourceFunction:
    """Return `chain_sides(q, speeds, qdd, efforts, model, tau)`, with what the drives need themselves."""
    tracer, n = Tracer(), structure.n
    q, speeds, qdd, efforts = (tracer.variables(name, n) for name in ("q", "speeds", "qdd", "efforts"))
    given = [tracer.variable(f"model[{k}]") for k in range(len(structure.present))]
    sides = joint_sides(structure, split_numbers(structure, given).drives, tracer, (q, speeds))
    found = [side.needed(efforts[k] + qdd[k] * side.inertia) for k, side in enumerate(sides)]
    results = [(f"tau[{k}]", one) for k, one in enumerate(found)]
    return emit("chain_sides", ("q", "speeds", "qdd", "efforts", "model", "tau"), results)


_INVERSE = """\
def closed_inverse(z, q, qd, qdd, speeds, model, load, tau):
    t, y, yd, ydd = np.empty(%(size)d), np.empty(%(N)d), np.empty(%(N)d), np.empty(%(N)d)
    L, rows, Q = np.empty((%(p)d, %(p)d)), np.empty((%(r)d, %(p)d)), np.empty((%(r)d, %(p)d))
    R, order, parts = np.empty((%(r)d, %(r)d)), np.empty(%(r)d + 1), np.empty(%(r)d)
    b, drift, f = np.empty(%(r)d), np.empty(%(r)d), np.empty(%(N)d)
    change, nothing, efforts = np.empty(%(p)d), np.zeros(%(p)d), np.empty(%(n)d)
    for i in range(%(p)d):
        for j in range(%(p)d):
            L[i, j] = 1.0 if i == j else 0.0
    for i in range(%(n)d):
        y[i], yd[i], ydd[i] = q[i], qd[i], qdd[i]
    A = t[%(r)d:].reshape((%(r)d, %(N)d))
    for step in range(%(rounds)d + 1):
        for j in range(%(p)d):
            y[%(n)d + j] = z[j]
        chain_rows(y, t)
        for k in range(%(r)d):
            b[k] = -t[k]
            for j in range(%(p)d):
                rows[k, j] = A[k, %(n)d + j]
        factor_rows(rows, L, %(dependent)s, Q, R, order)
        if step < %(rounds)d:
            solve_rows(L, Q, R, order, nothing, b, parts, change)
            for j in range(%(p)d):
                z[j] += min(max(change[j], -%(longest)s), %(longest)s)
    for k in range(%(r)d):
        b[k] = 0.0
        for i in range(%(n)d):
            b[k] -= A[k, i] * qd[i]
    solve_rows(L, Q, R, order, nothing, b, parts, yd[%(n)d:])
    chain_drift(y, yd, drift)
    for k in range(%(r)d):
        b[k] = -drift[k]
        for i in range(%(n)d):
            b[k] -= A[k, i] * qdd[i]
    solve_rows(L, Q, R, order, nothing, b, parts, ydd[%(n)d:])
    chain_efforts(y, yd, ydd, model, load, f)
    for i in range(%(n)d):
        for k in range(%(r)d):
            b[k] = -A[k, i]
        solve_rows(L, Q, R, order, nothing, b, parts, change)
        efforts[i] = f[i]
        for j in range(%(p)d):
            efforts[i] += change[j] * f[%(n)d + j]
    chain_sides(q, speeds, qdd, efforts, model, tau)
"""
