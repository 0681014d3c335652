"""Drives of devices: what they do at a signal, and what they tell."""

import pytest

from ropsim.model import Barrier, BeltDrive, IndexDrive, SwitchDrive
from ropsim.simulation.testing import AxisProfile, Belt, Carried, DriveAction, Driving, Index, Now, Switch

BELT = BeltDrive(0.5, 2.0, "run", 3.0, Barrier(2.0, "eye"))


def acted(
    driving: Driving, profile: AxisProfile, time: float, *on: str, carried: tuple[Carried, ...] = ()
) -> DriveAction:
    return driving.act(profile, Now(time, lambda name: name in on, carried))


def test_the_front_of_the_next_part_comes_to_rest_in_the_barrier_and_holds_the_belt() -> None:
    belt, profile = Belt(BELT), AxisProfile()
    parts = (Carried("a", 0.5, 0.2), Carried("b", 0.1, 0.2))
    told = acted(belt, profile, 1.0, "run", carried=parts)
    assert told.levels == (("eye", False),)
    # 1.5 m: 0.25 s up, 0.25 s down at 0.25 m/s on average, the rest at full speed
    assert told.due == pytest.approx(1.0 + 0.5 + (1.5 - 0.125) / 0.5, rel=1e-12)
    told = acted(belt, profile, told.due, "run", carried=parts)
    assert told.levels == (("eye", True),)
    assert profile.at(99.0) == pytest.approx((1.5, 0.0), abs=1e-9)


def test_the_belt_goes_on_when_the_part_is_taken_and_stands_without_its_signal() -> None:
    belt, profile = Belt(BELT), AxisProfile()
    first, second = Carried("a", 0.5, 0.2), Carried("b", 0.1, 0.2)
    due = acted(belt, profile, 0.0, "run", carried=(first, second)).due
    acted(belt, profile, due, "run", carried=(first, second))
    told = acted(belt, profile, due + 1.0, "run", carried=(second,))
    assert told.levels == (("eye", False),)
    assert profile.at(told.due)[0] == pytest.approx(1.9, abs=1e-9)
    acted(belt, profile, due + 1.2, carried=(second,))
    assert profile.at(99.0)[1] == 0.0
    assert profile.at(99.0)[0] < 1.9


def test_a_part_at_the_end_of_the_belt_is_lost_when_its_centre_gets_there() -> None:
    belt, profile = Belt(BeltDrive(0.5, 2.0, "", 3.0)), AxisProfile()
    part = Carried("a", 0.5, 0.2)
    told = acted(belt, profile, 0.0, carried=(part,))
    assert profile.at(told.due)[0] == pytest.approx(3.0 - 0.4, abs=1e-9)
    assert acted(belt, profile, told.due, carried=(part,)).lost == ("a",)


def test_a_switch_goes_to_and_fro_also_from_half_way() -> None:
    drive = SwitchDrive("open", 0.0, 0.8, 0.5, 1.0, "is_closed", "is_open")
    switch, profile = Switch(drive), AxisProfile()
    assert acted(switch, profile, 0.0).levels == (("is_closed", True), ("is_open", False))
    told = acted(switch, profile, 1.0, "open")
    assert told.levels == (("is_closed", False), ("is_open", False))
    assert told.due == pytest.approx(1.0 + 0.8 / 0.5 + 0.5, rel=1e-12)
    back = acted(switch, profile, 2.0)
    assert back.levels == (("is_closed", False), ("is_open", False))
    assert acted(switch, profile, back.due).levels == (("is_closed", True), ("is_open", False))
    assert profile.at(99.0)[0] == 0.0
    there = acted(switch, profile, 10.0, "open").due
    assert acted(switch, profile, there, "open").levels == (("is_closed", False), ("is_open", True))


def test_an_index_makes_one_step_each_time_its_signal_comes_on() -> None:
    index, profile = Index(IndexDrive("step", 1.5, 1.0, 4.0, "in_place")), AxisProfile()
    assert acted(index, profile, 0.0).levels == (("in_place", True),)
    due = acted(index, profile, 1.0, "step").due
    assert acted(index, profile, 1.5).levels == (("in_place", False),)
    assert acted(index, profile, 1.6, "step").due == due  # it moves: what comes now is not kept
    assert acted(index, profile, due, "step").levels == (("in_place", True),)
    assert profile.at(99.0)[0] == 1.5
    acted(index, profile, due + 1.0)
    again = acted(index, profile, due + 2.0, "step").due
    assert profile.at(again)[0] == 3.0
