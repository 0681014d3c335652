"""Ticks at which a motion is looked at."""

import numpy as np
import pytest

from ropsim.motion import Ticks


@pytest.mark.parametrize(
    ("duration", "together", "last"),
    [(0.010, 1, 10), (0.0101, 1, 11), (0.010, 4, 12), (0.012, 4, 12), (0.0121, 4, 16), (1e-6, 4, 4)],
)
def test_ticks_go_on_to_a_whole_number_of_those_that_belong_together(
    duration: float, together: int, last: int
) -> None:
    times = Ticks(1e-3, together).times(duration)
    assert times == pytest.approx(1e-3 * np.arange(last + 1), abs=1e-15)


def test_the_end_is_at_the_first_tick_that_is_not_before_it_but_for_rounding() -> None:
    assert Ticks(1e-3, 4).count(0.0101) == 11
    assert Ticks(1e-3).count(3 * 0.1) == 300  # 0.30000000000000004
