"""Estimated masses and drives: what is known stays, torques are enough, origins say what was made."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.core import Diagnostic
from ropsim.dynamics import compiled, greatest_gravity_loads, rotor_inertias
from ropsim.kinematics import configurations
from ropsim.model import (
    ArmClass,
    Coupling,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    IdealMotor,
    Joint,
    Link,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    audit,
    with_payload,
)
from ropsim.robotfile import ArmFacts, TorqueTrust, estimated_dynamics
from ropsim.robotfile.testing import (
    are_stand_ins,
    axis_loads,
    full_accelerations,
    gravity_torques,
    link_masses,
)

ESTIMATES = ("masses", "torque limits", "rotors and gears", "friction", "joint accelerations")


def bare(name: str) -> RobotModel:
    """Return an arm of the library with nothing but axes, limits and speeds."""
    robot = robots.load(name)
    joints: list[Joint] = [replace(joint, max_effort=inf) for joint in robot.joints]
    links = [Link(0.0, np.zeros(3), np.zeros((3, 3)), link.shapes) for link in robot.links]
    guess = ParameterOrigin("joint accelerations and jerks", OriginKind.ESTIMATED, "full speed within 0.25 s")
    return replace(robot, joints=tuple(joints), links=tuple(links), drives=(), origins=(guess,))


def estimated(robot: RobotModel, facts: ArmFacts | None = None) -> RobotModel:
    made = estimated_dynamics(robot, facts or ArmFacts())
    assert not isinstance(made, Diagnostic), made.message
    return made


def words(robot: RobotModel, begin: str) -> ParameterOrigin:
    (found,) = [one for one in robot.origins if one.parameters.startswith(begin)]
    return found


@pytest.mark.parametrize("name", ["irb120", "gp25", "ur5e", "iiwa14", "irb660_180_315", "m10ia_12", "scara"])
def test_an_arm_of_which_only_axes_are_known_gets_masses_and_drives_that_hold_its_payload(name: str) -> None:
    facts = ArmFacts(payload=5.0)
    robot = estimated(bare(name), facts)
    assert len(robot.drives) == robot.n
    assert not [one for one in audit(robot) if one.is_error]
    payload = robot.rated_payload if np.isfinite(robot.rated_payload) else 5.0
    loads = axis_loads(robot, payload)
    assert (loads.greatest_gravity < 0.75 * robot.max_efforts).all()
    for group in ESTIMATES:
        assert words(robot, group).kind is OriginKind.ESTIMATED


@pytest.mark.parametrize("name", ["panda", "kr6_r900_2", "ur10e"])
def test_motors_have_the_torque_limits_of_their_joints(name: str) -> None:
    robot = robots.load(name)
    for drive, most in zip(robot.drives, robot.max_efforts, strict=True):
        assert isinstance(drive.amplifier, EffortAmplifier)
        assert drive.amplifier.max_effort * drive.ratio_at(0.0) == pytest.approx(most)


def test_what_is_known_of_an_arm_stays() -> None:
    known = replace(robots.load("ur5e"), drives=())
    robot = estimated(known, ArmFacts(trust=TorqueTrust.MAKER))
    assert robot.links == known.links
    np.testing.assert_array_equal(robot.max_efforts, known.max_efforts)
    added = [one for one in robot.origins if one not in known.origins]
    assert not [one for one in added if one.kind not in ("estimated", "derived")]


@pytest.mark.parametrize("name", ["iiwa14", "panda", "kr6_r900_2", "irb6640_180_255"])
def test_published_accelerations_stay(name: str) -> None:
    robot = replace(robots.load(name), drives=())
    np.testing.assert_array_equal(estimated(robot).max_accelerations, robot.max_accelerations)
    assert words(robot, "joint accelerations").kind in ("published", "measured")


def test_known_rotors_stay() -> None:
    """Reflected inertias at the joints of the Panda, as Franka gives them for the FR3."""
    robot = robots.load("panda")
    found = rotor_inertias(robot, robot.home[None])[0]
    np.testing.assert_allclose(found[[0, 2, 4]], [0.605721456, 0.462474144, 0.205544064], rtol=1e-9)
    assert words(robot, "rotors and gears").kind is OriginKind.PUBLISHED


@pytest.mark.parametrize("name", ["irb140", "gp7", "irb660_180_315"])
def test_accelerations_are_those_of_nine_tenths_of_the_torque_in_most_postures(name: str) -> None:
    robot = robots.load(name)
    loads = axis_loads(robot, robot.rated_payload)
    rotors = rotor_inertias(robot, robot.home[None])[0]
    allowed = (0.9 * robot.max_efforts - loads.gravity) / (loads.inertia + rotors)
    full = full_accelerations(
        robot, ArmClass.PALLETIZER if robot.couplings and robot.n == 4 else ArmClass.INDUSTRIAL
    )
    assert (robot.max_accelerations <= full * (1.0 + 1e-9)).all()
    free = (robot.max_accelerations < full * (1.0 - 1e-9)) & (robot.max_accelerations > 0.2 * full * 1.001)
    assert free.any()
    shares = (allowed >= robot.max_accelerations * (1.0 - 1e-6)).mean(axis=0)
    np.testing.assert_allclose(shares[free], 0.75, atol=0.01)


def with_limits(robot: RobotModel, *given: float) -> RobotModel:
    joints = [replace(one, max_effort=tau) for one, tau in zip(robot.joints, given, strict=True)]
    return replace(robot, joints=tuple(joints))


def test_a_torque_of_a_file_that_does_not_hold_the_arm_is_replaced_and_both_numbers_are_said() -> None:
    """TX60: its description says 71 N·m for axis 2, of which an arm of 51 kg takes more than all."""
    robot = with_limits(bare("tx60"), 126.0, 71.0, 38.0, 7.0, 8.0, 2.0)
    made = estimated(robot, ArmFacts(total_mass=51.4, payload=3.5))
    origin = words(made, "torque limits")
    assert origin.parameters == "torque limits of J2 (×1.7)"
    assert made.max_efforts[0] == 126.0
    assert made.max_efforts[1] > 100.0
    held = greatest_gravity_loads(with_payload(made, 3.5))[1]
    assert f"do not hold the arm: J2 71 of which gravity takes {held:.4g}" in origin.source


def test_torques_of_a_file_stay_where_they_hold_the_arm_with_its_payload() -> None:
    """UR10e: 330 and 150 N·m (Universal Robots), of which gravity with 10 kg takes 80 and 82 %."""
    robot = replace(robots.load("ur10e"), drives=(), origins=())
    made = estimated(robot)
    np.testing.assert_array_equal(made.max_efforts, robot.max_efforts)
    assert (greatest_gravity_loads(with_payload(made, 10.0)) < made.max_efforts).all()
    assert not [one for one in made.origins if "torque limits" in one.parameters]
    assert "torque of shoulder_lift, elbow:" in words(made, "balance of the arm").source


@pytest.mark.parametrize(
    ("limits", "are"),
    [
        ((1000.0,) * 6, True),
        ((300.0, 300.0, 200.0, 100.0, 100.0, 100.0), True),
        ((54.0, 54.0, inf), True),
        ((330.0, 330.0, 150.0, 56.0), False),
        ((100.0, inf, inf), False),
        ((inf, inf), False),
    ],
)
def test_equal_limits_and_round_hundreds_are_stand_ins(limits: tuple[float, ...], are: bool) -> None:
    assert are_stand_ins(np.array(limits)) is are


def test_a_stand_in_has_to_leave_a_quarter_for_motion() -> None:
    """Gravity takes about 264 N·m of axis 2 of the UR10e with 10 kg: 300 N·m hold it, 88 % of them used."""
    robot = replace(robots.load("ur10e"), drives=())
    made = estimated(with_limits(robot, 300.0, 300.0, 300.0, 100.0, 100.0, 100.0))
    assert made.max_efforts[1] > 300.0
    assert made.max_efforts[2] == 300.0
    kept = estimated(with_limits(robot, 300.0, 300.0, 300.0, 100.0, 100.0, 90.0))
    assert kept.max_efforts[1] == 300.0


def test_a_torque_that_the_maker_stands_for_stays_and_the_arm_is_said_to_be_balanced() -> None:
    """KR 210: gravity with 210 kg stretched out takes more than the torque of axis 2."""
    robot = robots.load("kr210_r2700_2")
    assert robot.max_efforts[1] == 8910.0
    assert axis_loads(robot, 210.0).greatest_gravity[1] > 8910.0
    origin = words(robot, "balance of the arm")
    assert "A2" in origin.source


def test_direct_drives_without_motors_stand_for_no_drives() -> None:
    """URDF has torque limits only; its reader makes them amplifiers at the joints."""
    robot = replace(robots.load("ur5e"), drives=())
    direct = tuple(
        Drive(EffortAmplifier(float(tau)), IdealMotor(0.0), Gear(1.0)) for tau in robot.max_efforts
    )
    assert estimated(replace(robot, drives=direct)) == estimated(robot)


def with_frictions(name: str, *rows: tuple[float, float]) -> RobotModel:
    """Return an arm with dry [N·m] and viscous friction [N·m·s/rad] at its joints, as URDF files give it."""
    robot = replace(robots.load(name), drives=())
    drives = tuple(
        Drive(EffortAmplifier(float(tau)), IdealMotor(0.0), Gear(1.0), Friction(viscous, dry, -dry, 0.01))
        for tau, (dry, viscous) in zip(robot.max_efforts, rows, strict=True)
    )
    origins = tuple(one for one in robot.origins if not one.parameters.startswith("friction"))
    return replace(robot, drives=drives, origins=origins)


def frictions(robot: RobotModel) -> list[tuple[float, float]]:
    """Return dry [N·m] and viscous friction [N·m·s/rad] at the joints."""
    pairs = ((drive.friction, abs(drive.ratio_at(0.0))) for drive in robot.drives)
    return [(one.coulomb_positive * ratio, one.viscous * ratio**2) for one, ratio in pairs]


def friction_words(robot: RobotModel) -> list[tuple[str, str]]:
    return [(one.parameters, one.kind) for one in robot.origins if "friction" in one.parameters]


def test_the_friction_of_a_file_stays() -> None:
    """`dynamics` of a URDF joint: damping 2 N·m·s/rad and friction 3 N·m at the joint."""
    made = estimated(with_frictions("ur5e", *[(3.0, 2.0)] * 6))
    np.testing.assert_allclose(frictions(made), [(3.0, 2.0)] * 6)
    assert friction_words(made) == [("friction", "derived")]


def test_friction_of_a_file_is_known_axis_by_axis_and_kind_by_kind() -> None:
    rule = frictions(estimated(with_frictions("ur5e", *[(0.0, 0.0)] * 6)))
    rows = [(0.0, 0.0)] * 6
    rows[0], rows[2], rows[3] = (0.0, 5.0), (4.0, 6.0), (7.0, 0.0)
    made = estimated(with_frictions("ur5e", *rows))
    wanted = [*rule]
    wanted[0], wanted[2], wanted[3] = (rule[0][0], 5.0), (4.0, 6.0), (7.0, rule[3][1])
    np.testing.assert_allclose(frictions(made), wanted)
    names = [joint.name for joint in made.axis_joints]

    def of(*axes: int) -> str:
        return ", ".join(names[axis] for axis in axes)

    assert friction_words(made) == [
        (f"dry friction of {of(2, 3)}", "derived"),
        (f"viscous friction of {of(0, 2)}", "derived"),
        (f"dry friction of {of(0, 1, 4, 5)} (×3)", "estimated"),
        (f"viscous friction of {of(1, 3, 4, 5)} (×3)", "estimated"),
    ]


def test_a_damping_below_a_hundredth_of_the_rule_is_no_measured_friction() -> None:
    """A public URDF file of the Panda has a damping of 0.003 N·m·s/rad and a friction of 0 at all joints."""
    rule = frictions(estimated(with_frictions("panda", *[(0.0, 0.0)] * 7)))
    made = estimated(with_frictions("panda", *[(0.0, 0.003)] * 7))
    np.testing.assert_allclose(frictions(made), rule)
    assert friction_words(made) == [("friction (×3)", "estimated")]
    assert "in the file is below a hundredth of that" in words(made, "friction").source
    with_dry = estimated(with_frictions("panda", *[(1.0, 0.003)] * 7))
    np.testing.assert_allclose(frictions(with_dry), [(1.0, 0.003)] * 7)


def test_an_arm_with_drives_gets_the_torque_limits_that_it_lacks() -> None:
    r3 = robots.load("manutec_r3")
    without = replace(
        r3,
        joints=tuple(replace(one, max_effort=inf) for one in r3.joints),
        drives=tuple(replace(one, amplifier=EffortAmplifier()) for one in r3.drives),
        origins=tuple(one for one in r3.origins if one.parameters != "torque limits"),
    )
    robot = estimated(without)
    assert words(robot, "torque limits").kind is OriginKind.ESTIMATED
    np.testing.assert_allclose(robot.max_efforts, [1201, 1201, 554, 89.6, 89.6, 53.8], rtol=0.02)
    assert robot.drives[0].motor == IdealMotor(0.0013)


def test_the_total_mass_is_the_one_that_is_given_with_its_source() -> None:
    facts = ArmFacts(total_mass=98.0, mass_source="a scale")
    robot = estimated(bare("irb140"), facts)
    assert sum(link.mass for link in robot.links) == pytest.approx(71.5, rel=0.01)
    assert "98 kg in all (a scale)" in words(robot, "masses").source
    guessed = estimated(bare("irb140"))
    assert "by payload and reach" in words(guessed, "masses").source


def branched() -> RobotModel:
    robot = robots.load("two_link")
    joints = (robot.joints[0], replace(robot.joints[1], parent=-1))
    return replace(robot, joints=joints, drives=(), dh=())


def coupled() -> RobotModel:
    robot = robots.load("two_link")
    return replace(
        robot, axes=(0,), home=robot.home[:1], couplings=(Coupling(1, ((0, 1.0),)),), drives=(), dh=()
    )


@pytest.mark.parametrize(
    ("robot", "said"),
    [
        (robots.load("puma560"), "`puma560` has drives, nothing is to be estimated"),
        (branched(), "`two_link` is neither a serial arm of turning and sliding joints nor a palletizer"),
        (coupled(), "`two_link` is neither a serial arm of turning and sliding joints nor a palletizer"),
        (bare("tx60"), "`tx60` has neither masses nor a rated payload"),
    ],
)
def test_what_cannot_be_estimated_is_reported(robot: RobotModel, said: str) -> None:
    found = estimated_dynamics(robot)
    assert isinstance(found, Diagnostic)
    assert (found.code, found.message) == ("X909", said)


@pytest.mark.parametrize("name", ["scara", "ur10e", "palletizer", "m10ia_12"])
def test_gravity_by_the_potential_energy_is_that_of_the_dynamics(name: str) -> None:
    robot = replace(with_payload(robots.load(name), 3.0), gravity=np.array([1.0, -2.0, -9.0]), drives=())
    functions, rest, tau = compiled(robot, engine=Engine.PYTHON), np.zeros(robot.n), np.empty(robot.n)
    for q in configurations(robot, 5):
        functions.rigid_inverse(q, rest, rest, np.zeros(6), tau)
        np.testing.assert_allclose(gravity_torques(robot, q[None])[0], np.abs(tau), atol=1e-4)


def test_a_palletizer_without_a_known_mass_has_one_by_payload_and_reach() -> None:
    """38·180^0.20·2.89^1.88 = 790 kg: lower arm 1.28, forearm 1.35 and wrist 0.26 m; lists say 1,650 kg."""
    robot = estimated(bare("irb660_180_315"))
    whole = 38.0 * 180.0**0.2 * (1.28 + 1.35 + 0.26) ** 1.88
    assert sum(link.mass for link in robot.links) == pytest.approx(0.81 * whole)


@pytest.mark.parametrize("name", ["irb2400_16", "m10ia_12"])
def test_an_arm_with_a_coupled_axis_keeps_its_crank(name: str) -> None:
    robot = bare(name)
    made = estimated(robot)
    assert (made.axes, made.couplings) == (robot.axes, robot.couplings)
    assert [one.name for one in made.joints] == [one.name for one in robot.joints]
    assert len(made.drives) == 6
    assert [link.mass for link in made.links][6:] == [0.0] * len(made.links[6:])


@pytest.mark.parametrize("name", ["irb460_110_240", "irb660_180_315", "m410ib_700"])
def test_a_palletizer_has_the_shares_of_its_bodies(name: str) -> None:
    """.34 column, .18 lower arm, .15 forearm, .05 crank, .05 rods, .04 wrist and plate of the whole."""
    facts = ArmFacts(total_mass=1000.0)
    robot = estimated(bare(name), facts)
    masses = {joint.name: link.mass for joint, link in zip(robot.joints, robot.links, strict=True)}
    assert (masses["1"], masses["2"], masses["elbow"], masses["3"]) == pytest.approx((340, 180, 150, 50))
    rods = ("rod", "triangle", "lower link", "upper link")
    assert sum(masses[one] for one in rods) == pytest.approx(50.0)
    assert masses["wrist"] + masses["4"] == pytest.approx(40.0)
    lower, rod = (robot.links[k] for k in (1, 7))
    assert np.linalg.norm(rod.com) == pytest.approx(np.linalg.norm(lower.com))  # as long as the lower arm
    gravity = axis_loads(robot, robot.rated_payload).greatest_gravity
    assert robot.max_efforts == pytest.approx(
        [1.4 * gravity[1], 1.4 * gravity[1], 2.0 * gravity[2], 0.09 * 1.4 * gravity[1]]
    )


def partly_massless(name: str, *without: int) -> RobotModel:
    robot = replace(robots.load(name), drives=(), origins=())
    nothing = Link(0.0, np.zeros(3), np.zeros((3, 3)))
    links = tuple(nothing if k in without else link for k, link in enumerate(robot.links))
    return replace(robot, links=links)


def test_links_without_mass_get_theirs_by_rule_and_the_others_keep_it() -> None:
    """Of the UR5e with 20.6 kg: its shares of cobots, 0.855 of them moving."""
    robot = partly_massless("ur5e", 0, 1, 3)
    made = estimated(robot, ArmFacts(total_mass=20.6))
    by_rule = link_masses(ArmClass.COBOT, 6, 20.6).links
    for k, (link, own) in enumerate(zip(made.links, robot.links, strict=True)):
        assert link == own if k not in (0, 1, 3) else link.mass == pytest.approx(by_rule[k])
    origin = words(made, "masses")
    assert origin.parameters == "masses of 3 of 6 links (loads ×12 %)".replace("×", "±")
    assert origin.source.endswith("of the links behind shoulder_pan, shoulder_lift, wrist_1")


def test_an_arm_with_some_masses_and_no_payload_is_refused_by_the_links_without() -> None:
    robot = replace(partly_massless("ur5e", 2), rated_payload=inf)
    found = estimated_dynamics(robot)
    assert isinstance(found, Diagnostic)
    assert "has neither masses of the links behind elbow nor a rated payload" in found.message
