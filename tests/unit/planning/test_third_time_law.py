"""A third time law is one file and one table entry: here a stopping one, without a limit of jerk."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import ModalState
from ropsim.motion import TIME_LAWS, PiecewiseLaw
from ropsim.planning import MotionState, plan
from ropsim.spatial import Array
from support.motion import CHAIN, START, interface_pose, lin, references, shifted

WAY, SPEED, ACCELERATION = 0.2, 0.1, 2.0  # [m], [m/s], [m/s²]
MODAL = ModalState(path_speed=SPEED, path_acceleration=ACCELERATION)


def stopping(limits: Array, counts: Array) -> PiecewiseLaw:
    """Return a law that stops at the end of each interval: at rest, constant acceleration, speed, braking."""
    phases, ends, time, before = list[tuple[float, ...]](), list[float](), 0.0, 0
    for segment, count in enumerate(counts.astype(int).tolist()):
        place = 0.0
        for length, most, a, *_ in limits[before : before + count].tolist():
            v = min(most, (a * length) ** 0.5)
            rise, cruise = v / a, length / v - v / a
            for speed, acceleration, span in ((0.0, a, rise), (v, 0.0, cruise), (v, -a, rise)):
                end = place + speed * span + 0.5 * acceleration * span**2
                phases.append((segment, time, place, speed, acceleration, 0.0, span, end))
                time, place = time + span, end
        before += count
        ends.append(time)
    return PiecewiseLaw(np.array(phases).T.copy(), np.array(ends))


def test_a_chain_that_names_a_law_of_the_table_is_timed_by_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropsim.planning.planning.TIME_LAWS", {**TIME_LAWS, "stopping": stopping})
    joints = tuple(replace(one, max_jerk=1e9) for one in CHAIN.robot.joints)  # steps of acceleration are kept
    chain = replace(CHAIN, robot=replace(CHAIN.robot, joints=joints))
    moves = [lin(shifted(interface_pose(START), -WAY, 0.0, 0.0), MODAL)]
    planned, refusal = plan(replace(chain, time_law="stopping"), moves, MotionState.at_rest(START))
    usual, _ = plan(chain, moves, MotionState.at_rest(START))
    assert refusal is None
    assert planned is not None
    assert usual is not None
    whole = WAY / SPEED + SPEED / ACCELERATION
    assert 0.0 <= planned.duration - whole < CHAIN.controller.rates.control_period
    assert planned.duration < usual.duration
    assert np.abs(references(planned)[0][-1] - references(usual)[0][-1]).max() < 1e-9
