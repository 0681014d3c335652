"""Files of AP242 with a mechanism and without an arm, as CAD systems could write them."""

import re

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import write_ap242
from ropsim.kinematics import forward, frames_batch
from ropsim.model import RobotModel
from ropsim.nirox import ConformanceClass, ReadNirox, read_nirox, write_nirox
from support.linkages import CRANK, FOUR_BAR, ROD, SLIDER_CRANK
from support.nirox_texts import AP242 as SCHEMA
from support.nirox_texts import PLAIN
from support.nirox_texts import WEIGHED_PLAIN as GIVEN

HINTS = ["X957", "X955", "X955", "X954"]
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
    text = write_nirox(found.robot, found.further).text
    assert "FILE_SCHEMA(('ROPSIM_NIROX_V1'))" in text
    for word in ("=PRODUCT('arm'", "=SHAPE_REPRESENTATION('arm',(#", "MASS_MEASURE(4.)"):
        assert text.count(word) == 1
    again = read(text)
    assert again.robot == found.robot
    assert write_nirox(found.robot, again.further).text == text


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
    assert "UNCERTAINTY" not in write_nirox(found.robot, found.further).text


def test_masses_of_products_are_those_of_their_links_in_their_own_units() -> None:
    found = read(GIVEN)
    assert found.robot is not None, found.findings
    arm, hand = found.robot.links
    assert (arm.mass, hand.mass) == (4.0, 0.0)
    np.testing.assert_allclose(arm.com, [0.1, -0.02, 0.005])
    matrix = [[0.02, -0.001, 5e-4], [-0.001, 0.07, 5e-4], [5e-4, 5e-4, 0.08]]
    np.testing.assert_allclose(arm.inertia, matrix, rtol=1e-14)
    (told,) = [one for one in found.findings if one.code == "X957"]
    assert "`hand`" in told.message
    assert "`arm`" not in told.message


def test_without_units_of_their_own_moments_are_in_those_of_their_context() -> None:
    measure = r"=MEASURE_REPRESENTATION_ITEM\('',NUMERIC_MEASURE\((.*?)\),#260\)"
    robot = read(re.sub(measure, r"=REAL_REPRESENTATION_ITEM('',\1)", GIVEN)).robot
    assert robot is not None
    np.testing.assert_allclose(robot.links[0].inertia[2, 2], 0.08, rtol=1e-14)


def test_what_a_product_does_not_say_of_its_mass_is_told() -> None:
    found = read(GIVEN.replace("#230=PROPERTY_DEFINITION_REPRESENTATION(#220,#231);\n", ""))
    assert found.robot is not None
    assert found.robot.links[0].mass == 4.0
    assert not found.robot.links[0].com.any()
    assert any("without its centre, 0 here" in one.message for one in found.findings)


def test_a_mass_that_no_body_has_is_refused_where_it_stands() -> None:
    text = GIVEN.replace("MASS_MEASURE(4000.)", "MASS_MEASURE(-4000.)")
    (wrong,) = [one for one in read(text).findings if one.is_error]
    assert wrong.code == "X970"
    assert wrong.span is not None
    assert text.splitlines()[wrong.span.line - 1].startswith("#222=")


def test_products_with_masses_are_written_and_read_again_as_nirox() -> None:
    found = read(GIVEN)
    assert found.robot is not None
    text = write_nirox(found.robot, found.further).text
    assert read(text).robot == found.robot


@pytest.mark.parametrize("linkage", [FOUR_BAR, SLIDER_CRANK], ids=["four-bar", "slider-crank"])
def test_a_loop_of_ap242_is_cut_at_its_first_joint_and_its_other_joints_follow_the_next(
    linkage: RobotModel,
) -> None:
    found = read_nirox(SourceText("linkage.stp", write_ap242(linkage).text)).robot
    assert found is not None
    assert (found.axes, found.cuts) == (linkage.axes, linkage.cuts)
    again = read_nirox(SourceText("linkage.stp", write_nirox(found).text)).robot
    assert again == found


def test_a_slider_crank_of_ap242_moves_as_the_textbook_says() -> None:
    found = read_nirox(SourceText("linkage.stp", write_ap242(SLIDER_CRANK).text)).robot
    assert found is not None
    for q in (0.3, 1.2, -0.8):
        x = frames_batch(found, np.array([[q]]))[0, 2, 0, 3]
        assert x == pytest.approx(CRANK * np.cos(q) + np.sqrt(ROD**2 - (CRANK * np.sin(q)) ** 2), abs=1e-9)
