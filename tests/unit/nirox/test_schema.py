"""The schema of NIROX: read like by another reader, and each seeded fault of a file found where it is."""

import pytest

from ropsim.core import SourceText
from ropsim.express import Population, validate
from ropsim.nirox import nirox_schema, nirox_schema_text
from ropsim.part21 import read_exchange
from support.express_oracle import seen_by_another_reader, seen_by_ours
from support.nirox_texts import TEXT, line_of

ORDER = {  # as AP242 and the manual of NIROX have it
    "revolute_pair_with_range": "name name* description transform_item_1 transform_item_2 joint "
    "t_x* t_y* t_z* r_x* r_y* r_z* lower_limit_actual_rotation upper_limit_actual_rotation",
    "screw_pair": "name name* description transform_item_1 transform_item_2 joint pitch",
    "pair_representation_relationship": "name name description rep_1 rep_2 transformation_operator",
    "mechanism_state_representation": "name items context_of_items* represented_mechanism",
    "oriented_joint": "name edge_start* edge_end* edge_element orientation",
    "su_parameters": "name a alpha b beta c gamma",
    "robot_arm": "name manufacturer model mechanism base axes frames gravity home",
    "drive_train": "name pair motor through driven_by max_speed max_acceleration max_jerk sensors",
    "stribeck_friction": "pair side viscous coulomb breakaway stribeck_velocity exponent",
    "servo_valve": "name supply rated_flow rated_pressure_drop max_input natural_frequency damping_ratio "
    "overlap hysteresis max_slew",
}
HYDRAULICS = """#200=HYDRAULIC_SUPPLY('pump',2.1E7,1.E5,1.2E9,870.);
#201=SERVO_VALVE('v',#200,6.3E-4,7.E6,0.05,630.,0.8,0.,0.,$);
#202=HYDRAULIC_CYLINDER('c',1.26E-3,8.8E-4,0.4,5.E-5,5.E-5,1.E-13,6.5);
#203=LINKAGE_TRANSMISSION('k',#11,(0.1,-0.2,0.),#12,(0.3,-0.1,0.),0.6);
#204=STRIBECK_FRICTION(#61,.JOINT_SIDE.,45.,60.,90.,0.05,2.);
#205=JOINT_SENSOR($,.PRESSURE.,$,$,0.001,$);
"""
WHOLE = TEXT.replace("#140=", HYDRAULICS + "#140=").replace(
    "#132=DRIVE_TRAIN('d2',#61,#130,#131,$,4.,40.,400.,())",
    "#132=DRIVE_TRAIN('d2',#61,#202,#203,#201,4.,40.,400.,(#205))",
)


def told(text: str) -> list[tuple[str, int, str]]:
    """Return code, line and message of what is wrong with a file."""
    file, findings = read_exchange(SourceText("a.stp", text))
    found = (*findings, *validate(Population(nirox_schema(), file)))
    return [(one.code, one.span.line if one.span else 0, one.message) for one in found]


def test_the_schema_has_the_order_of_attributes_of_ap242_and_the_manual() -> None:
    parameters = nirox_schema().parameters
    found = {
        entity: " ".join(f"{one.attribute.name}{'*' if one.derived else ''}" for one in parameters[entity])
        for entity in ORDER
    }
    assert found == ORDER


def test_another_reader_of_express_sees_the_same_schema() -> None:
    assert seen_by_another_reader(nirox_schema_text().text) == seen_by_ours(nirox_schema())


@pytest.mark.parametrize("text", [TEXT, WHOLE], ids=["drives", "hydraulics"])
def test_a_right_file_passes(text: str) -> None:
    assert told(text) == []


