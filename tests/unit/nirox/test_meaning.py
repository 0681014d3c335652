"""What the entities of NIROX mean, by small files written by hand: no writer of ours has a part in it."""

from math import pi

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.dynamics import gravity
from ropsim.kinematics import forward
from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    Box,
    Coupling,
    CurrentLimitedAmplifier,
    DhRow,
    Direction,
    EffortAmplifier,
    IdealMotor,
    LoopCut,
    Material,
    Mesh,
    RobotModel,
)
from ropsim.nirox import read_nirox
from ropsim.spatial import Pose
from support.nirox_texts import TEXT

ROUNDING = 1e-15
ONE_AXIS = (  # axis 1 only, the second joint is left to what each test adds
    ("(#60,#61),(#101)", "(#60),(#101)"),
    ("#132=DRIVE_TRAIN('d2',#61,#130,#131,$,4.,40.,400.,());\n", ""),
    ("(#90,#91),*", "(#90),*"),
)


def robot_of(*pairs: tuple[str, str]) -> RobotModel:
    text = TEXT
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    found = read_nirox(SourceText("arm.stp", text))
    assert found.robot is not None, found.findings
    return found.robot


def test_products_of_inertia_are_elements_of_the_tensor_in_the_order_xy_xz_yz() -> None:
    robot = robot_of(("(0.004,0.09,0.09,0.,0.,0.)", "(0.05,0.09,0.08,0.001,-0.002,0.003)"))
    expected = [[0.05, 0.001, -0.002], [0.001, 0.09, 0.003], [-0.002, 0.003, 0.08]]
    assert robot.links[0].inertia.tolist() == expected


def test_masses_weigh_where_they_are() -> None:
    """Gravity along -y here, so that both links act with their levers: 4 kg at .25 m, 2 kg at .5 + .15 m."""
    robot = robot_of(("(0.,0.,-9.81)", "(0.,-10.,0.)"))
    assert gravity(robot, np.zeros(2)) == pytest.approx([10.0 * (1.0 + 1.3), 10.0 * 0.3], abs=ROUNDING * 100)


def test_effective_inertia_may_be_none_of_a_body() -> None:
    robot = robot_of(
        ("RIGID_LINK_MASS_PROPERTIES(#11,4.,", "EFFECTIVE_LINK_INERTIA(#11,0.,"),
        ("(0.004,0.09,0.09,0.,0.,0.),.CAD.", "(0.,0.,0.35,0.,0.,0.)"),
    )
    assert robot.links[0].mass == 0.0
    assert np.diag(robot.links[0].inertia).tolist() == [0.0, 0.0, 0.35]


def test_a_screw_advances_by_its_pitch_in_a_turn() -> None:
    robot = robot_of(
        ("REVOLUTE_PAIR_WITH_RANGE('2',*,$,#41,#44,#21,*,*,*,*,*,*,",
         "SCREW_PAIR_WITH_RANGE('2',*,$,#41,#44,#21,0.01,"),
        ("#91=REVOLUTE", "#91=SCREW"),
    )  # fmt: skip
    assert forward(robot, np.array([0.0, 2.0 * pi])).position == pytest.approx([0.8, 0.0, 0.01], abs=ROUNDING)
    assert robot.joints[1].lead == 0.01


def test_a_coordinate_follows_others_which_are_counted_from_one() -> None:
    robot = robot_of(*ONE_AXIS, ("#130=", "#129=JOINT_COUPLING(#61,1,(#60),(1),(-2.),0.5);\n#130="))
    assert robot.couplings == (Coupling(1, ((0, -2.0),), 0.5),)
    tool = forward(robot, np.array([0.2])).position  # joint 2 stands at -2 * 0.2 + 0.5
    angle = 0.2 - 2.0 * 0.2 + 0.5
    expected = [0.5 * np.cos(0.2) + 0.3 * np.cos(angle), 0.5 * np.sin(0.2) + 0.3 * np.sin(angle), 0.0]
    assert tool == pytest.approx(expected, abs=ROUNDING)


def test_the_coordinate_of_a_controller_is_that_of_the_pair_less_its_offset() -> None:
    robot = robot_of(("#130=", "#129=AXIS_COORDINATE(#61,0.5,$,$,$);\n#130="))
    joint = robot.joints[1]
    assert (joint.offset, joint.lower, joint.upper, robot.home[1]) == (0.5, -3.0, 2.0, -0.6 - 0.5)
    turned = forward(robot, np.array([0.0, -0.5])).position
    assert turned == pytest.approx([0.8, 0.0, 0.0], abs=ROUNDING)


