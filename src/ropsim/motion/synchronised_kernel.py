"""Rows of joints that each have a profile of their own over one time, in loops that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[::1], f8[::1], f8[:,::1], f8, f8[::1], f8[:,:,::1])")
def joint_rows(
    q_start: Array, q_end: Array, shapes: Array, duration: float, times: Array, out: Array
) -> None:
    """Write coordinates, speeds and accelerations of n joints at k times.

    The second half of a profile is the mirror of its first one: at u from the nearer end there lie behind x1
    of jerk, x2 of constant acceleration, x3 of negative jerk and x4 of constant speed.

    Args:
        q_start: coordinates at the start [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
        shapes: of the profiles, see `SynchronisedJoints`, shape (3, n).
        duration: of all profiles [s].
        times: [s], shape (k,); outside of the motion the joints rest.
        out: where the rows go, shape (3, k, n).
    """
    for k in range(times.shape[0]):
        time = min(max(times[k], 0.0), duration)
        mirrored = time > 0.5 * duration
        u = duration - time if mirrored else time
        for i in range(q_start.shape[0]):
            j, tj, ta = shapes[0, i], shapes[1, i], shapes[2, i]
            x1 = min(u, tj)
            x2 = min(max(u - tj, 0.0), ta)
            x3 = min(max(u - (tj + ta), 0.0), tj)
            x4 = max(u - (2.0 * tj + ta), 0.0)
            a = j * tj
            v1, v2, v3 = 0.5 * a * tj, a * (0.5 * tj + ta), a * (tj + ta)
            way = j * x1 * x1 * x1 / 6.0 + (v1 + 0.5 * a * x2) * x2
            way += (v2 + (0.5 * a - j * x3 / 6.0) * x3) * x3 + v3 * x4
            change = j * (x1 - x3)
            out[0, k, i] = q_end[i] - way if mirrored else q_start[i] + way
            out[1, k, i] = 0.5 * j * (x1 - x3) * (x1 + x3) + a * (x2 + x3)
            out[2, k, i] = -change if mirrored else change
