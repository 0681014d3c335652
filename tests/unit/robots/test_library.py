from collections.abc import Callable
from dataclasses import replace

import pytest

from ropsim import robots
from ropsim.core import RopsimError
from ropsim.model import ControllerKind, ControllerModel, Rates, RobotModel, audit, gain_names
from support.built_in import WRITTEN
from support.dc_drives import dc_motor
from support.gains import cascaded


def test_all_names_load_a_robot_of_that_name() -> None:
    names = robots.names()
    assert {*WRITTEN, "irb120", "kr6_r900_2", "lr_mate_200id", "tx60", "ur5e"} < set(names)
    assert list(names) == sorted(names)
    assert tuple(robots.load(name).name for name in names) == names


def test_rated_payloads_that_makers_publish_are_in_the_models() -> None:
    payloads = {"panda": 3.0, "iiwa14": 14.0, "ur5e": 5.0, "gp25": 25.0, "kr210_r2700_2": 210.0}
    for name, payload in payloads.items():
        robot = robots.load(name)
        assert robot.rated_payload == payload
        assert [one.kind for one in robot.origins if one.parameters == "rated payload"] == ["published"]


def test_a_robot_is_made_once() -> None:
    assert robots.load("puma560") is robots.load("puma560")


def test_an_unknown_name_is_answered_with_a_near_one() -> None:
    with pytest.raises(RopsimError) as caught:
        robots.load("puma650")
    assert caught.value.diagnostic.code == "X860"
    assert caught.value.diagnostic.hint == "did you mean `puma560`?"
    assert "`two_link`" in caught.value.diagnostic.message


@pytest.mark.parametrize("make", [robots.default_controller, robots.cascaded_controller])
def test_the_controllers_of_the_puma_have_gains_for_six_joints(
    make: Callable[[RobotModel, Rates], ControllerModel],
) -> None:
    controller = make(robots.load("puma560"), Rates())
    for name in gain_names(controller.gains):
        gains = getattr(controller.gains, name)
        assert gains.shape == (6,)
        assert (gains > 0.0).all()
    assert (controller.in_position < 1e-3).all()


def test_the_controller_of_a_changed_model_follows_the_model() -> None:
    robot = robots.load("puma560")
    motors = [replace(dc_motor(one), resistance=0.5 * dc_motor(one).resistance) for one in robot.drives]
    drives = tuple(replace(one, motor=motor) for one, motor in zip(robot.drives, motors, strict=True))
    changed_robot = replace(robot, drives=drives)
    own, changed = (robots.cascaded_controller(one, Rates()) for one in (robot, changed_robot))
    assert (cascaded(changed).kv < cascaded(own).kv).all()
    assert (cascaded(changed).ka == 0.5 * cascaded(own).ka).all()


def test_a_robot_without_drives_has_the_ideal_controller() -> None:
    controller = robots.default_controller(replace(robots.load("two_link"), drives=()))
    assert controller.kind is ControllerKind.IDEAL
    assert gain_names(controller.gains) == ()
    assert controller.in_position.shape == (2,)


def test_the_controller_of_an_unknown_robot_is_an_unknown_robot() -> None:
    with pytest.raises(robots.UnknownRobotError):
        robots.default_controller("pumba")


GROUPS = ("mass", "torque", "gear", "friction", "acceleration")
ARMS = sorted({one.name for one in robots.catalogue() if one.maker} - {"patu655"})
"""Arms of makers with motors at their joints."""


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("group", GROUPS)
def test_every_arm_says_where_its_dynamics_are_from(name: str, group: str) -> None:
    found = [one for one in robots.load(name).origins if group in one.parameters]
    assert found


@pytest.mark.parametrize("name", ARMS)
def test_what_no_source_confirms_is_an_input_of_estimates_only(name: str) -> None:
    for one in robots.load(name).origins:
        assert one.kind == "estimated" or "not confirmed" not in one.source


@pytest.mark.parametrize("name", robots.names())
def test_every_group_of_parameters_states_where_it_comes_from(name: str) -> None:
    origins = robots.load(name).origins
    assert {origin.kind for origin in origins} <= {"measured", "published", "derived", "estimated"}
    assert all(len(origin.source) > 10 for origin in origins)
    assert not [finding for finding in audit(robots.load(name)) if finding.is_error]
