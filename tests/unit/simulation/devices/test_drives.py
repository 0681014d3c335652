"""Drives of devices: what they do at a signal, and what they tell."""

import pytest

from ropsim.model import Barrier, BeltDrive, IndexDrive, SwitchDrive
from ropsim.simulation.devices.belt import Belt
from ropsim.simulation.devices.course import Course
from ropsim.simulation.devices.device_run import Carried, Driving, Now, Told
from ropsim.simulation.devices.index import Index
from ropsim.simulation.devices.switch import Switch

BELT = BeltDrive(0.5, 2.0, "run", 3.0, Barrier(2.0, "eye"))


def acted(driving: Driving, course: Course, time: float, *on: str, carried: tuple[Carried, ...] = ()) -> Told:
    return driving.act(course, Now(time, lambda name: name in on, carried))


def test_the_front_of_the_next_part_comes_to_rest_in_the_barrier_and_holds_the_belt() -> None:
    belt, course = Belt(BELT), Course()
    parts = (Carried("a", 0.5, 0.2), Carried("b", 0.1, 0.2))
    told = acted(belt, course, 1.0, "run", carried=parts)
    assert told.levels == (("eye", False),)
    # 1.5 m: 0.25 s up, 0.25 s down at 0.25 m/s on average, the rest at full speed
    assert told.due == pytest.approx(1.0 + 0.5 + (1.5 - 0.125) / 0.5, rel=1e-12)
    told = acted(belt, course, told.due, "run", carried=parts)
    assert told.levels == (("eye", True),)
    assert course.at(99.0) == pytest.approx((1.5, 0.0), abs=1e-9)


def test_the_belt_goes_on_when_the_part_is_taken_and_stands_without_its_signal() -> None:
    belt, course = Belt(BELT), Course()
    first, second = Carried("a", 0.5, 0.2), Carried("b", 0.1, 0.2)
    due = acted(belt, course, 0.0, "run", carried=(first, second)).due
    acted(belt, course, due, "run", carried=(first, second))
    told = acted(belt, course, due + 1.0, "run", carried=(second,))
    assert told.levels == (("eye", False),)
    assert course.at(told.due)[0] == pytest.approx(1.9, abs=1e-9)
    acted(belt, course, due + 1.2, carried=(second,))
    assert course.at(99.0)[1] == 0.0
    assert course.at(99.0)[0] < 1.9


def test_a_part_at_the_end_of_the_belt_is_lost_when_its_centre_gets_there() -> None:
    belt, course = Belt(BeltDrive(0.5, 2.0, "", 3.0)), Course()
    part = Carried("a", 0.5, 0.2)
    told = acted(belt, course, 0.0, carried=(part,))
    assert course.at(told.due)[0] == pytest.approx(3.0 - 0.4, abs=1e-9)
    assert acted(belt, course, told.due, carried=(part,)).lost == ("a",)


def test_a_switch_goes_to_and_fro_also_from_half_way() -> None:
    drive = SwitchDrive("open", 0.0, 0.8, 0.5, 1.0, "is_closed", "is_open")
    switch, course = Switch(drive), Course()
    assert acted(switch, course, 0.0).levels == (("is_closed", True), ("is_open", False))
    told = acted(switch, course, 1.0, "open")
    assert told.levels == (("is_closed", False), ("is_open", False))
    assert told.due == pytest.approx(1.0 + 0.8 / 0.5 + 0.5, rel=1e-12)
    back = acted(switch, course, 2.0)
    assert back.levels == (("is_closed", False), ("is_open", False))
    assert acted(switch, course, back.due).levels == (("is_closed", True), ("is_open", False))
    assert course.at(99.0)[0] == 0.0
    there = acted(switch, course, 10.0, "open").due
    assert acted(switch, course, there, "open").levels == (("is_closed", False), ("is_open", True))


def test_an_index_makes_one_step_each_time_its_signal_comes_on() -> None:
    index, course = Index(IndexDrive("step", 1.5, 1.0, 4.0, "in_place")), Course()
    assert acted(index, course, 0.0).levels == (("in_place", True),)
    due = acted(index, course, 1.0, "step").due
    assert acted(index, course, 1.5).levels == (("in_place", False),)
    assert acted(index, course, 1.6, "step").due == due  # it moves: what comes now is not kept
    assert acted(index, course, due, "step").levels == (("in_place", True),)
    assert course.at(99.0)[0] == 1.5
    acted(index, course, due + 1.0)
    again = acted(index, course, due + 2.0, "step").due
    assert course.at(again)[0] == 3.0
