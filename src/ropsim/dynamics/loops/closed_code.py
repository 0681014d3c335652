"""Source of the dynamics of mechanisms with closed chains, at positions that are closed.

All coordinates of the tree are y = (q, z): of the axes, and of closed chains. With
the efforts f of the tree at a motion of all coordinates, the efforts of the axes are f_q + Kᵀ·f_z by virtual
work, where ż = K·q̇ follows from the rows A of the cuts. Forward dynamics solves all coordinates at once, so
that it has an answer in dead centres too.
"""

from functools import lru_cache

from ropsim.codegen import Formula, GivenCode, SourceFunction, Tracer
from ropsim.dynamics.loops.plant_code import entered, whole_matrix
from ropsim.dynamics.loops.solver import DEPENDENT, NOTHING
from ropsim.dynamics.loops.solver_code import solver_code
from ropsim.dynamics.structure import ArmStructure, traced_numbers
from ropsim.dynamics.traced.loop_rows import trace_drift, trace_loops
from ropsim.dynamics.traced.mass_matrix import trace_mass_matrix
from ropsim.dynamics.traced.newton_euler import Wrench, trace_inverse
from ropsim.dynamics.traced.traced_arm import trace_arm

_VECTORS = "f8[::1], f8[::1], f8[::1]"


@lru_cache(maxsize=64)
def traced_terms(structure: ArmStructure) -> GivenCode:
    """Return `terms(y, yd, wrench, constants, out)` and `efforts(y, yd, ydd, wrench, constants, out)`.

    With N coordinates and r rows, `terms` enters the mass matrix of the rigid bodies (N·N), the efforts
    without accelerations (N), the slopes of the residuals between the frames (r·N), and their second
    derivatives without accelerations (r); `efforts` the efforts of a motion (N) and the slopes.
    """
    tracer, count = Tracer(), structure.count
    y, yd, ydd = (tracer.variables(name, count) for name in ("y", "yd", "ydd"))
    fx, fy, fz, mx, my, mz = tracer.variables("wrench", 6)
    tip = Wrench((fx, fy, fz), (mx, my, mz))
    arm = trace_arm(tracer, structure, traced_numbers(tracer, structure), y)
    rows = trace_loops(arm, structure.cuts)
    slopes = [one for row in rows.slopes for one in row]
    bias = trace_inverse(arm, yd, [tracer.constant(0.0)] * count, tip)
    terms = [*whole_matrix(trace_mass_matrix(arm)), *bias, *slopes, *trace_drift(arm, rows, yd)]
    efforts = [*trace_inverse(arm, yd, ydd, tip), *slopes]
    return GivenCode.of(
        Formula("terms", ("y", "yd", "wrench", "out"), entered(terms)),
        Formula("efforts", ("y", "yd", "ydd", "wrench", "out"), entered(efforts)),
    )


@lru_cache(maxsize=64)
def closed_functions(structure: ArmStructure) -> dict[str, tuple[SourceFunction, ...]]:
    """Return the functions of closed chains by name, each behind the functions that it calls.

    `closed_torques(y, yd, ydd, wrench, constants, tau)`, `closed_mass(y, constants, M)`,
    `closed_accelerations(y, yd, net, inertia, constants, qdd)`, and the torques of many motions, one in each
    row: `closed_rows(constants, y, yd, ydd, tau)`.
    """
    n, p, r = structure.n, structure.passive, structure.rows
    count = n + p
    sizes = {
        "n": n,
        "p": p,
        "r": r,
        "N": count,
        "M": count * count,
        "A": count * (count + 1),
        "b": count * (count + 1 + r),
        "terms": count * (count + 1 + r) + r,
        "dependent": repr(DEPENDENT),
        "nothing": repr(NOTHING),
    }
    ratios = SourceFunction("ratios", "void(f8[:,::1], f8[:,::1])", _RATIOS % sizes)
    before = (*traced_terms(structure).functions, *solver_code(), ratios)
    torques = SourceFunction("closed_torques", f"void({_VECTORS}, {_VECTORS})", _TORQUES % sizes)
    rows = SourceFunction("closed_rows", f"void(f8[::1]{', f8[:,::1]' * 4})", _ROWS)
    mass = SourceFunction("closed_mass", f"void({_VECTORS})", _MASS % sizes)
    accelerations = SourceFunction(
        "closed_accelerations", f"void({_VECTORS}, {_VECTORS})", _ACCELERATIONS % sizes
    )
    return {
        "closed_torques": (*before, torques),
        "closed_rows": (*before, torques, rows),
        "closed_mass": (*before, mass),
        "closed_accelerations": (*before, accelerations),
    }


