"""NIROX files to robots: units, odd but right files, and every mistake at its line and entity."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.core import Severity, SourceText
from ropsim.kinematics import forward
from ropsim.model import (
    Attribute,
    AuditPlace,
    BacklashGear,
    BallScrew,
    ElasticGear,
    Gear,
    JointType,
    LoadFriction,
    LugreFriction,
    StribeckFriction,
    Transmission,
)
from ropsim.nirox import ReadNirox, nirox_places, nirox_schema, read_nirox, write_nirox
from ropsim.nirox.diagnostics import IMPOSSIBLE, LOST
from ropsim.nirox.readers.seen import MOST, Seen
from ropsim.part21 import read_exchange
from support.nirox_texts import END, HEAD, TEXT, line_of

ROUNDING = 1e-15


def read(text: str) -> ReadNirox:
    return read_nirox(SourceText("arm.stp", text))


def changed(*pairs: tuple[str, str]) -> str:
    text = TEXT
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    return text


MILLIMETRES = (
    ("SI_UNIT($,.METRE.)", "SI_UNIT(.MILLI.,.METRE.)"),
    ("(0.5,0.,0.)", "(500.,0.,0.)"),
    ("(0.3,0.,0.)", "(300.,0.,0.)"),
)
DEGREES = (
    (
        "#2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));",
        "#7=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
        "#8=PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(0.0174532925),#7);\n"
        "#9=DIMENSIONAL_EXPONENTS(0.,0.,0.,0.,0.,0.,0.);\n"
        "#2=(CONVERSION_BASED_UNIT('DEGREE',#8)NAMED_UNIT(#9)PLANE_ANGLE_UNIT());",
    ),
    ("*,-3.,3.)", "*,-180.,90.)"),
    ("#60,0.3)", "#60,45.)"),
)


def test_millimetres_are_converted_as_the_contexts_declare() -> None:
    """Masses stay as they are: what NIROX adds is in SI units whatever the contexts say."""
    found, plain = read(changed(*MILLIMETRES)).robot, read(TEXT).robot
    assert found == plain


def test_degrees_are_converted_and_come_out_as_radians() -> None:
    found = read(changed(*DEGREES))
    assert found.findings == ()
    robot = found.robot
    assert robot is not None
    assert robot.joints[0].lower == -np.pi
    assert (robot.joints[0].upper, robot.home[0]) == (np.pi / 2, np.pi / 4)
    text = write_nirox(robot, found.further).text
    assert "DEGREE" not in text
    assert read(text).robot == robot


def test_each_link_has_the_units_of_its_own_context() -> None:
    inch = (
        "#6=REPRESENTATION_CONTEXT",
        "#7=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.0254),#1);\n#9=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
        "#8=(CONVERSION_BASED_UNIT('INCH',#7)LENGTH_UNIT()NAMED_UNIT(#9));\n#6=REPRESENTATION_CONTEXT",
    )
    arm = ("#4=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))", "#4=(GEOMETRIC_"
           "REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#8,#2))")  # fmt: skip
    robot = read(changed(inch, arm)).robot
    assert robot is not None
    assert forward(robot, np.zeros(2)).position.tolist() == [0.5 * 0.0254 + 0.3, 0.0, 0.0]


def test_a_frame_on_the_moved_link_shifts_all_that_hangs_on_it() -> None:
    """The file describes link `arm` in a frame 100 mm behind its joint, turned by 90 degrees."""
    place = (
        "#43=AXIS2_PLACEMENT_3D('',#45,$,#46);\n"
        "#45=CARTESIAN_POINT('',(0.,0.1,0.));\n#46=DIRECTION('',(0.,1.,0.));"
    )
    robot = read(changed(("#43=AXIS2_PLACEMENT_3D('',#30,$,$);", place))).robot
    assert robot is not None
    # X_JL = (Tz90 at (0, .1, 0))^-1 maps p to (p_y - .1, -p_x)
    assert robot.joints[1].placement.position == pytest.approx([-0.1, -0.5, 0.0], abs=ROUNDING)
    assert robot.links[0].com == pytest.approx([-0.1, -0.25, 0.0], abs=ROUNDING)
    assert np.diag(robot.links[0].inertia) == pytest.approx([0.09, 0.004, 0.09], abs=ROUNDING)


def test_a_joint_may_lead_towards_the_base() -> None:
    """Turned round it moves the other way: the same coordinate has the same effect."""
    turned = changed(
        ("#20=KINEMATIC_JOINT('1',#10,#11)", "#20=KINEMATIC_JOINT('1',#11,#10)"),
        ("'1',*,$,#40,#43", "'1',*,$,#43,#40"),
        ("'1','',$,#50,#51", "'1','',$,#51,#50"),
    )
    robot, plain = read(turned).robot, read(TEXT).robot
    assert robot is not None
    assert plain is not None
    for q in ((0.4, 0.1), (-1.0, 2.0)):
        found, known = forward(robot, np.array(q)), forward(plain, np.array([-q[0], q[1]]))
        assert found.matrix() == pytest.approx(known.matrix(), abs=ROUNDING)


def test_sheth_uicker_parameters_place_a_pair() -> None:
    robot = read(
        changed(("#41=AXIS2_PLACEMENT_3D('',#31,$,$)", "#41=SU_PARAMETERS('',0.2,0.,0.1,0.,0.3,1.)"))
    ).robot
    assert robot is not None
    # with alpha = 0: Rz(1) and Tz(.3 + .1) about and along z, then .2 along x
    expected = [0.2 * np.cos(1.0), 0.2 * np.sin(1.0), 0.4]
    assert robot.joints[1].placement.position == pytest.approx(expected, abs=ROUNDING)


def test_friction_at_the_joint_and_a_screw_go_to_the_motor() -> None:
    text = changed(
        ("COULOMB_VISCOUS_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,$)",
         "STRIBECK_FRICTION(#60,.JOINT_SIDE.,45.,60.,90.,0.05,2.)"),
        ("'g1',100.,1.", "'g1',-100.,0.9"),
        ("#130=IDEAL", "#124=JOINT_ELASTICITY(#61,2.E4,3.);\n#130=IDEAL"),
    )  # fmt: skip
    found = read(text)
    assert found.robot is not None
    first, second = found.robot.drives
    assert first.friction == StribeckFriction(45.0 / 1e4, 0.6, 0.9, 5.0)
    assert first.transmission == Gear(-100.0)
    assert second.transmission == ElasticGear(1.0, 2e4, 3.0)
    assert [one.code for one in found.findings] == ["X953"]
    assert [one.span.line for one in found.findings if one.span] == [line_of(121, text)]


def test_play_counts_where_the_gear_has_a_spring() -> None:
    elastic = ("'g2',1.,1.,0.,$,$,0.", "'g2',1.,1.,0.001,2.E4,3.,0.")
    assert second_gear(changed(elastic)) == (BacklashGear(1.0, 2e4, 3.0, 1e-3), [])
    play = ("'g2',1.,1.,0.,$,$,0.", "'g2',1.,1.,0.001,$,$,0.")
    spring = ("#130=IDEAL", "#124=JOINT_ELASTICITY(#61,2.E4,3.);\n#130=IDEAL")
    assert second_gear(changed(play, spring)) == (BacklashGear(1.0, 2e4, 3.0, 1e-3), [])
    assert second_gear(changed(play)) == (Gear(1.0), ["X953"])


def second_gear(text: str) -> tuple[Transmission, list[str]]:
    """Return the gear of the second drive, and the codes of the findings."""
    found = read(text)
    assert found.robot is not None
    return found.robot.drives[1].transmission, [one.code for one in found.findings]


def test_laws_of_friction_at_the_joint_go_to_the_motor() -> None:
    """Speeds times G, torques over |G|, torques over speeds or angles over G²; a share is none of these."""
    known = "COULOMB_VISCOUS_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,$)"
    for entity, law in (
        ("LUGRE_FRICTION(#60,.JOINT_SIDE.,45.,60.,90.,0.05,3.E5,200.)",
         LugreFriction(45.0 / 1e4, 0.6, 0.9, 5.0, 30.0, 0.02)),
        ("LOAD_DEPENDENT_FRICTION(#60,.JOINT_SIDE.,45.,60.,0.2)", LoadFriction(45.0 / 1e4, 0.6, 0.2)),
        ("LOAD_DEPENDENT_FRICTION(#60,.MOTOR_SIDE.,45.,60.,0.2)", LoadFriction(45.0, 60.0, 0.2)),
    ):  # fmt: skip
        found = read(changed((known, entity)))
        assert found.robot is not None
        assert found.robot.drives[0].friction == law
        assert found.findings == ()


@pytest.mark.parametrize(
    ("entity", "words"),
    [
        ("LUGRE_FRICTION(#60,.JOINT_SIDE.,45.,60.,50.,0.05,3.E5,200.)", "more than `breakaway`"),
        ("LUGRE_FRICTION(#60,.JOINT_SIDE.,45.,0.,50.,0.05,3.E5,200.)", "`coulomb` is 0"),
        ("LOAD_DEPENDENT_FRICTION(#60,.JOINT_SIDE.,45.,60.,1.)", "less than 1"),
    ],
)
def test_friction_that_cannot_be_is_an_error_at_its_entity(entity: str, words: str) -> None:
    text = changed(("COULOMB_VISCOUS_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,$)", entity))
    found = read(text)
    (error,) = [one for one in found.findings if one.is_error]
    assert words in error.message
    assert error.span
    assert error.span.line == line_of(123, text)


def test_a_screw_of_a_drive_turns_once_by_its_lead() -> None:
    """A lead is the way of the joint over the angle of the motor: the motor turns by 1/lead for one of it."""
    screw = ("#131=GEAR_TRANSMISSION('g2',1.,1.,0.,$,$,0.)", "#131=SCREW_TRANSMISSION('g2',0.25,1.)")
    robot = read(changed(screw)).robot
    assert robot is not None
    assert robot.drives[1].transmission == BallScrew(0.25)
    assert robot.drives[1].ratio_at(0.0) == 4.0


def test_masses_are_turned_from_the_frame_of_the_link_into_that_of_its_joint() -> None:
    """The pair lies on the arm turned by φ about z, cos φ = 0.8: in its frame the arm is turned back."""
    turned = ("#43=AXIS2_PLACEMENT_3D('',#30,$,$);",
              "#36=DIRECTION('',(0.8,0.6,0.));\n#43=AXIS2_PLACEMENT_3D('',#30,$,#36);")  # fmt: skip
    robot = read(changed(turned)).robot
    assert robot is not None
    R = np.array([[0.8, -0.6, 0.0], [0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    link = robot.links[0]
    np.testing.assert_allclose(link.inertia, R.T @ np.diag([0.004, 0.09, 0.09]) @ R, rtol=0.0, atol=ROUNDING)
    np.testing.assert_allclose(link.com, R.T @ np.array([0.25, 0.0, 0.0]), rtol=0.0, atol=ROUNDING)


def test_a_thin_rod_has_no_moment_about_its_axis_and_rounding_makes_it_no_mistake() -> None:
    for direction in ([0.6, 0.64, 0.48], [0.48, 0.6, -0.64], [1.0, 2.0, 2.0], [0.3, -0.7, 0.1]):
        along = np.array(direction) / np.linalg.norm(direction)
        rod = 0.09 * (np.eye(3) - np.outer(along, along))
        places = (0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)
        numbers = ",".join(repr(float(rod[place])) for place in places)
        found = read(changed(("(0.004,0.09,0.09,0.,0.,0.)", f"({numbers})")))
        assert found.findings == ()
        assert found.robot is not None


def test_limits_that_are_not_said_are_estimated_and_told() -> None:
    found = read(changed(("$,3.,30.,300.,())", "$,$,$,$,())")))
    assert found.robot is not None
    joint = found.robot.joints[0]
    assert (joint.max_speed, joint.max_acceleration) == (np.pi, np.pi / 0.25)
    assert [one.code for one in found.findings] == ["X955"]
    assert found.robot.origins[-1].kind == "estimated"


def test_numbers_of_a_robot_know_their_lines() -> None:
    place = nirox_places(SourceText("arm.stp", TEXT))
    rows = (
        (Attribute.MASS, 0, 110), (Attribute.INERTIA, 1, 111), (Attribute.MAX_SPEED, 1, 132),
        (Attribute.LIMITS, 1, 61), (Attribute.HOME, 1, 91), (Attribute.PLACEMENT, 1, 41),
    )  # fmt: skip
    for attribute, number, instance in rows:
        span = place(AuditPlace(number, attribute))
        assert span is not None
        assert span.line == line_of(instance)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_exact_orientation_of_a_half_turn_may_have_either_sign(sign: float) -> None:
    """A unit quaternion and its negative are one rotation; without a real part neither is the usual one."""
    turned = (
        "#41=AXIS2_PLACEMENT_3D('',#31,$,$);",
        "#35=DIRECTION('',(0.,0.,-1.));\n#41=AXIS2_PLACEMENT_3D('',#31,#35,$);",
    )
    exact = ("#20=", f"#19=PLACEMENT_ORIENTATION(#41,(0.,{sign},0.,0.));\n#20=")
    found, plain = read(changed(turned, exact)).robot, read(changed(turned)).robot
    assert found is not None
    assert plain is not None
    q = np.array([0.3, -0.6])
    expected = forward(plain, q).matrix()
    np.testing.assert_allclose(forward(found, q).matrix(), expected, rtol=0.0, atol=ROUNDING)


@pytest.mark.parametrize(
    ("pairs", "code", "number", "word"),
    [
        ([("ROPSIM_NIROX_V1", "CONFIG_CONTROL_DESIGN")], "X950", None, "CONFIG_CONTROL_DESIGN"),
        ([("#101=ROBOT_FRAME", "#101=ROBOT_FRAME('x'")], "X960", None, ""),
        ([("(0.004,0.09,0.09,0.", "(0.004,0.09,0.09,0.05")], "X951", 110, "negative moment"),
        ([("#31,$,$)", "#31,#33,#33)")], "X951", 41, "parallel"),
        ([("#20=", "#19=PLACEMENT_ORIENTATION(#41,(0.,1.,0.,0.));\n#20=")], "X951", 19, "orientation"),
        ([("#91=REV", "#92=AXIS_COORDINATE(#61,0.,-2.,$,$);\n#91=REV")], "X951", 92, "`lower`"),
        ([("#91=REV", "#92=AXIS_COORDINATE(#61,0.,$,$,0.5);\n#91=REV")], "X951", 92, "`home`"),
        ([("(0.5,0.,0.)", "(0.5E15,0.,0.)")], "X951", 31, "coordinates"),
        ([("'2',#11,#12", "'2',#13,#12"), ("#12=KIN", "#13=KINEMATIC_LINK('x');\n#12=KIN"),
          ("'arm',(#41,#43),#4,#11", "'arm',(#43),#4,#11"),
          ("#52=RIG", "#53=RIGID_LINK_REPRESENTATION('x',(#41),#4,#13);\n#52=RIG"),
          ("$,#51,#52,#61", "$,#53,#52,#61")], "X951", 21, "no way"),
        ([("GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('arm'",
           "GLOBAL_UNIT_ASSIGNED_CONTEXT((#2))REPRESENTATION_CONTEXT('arm'")], "X952", 4, "no length unit"),
        ([("SI_UNIT($,.METRE.)", "SI_UNIT($,.GRAM.)")], "X952", 1, "not understood"),
        ([("#60,0.3)", "#60,3.5)")], "X857", 90, "home"),
        ([("'2',#11,#12", "'1',#11,#12")], "X830", None, "called `1`"),
    ],
)  # fmt: skip
def test_each_mistake_is_told_at_its_line_and_entity(
    pairs: list[tuple[str, str]], code: str, number: int | None, word: str
) -> None:
    text = changed(*pairs)
    found = read(text)
    assert found.robot is None
    told = next(one for one in found.findings if one.severity is Severity.ERROR)
    assert told.code == code
    assert word in told.message
    if number is not None:
        assert told.span is not None
        assert told.span.line == line_of(number, text)
        assert f"#{number}" in told.message or code.startswith("X8")


def test_all_mistakes_of_a_file_are_told_at_once() -> None:
    text = changed(
        ("#31,$,$)", "#31,#33,#33)"),
        ("(0.004,0.09,0.09,0.", "(0.004,0.09,0.09,0.05"),
        ("'g1',100.", "'g1',1.E-300"),
        ("#130=", "#128=EXTERNAL_AXIS(#61);\n#129=JOINT_COUPLING(#61,2,(),(),(),0.);\n#130="),
    )
    lines = [one.span.line if one.span else 0 for one in read(text).findings]
    assert sorted(lines) == sorted(line_of(number, text) for number in (41, 110, 121, 129))


def test_a_chain_that_is_not_cut_is_told() -> None:
    """The loop of a parallel joint: links 10 and 12 are joined once more, and nothing says where to cut."""
    text = changed(
        ("#25=", "#22=KINEMATIC_JOINT('3',#10,#12);\n#25="),
        ("(#20,#21),#6", "(#20,#21,#22),#6"),
        ("(#40),#3", "(#40,#45),#3"),
        ("(#42,#44),#5", "(#42,#44,#46),#5"),
        ("#50=RIGID", "#45=AXIS2_PLACEMENT_3D('',#30,$,$);\n#46=AXIS2_PLACEMENT_3D('',#30,$,$);\n#50=RIGID"),
        ("#70=PAIR", "#62=REVOLUTE_PAIR('3',*,$,#45,#46,#22,*,*,*,*,*,*);\n"
         "#72=PAIR_REPRESENTATION_RELATIONSHIP('3','',$,#50,#52,#62);\n#70=PAIR"),
        ("(#70,#71)", "(#70,#71,#72)"),
    )  # fmt: skip
    found = read(text)
    assert [(one.code, one.span.line if one.span else 0) for one in found.findings] == [
        ("X951", line_of(22, text))
    ]
    assert "not cut" in found.findings[0].message


def test_a_file_of_nothing_is_told() -> None:
    assert [one.code for one in read("").findings] == ["X960"]
    assert {one.code for one in read(HEAD + END).findings} == {"X970"}


def test_a_prismatic_pair_of_a_file_slides_along_its_x() -> None:
    text = changed(
        ("#61=REVOLUTE_PAIR_WITH_RANGE", "#61=PRISMATIC_PAIR_WITH_RANGE"),
        ("#91=REVOLUTE_PAIR_VALUE", "#91=PRISMATIC_PAIR_VALUE"),
        ("#111=", "#112=LINK_GEOMETRY(#12,'a.stl','',.F.,1.,#44);\n#111="),
    )
    robot = read(text).robot
    assert robot is not None
    assert robot.joints[1].type is JointType.PRISMATIC
    at_rest, moved = (forward(robot, np.array([0.0, q])).position for q in (0.0, 0.2))
    assert moved - at_rest == pytest.approx([0.2, 0.0, 0.0], abs=ROUNDING)
    assert replace(robot) == robot


def test_no_number_of_hints_hides_an_error() -> None:
    file, _ = read_exchange(SourceText("arm.stp", TEXT))
    seen = Seen(nirox_schema(), file)
    for _ in range(2 * MOST):
        seen.note(LOST, 110, "it has no effect")
    before = seen.is_refused
    seen.note(IMPOSSIBLE, 111, "it cannot be")
    assert (before, seen.is_refused) == (False, True)
    assert [one.code for one in seen.findings] == ["X953"] * MOST + ["X951"]
