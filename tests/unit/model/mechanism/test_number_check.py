"""Models with numbers that cannot be: each is refused where it is made, by the name of the joint or link."""

from dataclasses import replace
from functools import partial
from math import inf, nan
from typing import Any

import numpy as np
import pytest

from ropsim import dynamics, robots
from ropsim.core import SourceText
from ropsim.exchange import read_mjcf, read_urdf
from ropsim.model import (
    Friction,
    FrictionLaw,
    Joint,
    Link,
    LoadFriction,
    LugreFriction,
    Mechanism,
    ModelValueError,
    Part,
    Payload,
    RobotModel,
    StribeckFriction,
    Tool,
)
from ropsim.robotfile import read_robot_file
from ropsim.spatial import Array, Pose, frozen
from support.cylinders import CYLINDER

ARM = robots.load("two_link")
PUMA = robots.load("puma560")


def with_joint(**changes: Any) -> RobotModel:
    return replace(ARM, joints=(ARM.joints[0], replace(ARM.joints[1], **changes)))


def with_link(**changes: Any) -> RobotModel:
    return replace(PUMA, links=(PUMA.links[0], replace(PUMA.links[1], **changes), *PUMA.links[2:]))


def refused(make: Any, **changes: Any) -> tuple[str, str]:
    """Return code and message with which a model is refused."""
    with pytest.raises(ModelValueError) as caught:
        make(**changes)
    found = caught.value.diagnostic
    assert found.is_error
    assert found.hint
    return found.code, found.message


@pytest.mark.parametrize(("lower", "upper"), [(1.0, -1.0), (1.0, 1.0), (nan, 1.0), (0.0, nan), (inf, inf)])
def test_reversed_equal_or_missing_limits_are_refused(lower: float, upper: float) -> None:
    code, message = refused(with_joint, lower=lower, upper=upper)
    assert code == "X850"
    assert "joint `2`" in message


@pytest.mark.parametrize("limit", ["max_speed", "max_acceleration", "max_jerk"])
@pytest.mark.parametrize("value", [0.0, -1.0, nan, inf])
def test_limits_of_motion_are_positive_numbers(limit: str, value: float) -> None:
    code, message = refused(with_joint, **{limit: value})
    assert code == "X856"
    assert f"joint `2` has `{limit}` = {value:g}" in message


@pytest.mark.parametrize("value", [0.0, -1.0, nan])
def test_an_effort_limit_may_be_unknown_and_not_zero(value: float) -> None:
    assert with_joint(max_effort=inf).joints[1].max_effort == inf
    assert refused(with_joint, max_effort=value)[0] == "X856"


def test_a_negative_mass_is_refused() -> None:
    code, message = refused(with_link, mass=-1.0)
    assert code == "X851"
    assert "link `2` has a mass of -1 kg" in message


@pytest.mark.parametrize(
    "changes",
    [
        {"mass": nan},
        {"mass": inf},
        {"com": np.array([0.0, nan, 0.0])},
        {"inertia": np.diag([1.0, inf, 1.0])},
    ],
)
def test_link_data_are_finite(changes: dict[str, Any]) -> None:
    assert refused(with_link, **changes)[0] == "X859"


def test_placements_are_finite() -> None:
    assert refused(with_joint, placement=Pose(np.array([inf, 0.0, 0.0])))[0] == "X859"
    assert refused(with_joint, offset=nan)[0] == "X859"


@pytest.mark.parametrize("turn", [0.0, 0.3, 1.2])
def test_a_body_has_no_negative_moment_in_whatever_axes(turn: float) -> None:
    c, s = np.cos(turn), np.sin(turn)
    R = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    code, message = refused(with_link, inertia=R @ np.diag([-0.1, 1.0, 1.0]) @ R.T)
    assert code == "X974"
    assert "-0.1, 1, 1 kg·m²" in message


def test_a_tensor_is_symmetric() -> None:
    skew = PUMA.links[1].inertia + np.array([[0.0, 1e-4, 0.0], [0.0] * 3, [0.0] * 3])
    code, message = refused(with_link, inertia=skew)
    assert code == "X862"
    assert "link `2`" in message


def test_joints_that_no_axis_drives_need_no_limits() -> None:
    loose = replace(ARM.joints[1], lower=-inf, upper=inf, max_speed=inf, max_acceleration=inf, max_jerk=inf)
    made = Mechanism("m", "m", (ARM.joints[0], loose), ARM.links, (), frozen([0.0]), axes=(0,))
    assert made.n == 1


def test_a_mechanism_of_any_kind_is_refused() -> None:
    joint, link = ARM.joints[0], Link(1.0, np.zeros(3), np.eye(3))

    def make(wrong: Joint) -> Mechanism:
        return Mechanism("m", "m", (wrong,), (link,), (), frozen([0.0]))

    assert make(joint).n == 1
    assert refused(make, wrong=replace(joint, max_jerk=inf))[0] == "X856"


