"""The key `part` in tools, objects and devices of a cell file."""

import numpy as np
import pytest

from ropsim import collision
from ropsim.cellfile import asked_in_cell_file, meaning_of, read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.kinematics import joint_frames
from ropsim.model import BeltDrive, Cell
from ropsim.parts import PART_KINDS, PartKind, Use, kinds_for, library_part
from ropsim.spatial import Pose

ARM = '[robot]\nmodel = "ur10e"\nbase = { position = [0, 0, 500] }\n'
SIGNAL = "[signals.go]\noutput = 1\n"
HEADS = {
    Use.TOOL: "[tools.a]\n",
    Use.OBJECT: '[[objects]]\nname = "a"\nposition = [2000, 0, 0]\n',
    Use.CONVEYOR: '[devices.a]\nkind = "conveyor"\nspeed = 100\nbase = { position = [2000, 0, 800] }\n',
    Use.TURNTABLE: '[devices.a]\nkind = "turntable"\nsignal = "go"\nspeed = 90\nacceleration = 90\n'
    "step = 90\nbase = { position = [2000, 0, 400] }\n",
}


def found(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "cell")


def right(text: str) -> Cell:
    cell, findings = found(text)
    assert findings == ()
    assert cell is not None
    return cell


def wrong(text: str) -> Diagnostic:
    cell, findings = found(text)
    assert cell is None
    (one,) = findings
    return one


def of_kind(kind: PartKind, keys: str = "") -> str:
    arm = f'{ARM}tool = "a"\n' if kind.use is Use.TOOL else ARM
    return f'{arm}{SIGNAL}{HEADS[kind.use]}part = {{ kind = "{kind.name}"{keys} }}\n'


@pytest.mark.parametrize("kind", PART_KINDS.values(), ids=lambda kind: kind.name)
def test_every_kind_stands_in_a_cell_and_nothing_of_it_collides_with_itself(kind: PartKind) -> None:
    cell = right(of_kind(kind))
    assert not collision.in_collision(cell, cell.first.q_start)
    assert collision.distance(cell, cell.first.q_start).unseen == ()


def test_a_tool_has_all_data_of_its_part() -> None:
    tool = right(
        f'{ARM}tool = "a"\n[tools.a]\npart = {{ kind = "two_finger_gripper", model = "franka_hand" }}\n'
    ).first.tools["a"]
    part = library_part("two_finger_gripper", "franka_hand")
    assert (tool.X_MT, tool.gripper, tool.shapes) == (part.X_MT, part.gripper, part.shapes)
    assert tool.mass == 0.7126
    assert tool.com == pytest.approx(part.load.com)
    assert tool.inertia == pytest.approx(part.load.inertia)


def test_keys_of_the_table_replace_data_of_the_part_one_by_one() -> None:
    part = library_part("two_finger_gripper")
    keys = "position = [0, 0, 200]\nmass = 1.6\ngripper = { close_time = 0.5 }\n"
    tool = right(f'{ARM}tool = "a"\n[tools.a]\npart = {{ kind = "two_finger_gripper" }}\n{keys}').first.tools[
        "a"
    ]
    assert tool.X_MT.position == pytest.approx([0.0, 0.0, 0.2])
    assert tool.mass == 1.6
    assert tool.com == pytest.approx(part.load.com)
    assert tool.inertia == pytest.approx(2.0 * part.load.inertia)
    assert tool.gripper is not None
    assert part.gripper is not None
    assert (tool.gripper.open_time, tool.gripper.close_time) == (0.2, 0.5)
    assert tool.gripper.fingers == part.gripper.fingers
    assert tool.shapes == part.shapes


def test_a_turn_alone_leaves_the_tcp_where_it_is() -> None:
    keys = "rpy = [0, 0, 90]\n"
    tool = right(f'{ARM}tool = "a"\n[tools.a]\npart = {{ kind = "flange" }}\n{keys}').first.tools["a"]
    assert tool.X_MT.position == pytest.approx([0.0, 0.0, 0.012])
    assert tool.X_MT.orientation == pytest.approx([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)])
    assert tool.gripper is None


def test_a_flange_is_a_rigid_part_of_a_tool() -> None:
    keys = 'position = [0, 0, 100]\nparts = [{ name = "f", part = { kind = "flange", mass = 0.3 } }]\n'
    tool = right(f'{ARM}tool = "a"\n[tools.a]\n{keys}').first.tools["a"]
    assert tool.parts[0].load.mass == 0.3
    assert tool.parts[0].shapes == library_part("flange").shapes


