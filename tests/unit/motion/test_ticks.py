"""Ticks at which a motion is looked at."""

import numpy as np
import pytest

from ropsim.motion import Ticks


@pytest.mark.parametrize(("duration", "last"), [(0.010, 10), (0.0101, 11), (0.0129, 13), (1e-6, 1), (0.0, 0)])
def test_ticks_go_on_to_the_first_one_at_which_the_motion_rests(duration: float, last: int) -> None:
    times = Ticks(1e-3).times(duration)
    assert times == pytest.approx(1e-3 * np.arange(last + 1), abs=1e-15)


def test_the_end_is_at_the_first_tick_that_is_not_before_it_but_for_rounding() -> None:
    assert Ticks(1e-3).count(0.0101) == 11
    assert Ticks(1e-3).count(3 * 0.1) == 300  # 0.30000000000000004
