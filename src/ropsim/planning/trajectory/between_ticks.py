"""Fine interpolation: joint references between interpolation ticks by lines or cubics."""

import numpy as np

from ropsim.flow import JointReference
from ropsim.model import BuiltIn, ControllerModel
from ropsim.spatial import Array


def between_ticks(reference: JointReference, q_start: Array, controller: ControllerModel) -> JointReference:
    """Return the references of a motion from rest to rest that the joint interpolator makes.

    The standard one takes all from the trajectory. Coarse and fine interpolation takes it at the
    interpolation ticks only. Lines between them are off the trajectory by at most a·T²/8 with the
    interpolation period T; their speed goes in steps, and the acceleration that is fed forward is the second
    difference of the coordinates, held for a period. Cubics have coordinates and speeds of the trajectory at
    their ends; they are off by at most T⁴/384 times its fourth derivative.

    Args:
        reference: at the control ticks 1, 2, … of the motion, at rest with the last one.
        q_start: joint coordinates at its start [rad | m], shape (n,).
        controller: with its rates and built-in entities.

    References:
        de Boor 1978, A Practical Guide to Splines, chapters III and IV, for both bounds.
    """
    kinds = set(controller.built_in) & {BuiltIn.LINEAR, BuiltIn.CUBIC}
    every = controller.rates.interpolation_ticks
    if not kinds or every == 1 or reference.ticks == 0:
        return reference
    ends = np.append(np.arange(every, reference.ticks, every), reference.ticks)
    spans = np.diff(ends, prepend=0)
    of = np.repeat(np.arange(len(ends)), spans)
    T = (spans * controller.rates.control_period)[:, None]
    u = ((np.arange(reference.ticks) + 1 - (ends - spans)[of]) / spans[of])[:, None]
    q_to, qd_to = reference.q[ends - 1], reference.qd[ends - 1]
    q_from, qd_from = np.vstack((q_start, q_to[:-1])), np.vstack((np.zeros_like(q_start), qd_to[:-1]))
    way = q_to - q_from
    if BuiltIn.LINEAR in kinds:
        speed = way / T
        change = np.diff(speed, axis=0, prepend=np.zeros((1, way.shape[1]))) / T
        made = q_from[of] + u * way[of], speed[of], change[of]
    else:
        a, b = qd_from * T, qd_to * T
        c2, c3 = 3.0 * way - 2.0 * a - b, a + b - 2.0 * way
        made = (
            q_from[of] + u * (a[of] + u * (c2[of] + u * c3[of])),
            (a[of] + u * (2.0 * c2[of] + u * 3.0 * c3[of])) / T[of],
            (2.0 * c2[of] + 6.0 * u * c3[of]) / T[of] ** 2,
        )
    q, qd, qdd = (np.ascontiguousarray(one) for one in made)
    q[-1], qd[-1], qdd[-1] = reference.q[-1], 0.0, 0.0
    return JointReference(q, qd, qdd)