@pytest.mark.parametrize(
    ("block", "name", "value"),
    [
        ("amplifier", "max_voltage", 0.0),
        ("amplifier", "max_current", -1.0),
        ("amplifier", "max_voltage", nan),
        ("motor", "rotor_inertia", -1e-6),
        ("motor", "rotor_inertia", nan),
        ("motor", "rotor_inertia", inf),
    ],
)
def test_limits_of_drives_are_positive_and_rotors_weigh_something(
    block: str, name: str, value: float
) -> None:
    first = PUMA.drives[0]
    wrong = replace(first, **{block: replace(getattr(first, block), **{name: value})})
    code, message = refused(partial(replace, PUMA), drives=(wrong, *PUMA.drives[1:]))
    assert code == "X975"
    assert f"axis 1 has `{name}` = {value:g}" in message


@pytest.mark.parametrize(
    "friction",
    [{"viscous": -0.01}, {"viscous": inf}, {"coulomb_positive": -1.0}, {"coulomb_negative": 0.5},
     {"coulomb_negative": -inf}, {"coulomb_positive": nan}],
)  # fmt: skip
def test_friction_resists(friction: dict[str, float]) -> None:
    wrong = replace(PUMA.drives[0], friction=replace(Friction(0.1, 0.2, -0.2), **friction))
    assert refused(partial(replace, PUMA), drives=(wrong, *PUMA.drives[1:]))[0] == "X975"


@pytest.mark.parametrize(
    "law",
    [
        StribeckFriction(0.1, 0.2, 0.3, 0.0),
        StribeckFriction(0.1, 0.2, nan, 1.0),
        StribeckFriction(0.1, 0.2, 0.3, 1.0, exponent=0.0),
        LoadFriction(0.1, -0.2, 0.1),
        LoadFriction(0.1, 0.2, 1.0),
        LoadFriction(0.1, 0.2, -0.1),
        LugreFriction(0.1, 0.2, 0.3, 1.0, 0.0),
        LugreFriction(0.1, 0.2, 0.3, 1.0, 10.0, -1.0),
        LugreFriction(0.1, 0.2, 0.3, 1.0, 10.0, smoothing_speed=0.0),
    ],
)
def test_every_law_of_friction_has_numbers_that_can_be(law: FrictionLaw) -> None:
    wrong = replace(PUMA.drives[0], friction=law)
    assert refused(partial(replace, PUMA), drives=(wrong, *PUMA.drives[1:]))[0] == "X975"


def test_numbers_of_the_whole_robot_are_finite() -> None:
    make = partial(replace, PUMA)
    assert refused(make, gravity=np.array([0.0, 0.0, nan]))[0] == "X859"
    assert refused(make, home=np.array([nan, *PUMA.home[1:]]))[0] == "X859"
    assert refused(make, X_nM=Pose(np.array([nan, 0.0, 0.0])))[0] == "X859"
    assert refused(make, rated_payload=-1.0)[0] == refused(make, rated_payload=nan)[0] == "X856"


@pytest.mark.parametrize(
    ("code", "numbers"),
    [
        ("X851", {"mass": -1.0}),
        ("X859", {"mass": nan}),
        ("X859", {"mass": inf}),
        ("X859", {"com": np.array([0.0, inf, 0.0])}),
        ("X859", {"inertia": np.diag([1.0, nan, 1.0])}),
    ],
)
def test_a_payload_has_a_mass_and_finite_numbers(code: str, numbers: dict[str, Any]) -> None:
    assert refused(Payload, **numbers)[0] == code


