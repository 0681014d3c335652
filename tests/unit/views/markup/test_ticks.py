import pytest

from ropsim.views.testing import nice_step, nice_ticks, tick_text


@pytest.mark.parametrize(("raw", "step"), [(1.0, 1.0), (1.1, 2.0), (0.03, 0.05), (70.0, 100.0), (2e-7, 2e-7)])
def test_steps_are_one_two_or_five_times_a_power_of_ten(raw: float, step: float) -> None:
    assert nice_step(raw) == pytest.approx(step)


def test_ticks_lie_inside_the_range() -> None:
    assert nice_ticks(-0.9, 2.1, 3) == (0.0, 1.0, 2.0)


def test_ticks_are_written_with_the_decimals_they_need() -> None:
    ticks = nice_ticks(0.0, 0.1, 5)
    assert [tick_text(tick, ticks) for tick in ticks] == ["0.00", "0.02", "0.04", "0.06", "0.08", "0.10"]


@pytest.mark.parametrize(("low", "high"), [(1.0, 1.0), (float("nan"), 1.0), (0.0, float("inf"))])
def test_empty_or_unknown_ranges_have_no_ticks(low: float, high: float) -> None:
    assert nice_ticks(low, high, 5) == ()
