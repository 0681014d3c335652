"""Caps of many ticks at once are those of each tick alone, by quantity and kind."""

import numpy as np
import pytest

from ropsim.motion import JointBounds
from ropsim.planning.testing import ArmBounds, EvaluatedPath, imposed_limits

TICK = 1e-2


@pytest.mark.parametrize("scale", [0.1, 1.0, 1e3])
@pytest.mark.parametrize("seed", range(10))
def test_caps_of_many_ticks_are_those_of_each_by_quantity_and_kind(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    b, n = 7, 3
    arm = ArmBounds(JointBounds(*np.ones((4, n))), lambda _q, qd, qdd: 2.0 * qdd + 0.1 * np.abs(qd))

    def sums() -> tuple[np.ndarray, ...]:
        return tuple(scale * rng.normal(size=shape) for shape in ((2, b), (2, b), (2, b, n), (2, b, n)))

    v, a, d1, d2 = sums()
    jerks = scale * rng.normal(size=(2, b)) / TICK
    qd, qdd = d1[1] * v[1, :, None], d2 * (v * v)[:, :, None] + d1 * a[:, :, None]
    torque = 2.0 * qdd[1] + 0.1 * np.abs(qd)
    walked = EvaluatedPath(
        np.sort(rng.uniform(size=(2, b)), axis=0), v, a, jerks, d1, d2, np.zeros((b, n)), qd, qdd, torque
    )
    caps = imposed_limits(walked, arm, TICK, 0.99)
    found = [tuple(column) for column in caps.rows[:, : caps.count].T.tolist()]
    wanted = []
    for tick in range(b):
        here = slice(tick, tick + 1)
        at = walked.parameters[:, here], v[:, here], a[:, here], jerks[:, here]
        first, second = (np.ascontiguousarray(each[:, here]) for each in (d1, d2))
        joints = np.zeros((1, n)), qd[here], np.ascontiguousarray(qdd[:, here]), torque[here]
        alone = EvaluatedPath(*at, first, second, *joints)
        caps = imposed_limits(alone, arm, TICK, 0.99)
        wanted += [
            (*column[:2], float(tick), *column[3:]) for column in caps.rows[:, : caps.count].T.tolist()
        ]
    order = [(quantity, kind, tick, joint) for kind, _, tick, joint, quantity in found]
    assert order == sorted(order)
    assert sorted(found) == sorted(wanted)