@pytest.mark.parametrize(
    ("code", "numbers"),
    [
        ("X851", {"mass": -1.0}),
        ("X859", {"mass": inf}),
        ("X859", {"X_MT": Pose(np.array([nan, 0.0, 0.0]))}),
        ("X859", {"com": np.array([0.0, nan, 0.0])}),
        ("X862", {"inertia": np.array([[1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])}),
        ("X974", {"mass": 1.0, "inertia": np.diag([-1.0, 1.0, 1.0])}),
    ],
)
def test_a_tool_is_a_body(code: str, numbers: dict[str, Any]) -> None:
    found, message = refused(partial(Tool, "jaws"), **numbers)
    assert found == code
    assert "tool `jaws`" in message


@pytest.mark.parametrize(
    ("code", "numbers"),
    [
        ("X851", {"mass": -1.0}),
        ("X859", {"mass": nan}),
        ("X859", {"X_WO": Pose(np.array([inf, 0.0, 0.0]))}),
        ("X859", {"size": np.array([0.1, nan, 0.1])}),
    ],
)
def test_a_part_has_a_mass_and_finite_numbers(code: str, numbers: dict[str, Any]) -> None:
    good: dict[str, Any] = {"size": np.full(3, 0.1), "mass": 1.0, "X_WO": Pose()}
    found, message = refused(partial(Part, "box"), **(good | numbers))
    assert found == code
    assert "part `box`" in message


@pytest.mark.parametrize(
    ("code", "inertia"),
    [
        ("X862", np.array([[1.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])),
        ("X974", np.diag([-1.0, 1.0, 1.0])),
    ],
)
def test_a_payload_that_no_body_is_has_no_dynamics(code: str, inertia: Array) -> None:
    payload = Payload(1.0, frozen([0.0, 0.0, 0.1]), inertia)
    for function in (dynamics.gravity, dynamics.mass_matrix):
        found, message = refused(partial(function, PUMA, PUMA.home, payload))
        assert found == code
        assert "the payload" in message


@pytest.mark.parametrize(
    ("code", "block", "name", "value"),
    [
        ("X975", "transmission", "ratio", 0.0),
        ("X859", "transmission", "ratio", nan),
        ("X859", "transmission", "ratio", inf),
        ("X859", "motor", "torque_constant", inf),
        ("X859", "motor", "back_emf_constant", nan),
        ("X859", "motor", "resistance", -inf),
        ("X975", "friction", "smoothing_speed", 0.0),
        ("X975", "friction", "smoothing_speed", nan),
    ],
)
def test_constants_of_drives_are_finite_and_gears_turn(
    code: str, block: str, name: str, value: float
) -> None:
    first = PUMA.drives[0]
    wrong = replace(first, **{block: replace(getattr(first, block), **{name: value})})
    found, message = refused(partial(replace, PUMA), drives=(wrong, *PUMA.drives[1:]))
    assert found == code
    assert f"`{name}`" in message


URDF = """<robot name="r"><link name="base"/>
<link name="arm"><inertial><mass value="2"/><inertia ixx="{ixx}" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>
</inertial></link>
<joint name="j" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="10"/></joint></robot>
"""
MJCF = """<mujoco model="r"><worldbody><body name="arm">
<inertial pos="0 0 0" mass="2" diaginertia="{ixx} 1 1"/><joint name="j" range="-1 1"/>
</body></worldbody></mujoco>
"""
TOML = """name = "r"
convention = "standard"
joints = [{{a = 300, limits = [-90, 90], speed = 90}}]
links = [{{mass = 2, inertia = [{ixx}, 1, 1, 0, 0, 0]}}]
"""


@pytest.mark.parametrize(
    ("read", "text"),
    [(read_urdf, URDF), (read_mjcf, MJCF), (read_robot_file, TOML)],
    ids=["urdf", "mjcf", "toml"],
)
def test_readers_refuse_such_a_body_with_its_place(read: Any, text: str) -> None:
    good = read(SourceText("r", text.format(ixx="1")))
    assert good.robot is not None
    bad = read(SourceText("r", text.format(ixx="-1")))
    assert bad.robot is None
    (found,) = [one for one in bad.findings if one.is_error]
    assert found.code == "X974"
    assert found.span is not None
    line = text.splitlines()[found.span.line - 1]
    assert "inertia" in line or '"arm"' in line


@pytest.mark.parametrize(("difference", "code"), [(1e-10, ""), (1e-8, "X862"), (1e-3, "X862")])
def test_a_tensor_may_be_asymmetric_by_the_rounding_of_numbers_only(difference: float, code: str) -> None:
    """The slack is 1e-9 of the largest entry, whatever the size of the body."""
    for size in (1e-6, 1.0, 1e6):
        inertia = size * np.array([[1.0, 0.1 + difference, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 1.0]])
        if code:
            assert refused(with_link, inertia=inertia)[0] == code
        else:
            assert with_link(inertia=inertia).links[1].inertia[0, 1] == inertia[0, 1]


@pytest.mark.parametrize(("least", "code"), [(-5e-4, ""), (-2e-3, "X974"), (-5e-3, "X974")])
def test_a_moment_may_be_negative_by_the_rounding_of_files_only(least: float, code: str) -> None:
    """Files round to three digits: a thousandth of the largest moment, whatever the size of the body."""
    for size in (1e-6, 1.0, 1e6):
        inertia = size * np.diag([1.0, least, 0.5])
        if code:
            assert refused(with_link, inertia=inertia)[0] == code
        else:
            assert with_link(inertia=inertia).links[1].inertia[1, 1] == inertia[1, 1]


def test_moments_that_are_all_negative_are_refused() -> None:
    assert refused(with_link, inertia=-1e-9 * np.eye(3))[0] == "X974"


def test_a_current_without_a_limit_and_a_joint_without_friction_are_possible() -> None:
    first = PUMA.drives[0]
    still = Friction()
    amplifier: Any = first.amplifier
    free = replace(first, amplifier=replace(amplifier, max_current=inf), friction=still)
    assert replace(PUMA, drives=(free, *PUMA.drives[1:])).drives[0] == free


@pytest.mark.parametrize("value", [-0.1, nan, inf])
def test_rod_and_piston_of_a_cylinder_weigh_something(value: float) -> None:
    wrong = replace(PUMA.drives[0], motor=replace(CYLINDER, moving_mass=value))
    code, message = refused(partial(replace, PUMA), drives=(wrong, *PUMA.drives[1:]))
    assert code == "X975"
    assert f"axis 1 has `moving_mass` = {value:g}, allowed is 0 or more" in message