def test_parameters_are_in_the_units_of_the_file() -> None:
    text = f'{ARM}[units]\nlength = "m"\n{HEADS[Use.OBJECT]}part = {{ kind = "table", length = 1.5 }}\n'
    text = text.replace("[0, 0, 500]", "[0, 0, 0.5]").replace("[2000, 0, 0]", "[2, 0, 0]")
    assert right(text).objects[0].shapes == library_part("table", length=1.5).shapes


def test_another_colour_is_that_of_the_main_colour_alone() -> None:
    plain = library_part("fence")
    painted = right(of_kind(PART_KINDS["fence"]) + 'colour = "#123456"\n').objects[0].shapes
    changed = [(old, new) for old, new in zip(plain.shapes, painted, strict=True) if old != new]
    assert len(changed) == 4
    assert all(old.colour == plain.colour and new.colour == "#123456" for old, new in changed)


def test_opacity_and_material_are_those_of_the_main_colour_alone() -> None:
    plain = library_part("table")
    seen = right(of_kind(PART_KINDS["table"]) + 'opacity = 0.5\nmaterial = "wood"\n').objects[0].shapes
    changed = [new for old, new in zip(plain.shapes, seen, strict=True) if old != new]
    assert [(one.colour, one.opacity, one.material.value) for one in changed] == [(plain.colour, 0.5, "wood")]


def test_own_shapes_of_an_object_replace_those_of_the_part() -> None:
    cell = right(of_kind(PART_KINDS["table"]) + "size = [100, 100, 100]\n")
    assert len(cell.objects[0].shapes) == 1


def test_a_belt_is_as_long_as_its_part() -> None:
    device = right(of_kind(PART_KINDS["belt_conveyor"], ", length = 3000")).devices["a"]
    assert isinstance(device.drive, BeltDrive)
    assert device.drive.length == pytest.approx(3.0)
    assert device.mechanism.base_shapes == library_part("belt_conveyor", length=3.0).shapes


def test_a_turntable_has_a_plate_that_turns_and_a_drum_that_stands() -> None:
    mechanism = right(of_kind(PART_KINDS["turntable"])).devices["a"].mechanism
    part = library_part("turntable")
    assert (mechanism.links[0].shapes, mechanism.base_shapes) == (part.moving_shapes, part.shapes)


@pytest.mark.parametrize(
    ("kind", "place", "size"),
    [
        ("eur_pallet", (2000, 0, 144), (300, 200, 100)),
        ("eur_pallet", (2527, 327, 144), (140, 140, 100)),
        ("table", (2000, 0, 850), (300, 200, 100)),
        ("belt_conveyor", (2300, 0, 800), (300, 200, 100)),
        ("roller_conveyor", (2300, 0, 800), (300, 200, 100)),
        ("turntable", (2100, 100, 400), (300, 200, 100)),
    ],
)
def test_a_part_lies_on_it(kind: str, place: tuple[int, int, int], size: tuple[int, int, int]) -> None:
    x, y, z = place
    box = f'[[parts]]\nname = "box"\nsize = {list(size)}\nmass = 1\nposition = [{x}, {y}, {z + size[2]}]\n'
    right(of_kind(PART_KINDS[kind]) + box)
    _, findings = found(of_kind(PART_KINDS[kind]) + box.replace(f"{z + size[2]}]", f"{z + size[2] + 20}]"))
    assert [one.code for one in findings] == ["X819"]


@pytest.mark.parametrize(
    ("part", "code", "words", "hint"),
    [
        ('{ kind = "fense" }', "X808", "is `fense`", "did you mean `fence`?"),
        ('{ kind = "fence", lenght = 3000 }', "X802", "lenght` has no meaning", "did you mean `length`?"),
        ('{ kind = "fence", height = 9000 }', "X806", "is 9000 mm, allowed is 300 to 4000 mm", "units"),
        ('{ kind = "fence", model = "x" }', "X802", "model` has no meaning", "known here"),
        ('{ kind = "eur_pallet", model = "eur1" }', "X808", "is `eur1`", "did you mean `eur_1`?"),
        ('{ kind = "flange" }', "X923", "part for a tool, and not for an object", "`eur_pallet`"),
        ("{ }", "X803", "needs `kind`", '"fence"'),
        ('{ kind = "" }', "X808", "is ``, allowed are `fence`", ""),
        ('{ kind = "eur_pallet", model = "" }', "X808", "is ``, allowed are `eur_1`", ""),
        ("3", "X804", "is a whole number", ""),
        ('{ kind = "table", width = "wide" }', "X804", "is text", ""),
    ],
)
def test_a_wrong_part_of_an_object_is_one_finding(part: str, code: str, words: str, hint: str) -> None:
    one = wrong(f"{ARM}{HEADS[Use.OBJECT]}part = {part}\n")
    assert (one.code, one.span.line if one.span else 0) == (code, 7)
    assert words in one.message
    assert hint in one.hint