def test_a_loop_is_cut_at_the_pair_that_it_names_and_held_in_what_that_does_not_leave_free() -> None:
    robot = robot_of(
        *ONE_AXIS,
        ("#25=", "#22=KINEMATIC_JOINT('pin',#10,#12);\n#26=ORIENTED_JOINT('',*,*,#22,.T.);\n"
         "#27=ORIENTED_JOINT('',*,*,#21,.F.);\n"
         "#28=ORIENTED_JOINT('',*,*,#20,.F.);\n#29=KINEMATIC_LOOP('',(#26,#27,#28));\n"
         "#24=KINEMATIC_TOPOLOGY_NETWORK_STRUCTURE('',(#29),#6,#25);\n#25="),
        ("(#20,#21),#6", "(#20,#21,#22),#6"),
        ("#3,#25);", "#3,#24);"),
        ("(#40),#3", "(#40,#45),#3"),
        ("(#42,#44),#5", "(#42,#44,#46),#5"),
        ("#50=RIGID", "#45=AXIS2_PLACEMENT_3D('',#31,$,$);\n#46=AXIS2_PLACEMENT_3D('',#32,$,$);\n#50=RIGID"),
        ("#70=PAIR", "#62=REVOLUTE_PAIR('pin',*,$,#45,#46,#22,*,*,*,*,*,*);\n"
         "#72=PAIR_REPRESENTATION_RELATIONSHIP('pin','',$,#50,#52,#62);\n#70=PAIR"),
        ("(#70,#71)", "(#70,#71,#72)"),
        ("#130=", "#129=LOOP_CUT(#29,#62);\n#130="),
    )  # fmt: skip
    held = tuple(one for one in ALL_DIRECTIONS if one is not Direction.ABOUT_Z)
    first, second = Pose(np.array([0.5, 0.0, 0.0])), Pose(np.array([0.3, 0.0, 0.0]))
    assert robot.cuts == (LoopCut(BASE_LINK, first, 1, second, held),)
    assert robot.n == 1


def test_a_table_of_denavit_and_hartenberg_and_external_axes_go_with_their_pairs() -> None:
    robot = robot_of(
        ("#130=", "#127=EXTERNAL_AXIS(#61);\n#128=DENAVIT_HARTENBERG_ROW(#60,0.5,0.1,0.2,0.3);\n#130="),
    )
    assert robot.external == (1,)
    assert robot.dh == (DhRow(0.5, 0.1, 0.2, 0.3),)


def test_amplifiers_limit_the_current_where_they_say_so_and_inertia_at_a_gear_is_that_of_the_rotor() -> None:
    robot = robot_of(
        ("#120,#121,$", "#120,#121,#119"),
        ("#120=DC", "#119=ELECTRIC_AMPLIFIER('a1',.T.);\n#120=DC"),
        ("'g2',1.,1.,0.,$,$,0.", "'g2',1.,1.,0.,$,$,0.05"),
        ("#130=", "#129=JOINT_LIMITS(#61,$,$,$,15.);\n#130="),
    )
    assert robot.drives[0].amplifier == CurrentLimitedAmplifier(48.0, 10.0)
    assert (robot.drives[1].amplifier, robot.drives[1].motor) == (EffortAmplifier(20.0), IdealMotor(0.05))
    assert robot.joints[1].max_effort == 15.0


def test_inertia_at_a_gear_turns_with_the_rotor_and_the_drive_says_the_speed() -> None:
    robot = robot_of(
        ("'g1',100.,1.,0.,$,$,0.", "'g1',100.,1.,0.,$,$,0.0002"),
        ("#130=", "#129=JOINT_LIMITS(#60,9.,$,$,$);\n#130="),
    )
    assert robot.drives[0].motor.rotor_inertia == 0.0001 + 0.0002
    assert robot.joints[0].max_speed == 3.0


def test_links_look_as_the_file_says() -> None:
    robot = robot_of(
        ("#130=", "#124=BOX_ELEMENT(#12,#42,'#aabbcc',0.5,.STEEL.,(0.1,0.2,0.3));\n"
         "#125=LINK_GEOMETRY(#10,'meshes/foot.stl','',.F.,0.001,#40);\n"
         "#126=GEOMETRY_LOOK(#125,'#102030',1.,.RUBBER.);\n#130="),
    )  # fmt: skip
    (box,), (foot,) = robot.links[1].shapes, robot.base_shapes
    assert (box.solid, box.colour, box.opacity, box.material) == (
        Box((0.1, 0.2, 0.3)),
        "#aabbcc",
        0.5,
        Material.STEEL,
    )
    assert box.pose.position.tolist() == [0.3, 0.0, 0.0]
    assert (foot.solid, foot.colour, foot.material) == (
        Mesh("meshes/foot.stl", 0.001),
        "#102030",
        Material.RUBBER,
    )
