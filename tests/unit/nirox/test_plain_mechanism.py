"""Files of AP242 with a mechanism and without an arm, as CAD systems could write them."""

import numpy as np

from ropsim.core import SourceText
from ropsim.kinematics import forward
from ropsim.nirox import ConformanceClass, ReadNirox, read_nirox, write_nirox
from support.nirox_texts import END, TEXT

SCHEMA = "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 3 1 4 }"
PRODUCT = """#200=PRODUCT('arm','arm','',(#201));
#201=PRODUCT_CONTEXT('',#202,'mechanical');
#202=APPLICATION_CONTEXT('managed model based 3d engineering');
#203=KINEMATIC_LINK_REPRESENTATION_ASSOCIATION('','',#51,#204);
#204=SHAPE_REPRESENTATION('arm',(#43),#4);
#205=MEASURE_WITH_UNIT(MASS_MEASURE(4.),#206);
#206=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.));
"""
PLAIN = TEXT.partition("/* what NIROX adds */")[0].replace("ROPSIM_NIROX_V1", SCHEMA) + PRODUCT + END
HINTS = ["X972", "X955", "X955", "X954"]
"""There are no masses, limits of motion are estimated for both axes, entities of products are kept."""


def read(text: str) -> ReadNirox:
    return read_nirox(SourceText("two_r.stp", text))


def test_a_mechanism_of_ap242_becomes_an_arm_with_its_axes_and_its_state() -> None:
    found = read(PLAIN)
    robot = found.robot
    assert robot is not None, found.findings
    assert [one.code for one in found.findings] == HINTS
    assert (robot.name, robot.n, robot.tip) == ("two links", 2, 1)
    assert robot.home.tolist() == [0.3, -0.6]
    assert robot.joints[1].lower == -2.5
    assert forward(robot, np.array([0.0, 0.0])).position.tolist() == [0.5, 0.0, 0.0]
    assert found.conformance is ConformanceClass.CC1


def test_written_as_nirox_it_keeps_what_it_said_of_products() -> None:
    found = read(PLAIN)
    assert found.robot is not None
    text = write_nirox(found.robot, found.beside).text
    assert "FILE_SCHEMA(('ROPSIM_NIROX_V1'))" in text
    for word in ("=PRODUCT('arm'", "=SHAPE_REPRESENTATION('arm',(#", "MASS_MEASURE(4.)"):
        assert text.count(word) == 1
    again = read(text)
    assert again.robot == found.robot
    assert write_nirox(found.robot, again.beside).text == text


def test_the_base_is_the_one_that_the_file_names() -> None:
    """Called the base, the hand stands still, and both joints lead towards it."""
    found = read(
        PLAIN.replace("#200=", "#210=KINEMATIC_PROPERTY_MECHANISM_REPRESENTATION(#200,#80,#52);\n#200=")
    )
    assert found.robot is not None
    assert [joint.name for joint in found.robot.joints] == ["2", "1"]
    assert [joint.parent for joint in found.robot.joints] == [-1, 0]
    assert [joint.name for joint in found.robot.axis_joints] == ["1", "2"]


def test_without_a_state_it_rests_at_zero_or_the_nearest_limit() -> None:
    text = PLAIN.replace("#95=MECHANISM_STATE_REPRESENTATION('home',(#90,#91),*,#80);\n", "")
    robot = read(text.replace("*,-2.5,2.5)", "*,0.25,2.5)")).robot
    assert robot is not None
    assert robot.home.tolist() == [0.0, 0.25]


def test_files_without_a_mechanism_are_refused() -> None:
    shapes = PLAIN.replace("#80=MECHANISM_REPRESENTATION('two links',(#70,#71),#3,#25);\n", "").replace(
        "*,#80", "*,#25"
    )
    assert [one.code for one in read(shapes).findings] == ["X950"]
    assert [one.code for one in read(PLAIN.replace(SCHEMA, "AUTOMOTIVE_DESIGN")).findings] == ["X950"]


def test_contexts_as_cad_systems_write_them_are_understood() -> None:
    """Millimetres, with an uncertainty and a solid angle."""
    context = (
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#8))"
        "GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#9))REPRESENTATION_CONTEXT("
    )
    plain = "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT("
    units = (
        "#8=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-5),#1,'distance_accuracy_value','');\n"
        "#9=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n#10=KIN"
    )
    assert plain in PLAIN
    text = PLAIN.replace(plain, context).replace("#10=KIN", units).replace("($,.METRE.)", "(.MILLI.,.METRE.)")
    found, same = (
        read(text.replace("(0.5,0.,0.)", "(500.,0.,0.)").replace("(0.3,0.,0.)", "(300.,0.,0.)")),
        read(PLAIN),
    )
    assert found.robot == same.robot
    assert [one.code for one in found.findings] == HINTS
    assert found.robot is not None
    assert "UNCERTAINTY" not in write_nirox(found.robot, found.beside).text
