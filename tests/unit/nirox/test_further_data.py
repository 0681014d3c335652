"""What a file says beside its robot is kept and written again, with what it refers to."""

from dataclasses import replace

import numpy as np

from ropsim.core import SourceText
from ropsim.model import Friction, RobotModel
from ropsim.nirox import ReadNirox, read_nirox, write_nirox
from support.nirox_texts import TEXT

FURTHER = """#300=FUTURE_THING('x',#11,(#301,#42),#31);
#301=FUTURE_PART(#60,.BLUE.,LABEL('y'),$);
#302=ROBOT_FRAME('tcp',.TOOL.,#12,#303);
#303=AXIS2_PLACEMENT_3D('',#304,$,$);
#304=CARTESIAN_POINT('',(0.,0.,0.1));
#305=PAYLOAD(#302,1.5,(0.,0.,0.05),(0.01,0.01,0.01,0.,0.,0.));
#306=JOINT_SENSOR(#122,.POSITION.,0.001,$,$,$);
"""
WHOLE = (
    TEXT.replace("#110=", FURTHER + "#110=")
    .replace("(#60,#61),(#101)", "(#60,#61),(#101,#302)")
    .replace("$,3.,30.,300.,()", "$,3.,30.,300.,(#306)")
    .replace("48.,10.,$,$,$", "48.,10.,8.,$,$")
    .replace(
        "#123=COULOMB_VISCOUS_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,$)",
        "#123=STRIBECK_FRICTION(#60,.MOTOR_SIDE.,0.0001,0.02,0.03,0.05,2.)",
    )
)


def read(text: str) -> ReadNirox:
    return read_nirox(SourceText("arm.stp", text))


def robot_of(found: ReadNirox) -> RobotModel:
    assert found.robot is not None, found.findings
    return found.robot


def test_entities_that_nobody_knows_and_those_without_effect_are_kept_and_told() -> None:
    found = read(WHOLE)
    text = write_nirox(robot_of(found), found.further).text
    assert read(text).robot == found.robot
    for word in (
        "=FUTURE_THING('x',#",
        ",.BLUE.,LABEL('y'),$)",
        "=PAYLOAD(#",
        "('tcp',.TOOL.",
        ".POSITION.,0.001",
    ):
        assert text.count(word) == 1
    assert "48.,10.,8.,$,$" in text
    assert "0.0001,0.02,0.03,0.05,2." in text
    codes = sorted(one.code for one in found.findings)
    assert codes == ["X953", "X953", "X953", "X954"]
    assert any("`FUTURE_THING`, `FUTURE_PART`" in one.message for one in found.findings)


def test_what_is_kept_is_written_in_the_same_way_ever_after() -> None:
    first = read(WHOLE)
    text = write_nirox(robot_of(first), first.further).text
    second = read(text)
    assert write_nirox(robot_of(second), second.further).text == text


def test_kept_entities_refer_to_the_same_things_as_before() -> None:
    text = write_nirox(robot_of(read(WHOLE)), read(WHOLE).further).text
    lines = dict(line.split("=", 1) for line in text.splitlines() if line.startswith("#"))
    (thing,) = [value for value in lines.values() if value.startswith("FUTURE_THING")]
    link, part, placement, point = (
        thing.removeprefix("FUTURE_THING('x',").rstrip(");").replace("(", "").replace(")", "").split(",")
    )
    assert lines[link] == "KINEMATIC_LINK('arm');"
    assert lines[part].startswith("FUTURE_PART(")
    assert lines[placement].startswith("AXIS2_PLACEMENT_3D")
    assert lines[point] == "CARTESIAN_POINT('',(0.5,0.,0.));"


def test_further_frames_go_with_the_units_of_their_representation() -> None:
    text = WHOLE.replace("SI_UNIT($,.METRE.)", "SI_UNIT(.MILLI.,.METRE.)").replace(
        "(#42,#44),#5", "(#42,#44,#303),#5"
    )
    found = read(text)
    assert found.further.frames[0].X_LF.position.tolist() == [0.0, 0.0, 0.1 / 1000.0]
    assert "(0.,0.,0.0001)" in write_nirox(robot_of(found), found.further).text


def test_what_a_changed_robot_no_longer_has_is_told_as_lost() -> None:
    found = read(WHOLE)
    robot = robot_of(found)
    short = replace(
        robot, joints=robot.joints[:1], links=robot.links[:1], drives=(), axes=(0,), home=np.zeros(1), tip=0
    )
    written = write_nirox(short, found.further)
    assert [one.code for one in written.losses] == ["X953"]
    assert "JOINT_SENSOR" in written.losses[0].message
    assert read(written.text).robot == short


def test_changed_numbers_win_over_what_the_file_said() -> None:
    found = read(WHOLE)
    robot = robot_of(found)
    drive = replace(robot.drives[0], friction=Friction(2e-4, 0.02, -0.02))
    changed = replace(robot, title="Another", drives=(drive, robot.drives[1]))
    text = write_nirox(changed, found.further).text
    assert "STRIBECK" not in text
    assert "ROBOT_ARM('two_links','','Another'," in text
    assert robot_of(read(text)).drives[0].friction == drive.friction


def test_what_was_read_is_compared_by_content() -> None:
    assert read(WHOLE) == read(WHOLE.replace("/* units", "/* the units"))
    assert read(WHOLE).further != read(WHOLE.replace("LABEL('y')", "LABEL('z')")).further


def test_many_unknown_entities_hide_no_mistake() -> None:
    many = "".join(f"#{number}=FUTURE_THING(#11);\n" for number in range(400, 500))
    assert read(TEXT.replace("#110=", many + "#110=")).robot == read(TEXT).robot
    found = read(TEXT.replace("#110=", many + "#110=").replace("#11,4.,", "#11,-4.,"))
    assert [one.code for one in found.findings] == ["X970"]


def test_friction_of_which_nothing_is_held_is_kept_all_the_same() -> None:
    second = "#124=COULOMB_VISCOUS_FRICTION(#60,.JOINT_SIDE.,1.,0.,$);\n#130="
    found = read(TEXT.replace(".MOTOR_SIDE.,0.0001,0.02,$", ".MOTOR_SIDE.,0.,0.,$").replace("#130=", second))
    assert robot_of(found).drives[0].friction == Friction()
    assert write_nirox(robot_of(found), found.further).text.count("=COULOMB_VISCOUS_FRICTION(#") == 1


def test_the_first_mechanical_interface_is_the_flange_and_a_second_one_is_kept() -> None:
    found = read(WHOLE.replace("('tcp',.TOOL.", "('tcp',.MECHANICAL_INTERFACE."))
    assert robot_of(found).X_nM.position.tolist() == [0.3, 0.0, 0.0]
    assert [(one.name, one.role) for one in found.further.frames] == [("tcp", "mechanical_interface")]