@pytest.mark.parametrize(
    ("old", "new", "code", "number", "word"),
    [
        ("#11,4.,(0.25", "#11,-4.,(0.25", "X970", 110, "positive_real.wr1"),
        ("(0.004,0.09,0.09", "(0.004,0.09,0.9", "X970", 110, "rigid_link_mass_properties.wr2"),
        ("(0.004,0.09,0.09", "(-0.004,0.09,0.09", "X970", 110, "rigid_link_mass_properties.wr1"),
        (
            "LINK_MASS_PROPERTIES(#12",
            "LINK_MASS_PROPERTIES(#11",
            "X973",
            111,
            "rigid_link_mass_properties.ur1",
        ),
        (".CAD.", ".GUESSED.", "X969", 110, ".IDENTIFIED."),
        ("*,-3.,3.)", "*,3.,-3.)", "X970", 60, "revolute_pair_with_range.wr1"),
        ("'1',#10,#11", "'1',#10,#10", "X970", 20, "kinematic_joint.wr1"),
        ("(#40),#3", "(#40),#4", "X970", 70, "pair_representation_relationship.wr1"),
        ("(#41,#43),#4", "(#41),#4", "X970", 70, "pair_representation_relationship.wr3"),
        ("#40,#43,#20", "#40,#43,#21", "X973", 61, "kinematic_pair.ur1"),
        ("(0.,0.,1.)", "(0.,0.,0.)", "X970", 33, "direction.wr1"),
        ("'g1',100.", "'g1',0.", "X970", 121, "gear_transmission.wr1"),
        ("'g1',100.,1.", "'g1',100.,1.5", "X970", 121, "unit_fraction.wr1"),
        ("'pump',2.1E7,1.E5", "'pump',1.E5,2.1E7", "X970", 200, "hydraulic_supply.wr1"),
        ("#202,#203,#201", "#202,#203,#202", "X969", 132, "servo_valve"),
        ("45.,60.,90.", "45.,60.,50.", "X970", 204, "stribeck_friction.wr1"),
        ("(#60,#61)", "(#60,#60)", "X969", 100, "twice"),
        ("(#101),(0.", "(),(0.", "X972", 100, "robot_arm.doubt1"),
        ("#100=ROBOT_ARM", "#100=ROBOT_ARMS", "X966", 100, "robot_arm"),
        ("48.,10.,$,$,$)", "48.,10.,$,$)", "X968", 120, "11"),
    ],
)
def test_every_seeded_fault_is_found_at_its_line(
    old: str, new: str, code: str, number: int, word: str
) -> None:
    assert old in WHOLE
    text = WHOLE.replace(old, new, 1)
    assert (code, line_of(number, text)) in [one[:2] for one in told(text)]
    assert any(word in one[2] and one[0] == code for one in told(text))


@pytest.mark.parametrize(
    ("old", "new", "rule"),
    [
        (
            "#111=RIGID",
            "#112=EFFECTIVE_LINK_INERTIA(#11,0.,(0.,0.,0.),(0.,0.,0.,0.,0.,0.));\n#111=RIGID",
            "masses",
        ),
        ("#101=ROBOT", "#102=ROBOT_ARM('b','','',#80,#10,(#60),(),(0.,0.,0.),#95);\n#101=ROBOT", "one_arm"),
        ("(#70,#71)", "(#70)", "axes_are_pairs"),
        ("#111=RIGID", "#112=JOINT_LIMITS(#60,9.,$,$,$);\n#111=RIGID", "limits_are_told_once"),
        (
            "#111=RIGID_LINK_MASS_PROPERTIES(#12,2.,(0.15,0.,0.),(0.002,0.02,0.02,0.,0.,0.),.ESTIMATED.);\n",
            "",
            "have",
        ),
        (
            "#25=",
            "#22=ORIENTED_JOINT('',*,*,#20,.T.);\n#23=ORIENTED_JOINT('',*,*,#21,.F.);\n"
            "#24=KINEMATIC_LOOP('',(#22,#23));\n#25=",
            "every_loop_is_cut",
        ),
    ],
)
def test_rules_over_the_whole_file(old: str, new: str, rule: str) -> None:
    assert old in WHOLE
    found = told(WHOLE.replace(old, new, 1))
    assert any(rule in message for _, _, message in found)
