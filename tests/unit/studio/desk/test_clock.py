"""The clock of live runs, on a wall that the test moves."""

import pytest

from ropsim.studio.testing import PacedClock


class Wall:
    def __init__(self) -> None:
        self.time = 100.0

    def __call__(self) -> float:
        return self.time


@pytest.fixture
def wall() -> Wall:
    return Wall()


def test_it_passes_with_the_wall_at_its_speed(wall: Wall) -> None:
    clock = PacedClock(wall, 2.0)
    clock.extend(10.0)
    wall.time += 1.5
    assert clock.now() == pytest.approx(3.0)
    clock.set_speed(0.5)
    wall.time += 1.0
    assert clock.now() == pytest.approx(3.5)
    assert clock.wait_for(4.0) == pytest.approx(1.0)


def test_it_stands_exactly_at_its_horizon_and_does_not_catch_up(wall: Wall) -> None:
    clock = PacedClock(wall, 1.0)
    clock.extend(2.003)
    wall.time += 7.0
    assert clock.now() == 2.003
    clock.extend(5.0)
    wall.time += 1.0
    assert clock.now() == pytest.approx(3.003)


def test_computing_takes_nothing_from_the_time_that_is_shown(wall: Wall) -> None:
    clock = PacedClock(wall, 1.0)
    clock.extend(1.0)
    wall.time += 30.0  # the next instruction is being computed
    clock.extend(9.0)
    assert clock.now() == 1.0


@pytest.mark.parametrize(("wanted", "speed"), [(0.0, 0.1), (100.0, 8.0), (float("nan"), 1.0), (3.0, 3.0)])
def test_speeds_are_kept_in_their_range(wall: Wall, wanted: float, speed: float) -> None:
    assert PacedClock(wall, wanted).speed == speed
