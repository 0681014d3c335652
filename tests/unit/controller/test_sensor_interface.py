"""Channels: scripted inputs, outputs that programs set, unknown names."""

from ropsim.controller import CellSensors
from ropsim.model import Signal
from ropsim.planning import NothingSensed, Sample

SIGNALS = {
    "part_ready": Signal("part_ready", is_input=True, changes=((1.0, 1.0), (2.5, 0.0))),
    "force": Signal("force", is_input=True, analog=True, initial=3.5, changes=((1.0, -2.0),)),
    "vacuum": Signal("vacuum", is_input=False, initial=1.0),
}


def test_an_input_has_its_initial_value_until_the_first_change() -> None:
    sensors = CellSensors(SIGNALS)
    assert sensors.read("part_ready", 0.999, NothingSensed()) == Sample(value=False, valid=True, age=0.0)
    assert sensors.read("force", 0.0, NothingSensed()) == Sample(value=3.5, valid=True, age=0.0)


def test_an_input_changes_at_the_very_time_of_its_script() -> None:
    sensors = CellSensors(SIGNALS)
    assert [sensors.read("part_ready", time, NothingSensed()).value for time in (1.0, 2.4, 2.5)] == [
        True,
        True,
        False,
    ]
    assert sensors.read("force", 1.0, NothingSensed()).value == -2.0


def test_on_off_channels_deliver_bool_and_analog_ones_float() -> None:
    sensors = CellSensors(SIGNALS)
    sensors.set_output("vacuum", 0.0)
    assert sensors.read("vacuum", 0.0, NothingSensed()).value is False
    assert isinstance(sensors.read("force", 0.0, NothingSensed()).value, float)


def test_an_output_delivers_what_was_set_last() -> None:
    sensors = CellSensors(SIGNALS)
    assert sensors.read("vacuum", 0.0, NothingSensed()).value is True
    sensors.set_output("vacuum", value=False)
    assert sensors.read("vacuum", 0.0, NothingSensed()).value is False


def test_an_output_that_only_the_program_knows_can_be_read_back() -> None:
    sensors = CellSensors({})
    sensors.set_output("lamp", value=True)
    sensors.set_output("level", 0.25)
    assert sensors.read("lamp", 0.0, NothingSensed()) == Sample(value=True, valid=True, age=0.0)
    assert sensors.read("level", 0.0, NothingSensed()).value == 0.25


def test_a_program_cannot_overwrite_an_input() -> None:
    sensors = CellSensors(SIGNALS)
    sensors.set_output("part_ready", value=True)
    assert sensors.read("part_ready", 0.0, NothingSensed()).value is False


def test_an_unknown_channel_is_not_valid() -> None:
    assert CellSensors(SIGNALS).read("part_redy", 1.0, NothingSensed()).valid is False


def test_two_runs_do_not_share_outputs() -> None:
    first, second = CellSensors(SIGNALS), CellSensors(SIGNALS)
    first.set_output("vacuum", value=False)
    assert second.read("vacuum", 0.0, NothingSensed()).value is True