_RATIOS = """\
def ratios(A, K):
    L, Q = np.empty((%(p)d, %(p)d)), np.empty((%(r)d, %(p)d))
    R, order, parts = np.empty((%(r)d, %(r)d)), np.empty(%(r)d + 1), np.empty(%(r)d)
    rows, b, nothing = np.empty((%(r)d, %(p)d)), np.empty(%(r)d), np.zeros(%(p)d)
    for k in range(%(r)d):
        for j in range(%(p)d):
            rows[k, j] = A[k, %(n)d + j]
    for i in range(%(p)d):
        for j in range(%(p)d):
            L[i, j] = 1.0 if i == j else 0.0
    factor_rows(rows, L, %(dependent)s, Q, R, order)
    for i in range(%(n)d):
        for k in range(%(r)d):
            b[k] = -A[k, i]
        solve_rows(L, Q, R, order, nothing, b, parts, K[i])
"""
"""Rows of `K` are the changes of the passive coordinates by each axis."""

_TORQUES = """\
def closed_torques(y, yd, ydd, wrench, constants, tau):
    f, K = np.empty(%(N)d * (1 + %(r)d)), np.empty((%(n)d, %(p)d))
    efforts(y, yd, ydd, wrench, constants, f)
    ratios(f[%(N)d:].reshape((%(r)d, %(N)d)), K)
    for i in range(%(n)d):
        tau[i] = f[i]
        for j in range(%(p)d):
            tau[i] += K[i, j] * f[%(n)d + j]
"""

_ROWS = """\
def closed_rows(constants, y, yd, ydd, tau):
    wrench = np.zeros(6)
    for k in range(y.shape[0]):
        closed_torques(y[k], yd[k], ydd[k], wrench, constants, tau[k])
"""

_ACCELERATIONS = """\
def closed_accelerations(y, yd, net, inertia, constants, qdd):
    t, f, ydd = np.empty(%(terms)d), np.empty(%(N)d), np.empty(%(N)d)
    terms(y, yd, np.zeros(6), constants, t)
    M, A, b = t[:%(M)d].reshape((%(N)d, %(N)d)), t[%(A)d:%(b)d].reshape((%(r)d, %(N)d)), -t[%(b)d:]
    for i in range(%(N)d):
        f[i] = -t[%(M)d + i]
        if i < %(n)d:
            f[i] += net[i]
            M[i, i] += inertia[i]
    L, Q = np.empty((%(N)d, %(N)d)), np.empty((%(r)d, %(N)d))
    R, order, parts = np.empty((%(r)d, %(r)d)), np.empty(%(r)d + 1), np.empty(%(r)d)
    factor_mass(M, A, %(nothing)s, L)
    factor_rows(A, L, %(dependent)s, Q, R, order)
    solve_rows(L, Q, R, order, f, b, parts, ydd)
    for i in range(%(n)d):
        qdd[i] = ydd[i]
"""

_MASS = """\
def closed_mass(y, constants, M):
    t, K = np.empty(%(terms)d), np.empty((%(n)d, %(p)d))
    terms(y, np.zeros(%(N)d), np.zeros(6), constants, t)
    ratios(t[%(A)d:%(b)d].reshape((%(r)d, %(N)d)), K)
    whole = np.zeros((%(n)d, %(N)d))
    for i in range(%(n)d):
        whole[i, i] = 1.0
        for j in range(%(p)d):
            whole[i, %(n)d + j] = K[i, j]
    for i in range(%(n)d):
        for j in range(%(n)d):
            total = 0.0
            for a in range(%(N)d):
                for c in range(%(N)d):
                    total += whole[i, a] * t[%(N)d * a + c] * whole[j, c]
            M[%(n)d * i + j] = total
"""