def test_two_parameters_that_do_not_fit_are_one_finding() -> None:
    one = wrong(of_kind(PART_KINDS["vacuum_gripper"], ", cup_diameter = 100, cups_x = 2"))
    assert one.code == "X924"
    assert one.message.endswith("is 100 mm, above `pitch`, which is 80 mm")


def test_a_single_cup_may_be_larger_than_the_pitch_of_several() -> None:
    right(of_kind(PART_KINDS["vacuum_gripper"], ", cup_diameter = 100"))


def test_measures_of_a_belt_stand_in_its_part_alone() -> None:
    one = wrong(of_kind(PART_KINDS["belt_conveyor"]) + "length = 1000\n")
    assert one.code == "X812"
    assert one.hint == "write `length` inside `part`"


def test_a_turntable_is_no_conveyor() -> None:
    one = wrong(f'{ARM}{HEADS[Use.CONVEYOR]}part = {{ kind = "turntable" }}\n')
    kinds = ", ".join(f"`{kind.name}`" for kind in kinds_for(Use.CONVEYOR))
    assert (one.code, one.hint) == ("X923", f"for a device of the kind `conveyor`: {kinds}")
    assert "`belt_conveyor`" in one.hint


@pytest.mark.parametrize("kind", PART_KINDS.values(), ids=lambda kind: kind.name)
def test_every_parameter_has_a_form_and_a_meaning_for_the_editor(kind: PartKind) -> None:
    questions, _ = asked_in_cell_file(SourceText("cell.toml", of_kind(kind)))
    path = next(path[:-1] for path in questions if path[-2:] == ("part", "kind"))
    for parameter in kind.parameters:
        question = questions[*path, parameter.name]
        assert question.quantity is not None
        assert meaning_of((*path, parameter.name), question) == parameter.meaning


def test_a_tool_in_front_of_an_adapter_is_moved_as_a_whole() -> None:
    kind = PART_KINDS["two_finger_gripper"]
    tool = right(of_kind(kind, ", position = [10, 0, 30], rpy = [0, 0, 90]")).first.tools["a"]
    part = library_part(kind.name)
    assert part.X_MT is not None
    assert part.gripper is not None
    assert part.gripper.fingers is not None
    assert tool.fingers is not None
    X_MP = Pose(np.array([0.01, 0.0, 0.03]), np.array([1.0, 0.0, 0.0, 1.0]))
    assert tool.X_MT.matrix() == pytest.approx((X_MP @ part.X_MT).matrix())
    assert tool.com == pytest.approx(X_MP.position + X_MP.rotation() @ part.load.com)
    assert np.diag(tool.inertia) == pytest.approx(np.diag(part.load.inertia)[[1, 0, 2]])
    q = np.array([tool.fingers.opened])
    for own, moved in zip(
        joint_frames(part.gripper.fingers.mechanism, q), joint_frames(tool.fingers.mechanism, q), strict=True
    ):
        assert moved == pytest.approx(X_MP.matrix() @ own)
    for old, new in zip(part.shapes, tool.shapes, strict=True):
        assert new.pose.matrix() == pytest.approx((X_MP @ old.pose).matrix())


def test_an_object_has_its_place_outside_of_its_part() -> None:
    one = wrong(of_kind(PART_KINDS["fence"], ", position = [0, 0, 10]"))
    assert (one.code, "position" in one.message) == ("X802", True)


@pytest.mark.parametrize("head", ["[devices.a]\n", "[stations.a.mechanism]\n"])
def test_an_empty_kind_is_a_finding(head: str) -> None:
    one = wrong(f'{ARM}{head}kind = ""\n')
    assert (one.code, "is ``, allowed are" in one.message) == ("X808", True)
