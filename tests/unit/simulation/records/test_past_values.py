"""Values that change in steps, as they were in the immediate past of a run."""

from ropsim import robots
from ropsim.model import DistanceSensor, ForceTorqueSensor, SensorErrors, Signal, WrenchAxis
from ropsim.simulation.testing import PastValues, memory_of, memory_ticks
from support.cells import one_station


def test_a_value_holds_from_its_tick_until_the_next_one() -> None:
    past = PastValues("a")
    past.set(10, "b")
    past.set(20, "c")
    assert [past.at(tick) for tick in (-5, 0, 9, 10, 19, 20, 999)] == ["a", "a", "a", "b", "b", "c", "c"]


def test_of_two_values_at_one_tick_the_last_one_holds() -> None:
    past = PastValues(1)
    past.set(10, 2)
    past.set(10, 3)
    assert [past.at(tick) for tick in (9, 10)] == [1, 3]


def test_what_is_forgotten_is_what_nobody_may_ask_for() -> None:
    past = PastValues(0)
    for tick in range(10, 1000, 10):
        past.set(tick, tick)
        past.forget(tick - 25)
        assert [past.at(tick - back) for back in (0, 20, 25)] == [tick, max(tick - 20, 0), max(tick - 30, 0)]


def test_the_past_is_kept_for_as_long_as_the_slowest_sensor_is_late() -> None:
    late = DistanceSensor("", 0.2, errors=SensorErrors(period=0.02, delay=0.03))
    weighing = ForceTorqueSensor("", WrenchAxis.Z, compensated=False)
    signals = {
        name: Signal(name, is_input=True, analog=True, sensor=sensor)
        for name, sensor in (("late", late), ("weighing", weighing))
    }
    arm = robots.load("puma560")
    cell = one_station("c", arm, robots.default_controller(arm), signals=signals)
    assert memory_of(cell) == 0.05
    assert memory_ticks(cell, 1000) >= 50 + 2
    exact = one_station("c", arm, robots.default_controller(arm))
    assert memory_ticks(exact, 1000) == 0
