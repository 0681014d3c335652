"""The motion clock beside the servo, for slices of one interpolation tick."""

from typing import Any

import numpy as np
from measuring import Measure, processor_seconds

import ropsim
from ropsim.controller import ClockLimits, ClockState, advance
from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation import Servo
from support.walked_rows import PERIOD, s_curve

ROBOT = ropsim.robots.load("puma560")
CONTROLLER = ropsim.robots.default_controller("puma560")
WAYS = [1.2, 0.4, -0.6, 0.6, 0.5, -1.0]
MOVE = s_curve(WAYS)
LIMITS = ClockLimits(5.0, 100.0, np.full(6, 10.0))
SLICE, CALLS = 4, 500


class PlannedRows:
    """Rows of a plan: parts of arrays that are there."""

    count = MOVE.count

    def rows(self, first: int, last: int) -> JointReference:
        """Return the rows of a part."""
        one = MOVE.reference
        return JointReference(one.q[first:last], one.qd[first:last], one.qdd[first:last])


ROWS = PlannedRows()


def taken() -> None:
    """Take slice after slice of the rows, as whoever follows them must in any case."""
    for call in range(CALLS):
        ROWS.rows(1 + call % 400, 1 + SLICE + call % 400)


def walked(state: ClockState, override: float) -> None:
    """Walk on from one state, again and again."""
    for _ in range(CALLS):
        advance(state, ROWS, SLICE, override, LIMITS, PERIOD)


def test_motion_clock(benchmark: Any) -> None:
    """What a slice costs beyond taking its rows, undisturbed and disturbed, beside the servo."""
    measure = Measure(benchmark)
    servo, nothing = Servo.build(ROBOT, CONTROLLER), Payload()
    state = servo.initial_state(ROBOT.home)
    recorder = servo.recorder(state, 10)
    still = JointReference(np.tile(ROBOT.home, (SLICE, 1)), np.zeros((SLICE, 6)), np.zeros((SLICE, 6)))

    def followed() -> None:
        now = state
        for _ in range(CALLS):
            now = servo.run(now, still, nothing, recorder)

    kinds = {
        "undisturbed": lambda: walked(ClockState(100.0), 1.0),
        "at half rate": lambda: walked(ClockState(100.3, 0.5), 0.5),
        "back at full rate": lambda: walked(ClockState(100.3), 1.0),
        "slowing down": lambda: walked(ClockState(100.0, 0.9, -2.0), 0.0),
    }
    measure(kinds["undisturbed"], rounds=20)
    rows, one_slice, *times = processor_seconds(taken, followed, *kinds.values(), rounds=40)
    measure.figure("us per slice of the servo", 1e6 * one_slice / CALLS)
    measure.figure("us that taking the rows of a slice takes", 1e6 * rows / CALLS)
    for name, seconds in zip(kinds, times, strict=True):
        measure.figure(f"us per slice of the clock beyond its rows, {name}", 1e6 * (seconds - rows) / CALLS)
        share = (seconds - rows) / one_slice
        measure.figure(f"share of the servo, {name}", share, most=0.1 if name == "undisturbed" else 1.0)
