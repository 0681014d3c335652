"""The rule of the gains of hydraulic arms: the loops that it looks at, and what it leaves of margins."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import law_of
from ropsim.kinematics import configurations
from ropsim.model import (
    ControllerKind,
    Drive,
    ElasticGear,
    FlowGains,
    Gear,
    HydraulicMotor,
    HydraulicVane,
    Payload,
    PiGains,
    Rates,
    RobotModel,
    ValveAmplifier,
)
from ropsim.robots import controller_under, possible_laws
from ropsim.robots.standard_controller import standard_controller
from ropsim.simulation import Margins, linear_loop, margins
from ropsim.spatial import Array
from support.arms import drive
from support.cylinders import CYLINDER, lifted
from support.hydraulic_arm import hydraulic_arm
from support.linkages import SLIDER_CRANK

RATES, NOTHING = Rates(), Payload()
FLOW, PI = ControllerKind.FLOW_LOAD_DAMPING, ControllerKind.PARALLEL_PI
VALVE = {name: getattr(CYLINDER, name) for name in ("supply_pressure", "return_pressure", "bulk_modulus")}
VALVE |= {name: getattr(CYLINDER, name) for name in ("rated_pressure_drop", "rated_input", "damping_ratio")}
MOTOR = HydraulicMotor(1.6e-3, 1e-3, 2e-12, 0.5, rated_flow=6e-4, natural_frequency=500.0, **VALVE)
VANE = HydraulicVane(1.6e-3, 2.2, -0.6, 2e-4, 2e-12, 0.5, rated_flow=6e-4, natural_frequency=500.0, **VALVE)


def _turned(motor: HydraulicMotor | HydraulicVane) -> RobotModel:
    """Return a link that a motor turns without a gear."""
    return lifted(Drive(ValveAmplifier(0.7), motor, Gear(1.0)))


def _worst(robot: RobotModel, kind: ControllerKind, places: Array) -> list[Margins]:
    """Return the margins of all axes at some places, of the law linearised from its own code."""
    controller = controller_under(robot, RATES, kind)
    law = law_of(controller, robot)
    loops = [linear_loop(robot, controller, q, NOTHING, law) for q in places]
    return [margins(loop, axis) for loop in loops for axis in range(robot.n)]


@pytest.mark.parametrize(
    ("robot", "kind", "gain", "sensitivity"),
    [
        (hydraulic_arm(), FLOW, 3.0, 1.5),
        (hydraulic_arm(), PI, 2.4, 1.7),
        (lifted(), FLOW, 3.0, 1.5),
        (lifted(), PI, 2.4, 1.7),
        (_turned(MOTOR), FLOW, 3.0, 1.5),
        (_turned(VANE), FLOW, 3.0, 1.5),
        (_turned(VANE), PI, 2.4, 1.7),
        (_turned(replace(MOTOR, null_flow=2e-5)), FLOW, 3.0, 1.5),
    ],
)
def test_loops_have_their_margins_wherever_the_arm_rests(
    robot: RobotModel, kind: ControllerKind, gain: float, sensitivity: float
) -> None:
    """Places are others than those of the rule, so that a tenth may be missing."""
    for one in _worst(robot, kind, configurations(robot, 40)[27:]):
        assert one.stable
        assert one.gain > 0.9 * gain
        assert one.sensitivity < 1.1 * sensitivity


def test_gains_use_up_a_margin() -> None:
    """Parallel PI loops with half as much again are beyond their bounds at some place of the rule."""
    robot, places = hydraulic_arm(), configurations(hydraulic_arm(), 25)
    controller = controller_under(robot, RATES, PI)
    gains = controller.gains
    assert isinstance(gains, PiGains)
    more = replace(controller, gains=PiGains(1.5 * gains.kp, 1.5 * gains.ki))
    law = law_of(more, robot)
    found = [margins(linear_loop(robot, more, q, NOTHING, law), axis) for q in places for axis in range(2)]
    assert any(not one.stable or one.gain < 2.0 or one.sensitivity > 2.0 for one in found)


def test_axes_with_parallel_pi_loops_lag_alike() -> None:
    """A quarter more of one of both gains pushes the tip farther beside its way, by what lags make of it."""
    gains = robots.parallel_pi_gains(hydraulic_arm(), RATES)
    assert 0.9 < float(gains.kp[1] / gains.kp[0]) < 1.35
    assert gains.ki / gains.kp == pytest.approx(np.full(2, 0.65), rel=0.3)


def test_the_standard_law_of_a_hydraulic_arm_knows_flow_load_and_damping() -> None:
    controller = standard_controller(hydraulic_arm(), RATES)
    assert controller.kind is FLOW
    assert isinstance(controller.gains, FlowGains)
    np.testing.assert_allclose(controller.gains.lead, 2.0 * 0.8 / 628.0 + 0.5e-3, rtol=1e-12)
    assert "damped" in controller.origins[0].source
    assert possible_laws(hydraulic_arm()) == (FLOW, ControllerKind.CASCADED_P_PI, PI)


def test_an_arm_with_other_drives_or_a_closed_chain_has_loops_of_fixed_gains() -> None:
    arm = hydraulic_arm()
    mixed = replace(arm, drives=(arm.drives[0], drive(ratio=120.0)))
    soft = replace(_turned(MOTOR), drives=(Drive(ValveAmplifier(0.7), MOTOR, ElasticGear(1.0, 1e5)),))
    closed = replace(SLIDER_CRANK, drives=_turned(MOTOR).drives)
    assert possible_laws(closed) == (ControllerKind.CASCADED_P_PI,)
    for robot in (mixed, soft):
        assert possible_laws(robot) == (ControllerKind.CASCADED_P_PI,)
        assert standard_controller(robot, RATES).kind is ControllerKind.CASCADED_P_PI
