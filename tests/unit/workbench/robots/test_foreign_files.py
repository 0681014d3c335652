"""Robots in formats of others: files around them, tip, packages and arguments, by command and in cells."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.cli.testing import main
from ropsim.flow import Fidelity
from ropsim.kinematics import forward
from ropsim.model import Mesh, RobotSource
from ropsim.simulation import RunOptions
from ropsim.workbench import Project, RobotFileError, find_robot, load_robot, new_robot_project, open_project

Printed = pytest.CaptureFixture[str]
HEAD = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
MAIN = f"""{HEAD}
<xacro:arg name="reach" default="0.4"/>
<xacro:include filename="$(find arm_resources)/urdf/links.xacro"/>
<xacro:include filename="hand.xacro"/>
<xacro:arm length="$(arg reach)"/>
<xacro:hand/>
</robot>"""
LINKS = f"""{HEAD}
<xacro:macro name="arm" params="length">
<link name="base"><visual><geometry><mesh filename="package://arm_resources/meshes/part.stl"/></geometry></visual></link>
<link name="upper"><visual><geometry><mesh filename="package://arm_support/meshes/part.stl"/></geometry></visual></link>
<link name="lower"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" velocity="2" effort="50"/></joint>
<joint name="j2" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="${{length}} 0 0.3"/>
<axis xyz="0 1 0"/><limit lower="-2" upper="2" velocity="2" effort="50"/></joint>
</xacro:macro></robot>"""
HAND = f"""{HEAD}<xacro:macro name="hand" params="">
<link name="hand"/><link name="finger"/><link name="other"/>
<joint name="mount" type="fixed"><parent link="lower"/><child link="hand"/><origin xyz="0.2 0 0"/></joint>
<joint name="grip" type="prismatic"><parent link="hand"/><child link="finger"/>
<limit lower="0" upper="0.04" velocity="0.2" effort="20"/></joint>
<joint name="grip2" type="prismatic"><parent link="hand"/><child link="other"/><mimic joint="grip"/>
<limit lower="0" upper="0.04" velocity="0.2" effort="20"/></joint>
</xacro:macro></robot>"""
STL = (
    b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    b"endsolid a\n"
)
MANIFEST = "<package><name>{}</name></package>"


@pytest.fixture
def maker(tmp_path: Path) -> Path:
    """Return the xacro file of an arm in a workspace with a second package, as makers publish them."""
    write(tmp_path / "ws", "arm_support")
    return tmp_path / "ws" / "arm_support" / "urdf" / "arm.xacro"


def write(folder: Path, support: str) -> None:
    """Write the two packages of the arm into a folder."""
    texts = {
        f"{support}/package.xml": MANIFEST.format("arm_support"),
        f"{support}/urdf/arm.xacro": MAIN,
        f"{support}/urdf/hand.xacro": HAND,
        "resources/package.xml": MANIFEST.format("arm_resources"),
        "resources/urdf/links.xacro": LINKS,
    }
    for name, text in texts.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    for name in (f"{support}/meshes/part.stl", "resources/meshes/part.stl"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(STL)


def project(folder: Path, cell: str) -> Project:
    (folder / "programs").mkdir(parents=True, exist_ok=True)
    (folder / "cell.toml").write_text(cell, "utf-8")
    (folder / "programs" / "main.task").write_text("program main\nmov joints(10, 20)\n", "utf-8")
    return ropsim.open(folder)


def test_a_xacro_file_loads_with_the_packages_around_it(maker: Path) -> None:
    robot = load_robot(maker)
    assert robot.n == 2
    np.testing.assert_allclose(forward(robot, [0.0, 0.0]).position, [0.6, 0.0, 0.3], atol=1e-12)
    assert forward(load_robot(maker, tip="lower"), [0.0, 0.0]).position[0] == 0.4
    assert forward(load_robot(maker, arguments={"reach": "1"}), [0.0, 0.0]).position[0] == pytest.approx(1.2)


def test_a_missing_package_is_named_and_can_be_given(maker: Path, tmp_path: Path, capsys: Printed) -> None:
    (maker.parents[2] / "resources").rename(tmp_path / "elsewhere")
    (tmp_path / "elsewhere" / "package.xml").unlink()
    assert main(["robot", "show", str(maker)]) == 1
    assert "arm_resources" in capsys.readouterr().err
    assert main(["robot", "show", str(maker), "--package", f"arm_resources={tmp_path / 'elsewhere'}"]) == 0


def test_the_first_line_names_the_tip_and_why(maker: Path, capsys: Printed) -> None:
    for action in ("show", "audit"):
        main(["robot", action, str(maker)])
        first = capsys.readouterr().out.splitlines()[0]
        assert first == "the tool is carried by `hand`: axes behind it move fingers (another one: --tip LINK)"
    main(["robot", "show", str(maker), "--tip", "finger", "--arg", "reach:=0.5"])
    first, second, *_ = capsys.readouterr().out.splitlines()
    assert "`finger`: as requested" in first
    assert second.endswith("3 axes")


def test_import_copies_what_is_needed_into_a_project(
    maker: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Printed
) -> None:
    (tmp_path / "cell").mkdir()
    monkeypatch.chdir(tmp_path / "cell")
    assert main(["robot", "import", str(maker)]) == 0
    assert "`hand`" in capsys.readouterr().out.splitlines()[0]
    for place in maker.parents[2].rglob("*"):
        if place.is_file():
            place.unlink()  # the project needs nothing of it any more
    made = project(tmp_path / "cell", '[robot]\nmodel = "robots/arm.stp"\n')
    assert made.cell is not None
    robot = made.cell.first.robot
    meshes = [one.solid for one in (*robot.base_shapes, *robot.links[0].shapes)]
    assert meshes == [Mesh("robots/meshes/arm/part.stl"), Mesh("robots/meshes/arm/part_2.stl")]
    assert all((tmp_path / "cell" / one.file).read_bytes() == STL for one in meshes if isinstance(one, Mesh))
    assert made.simulate(options=RunOptions(Fidelity.KINEMATIC)).ok


def test_a_new_project_for_a_foreign_file_stands_alone_and_runs(
    maker: Path, tmp_path: Path, capsys: Printed
) -> None:
    assert main(["new", str(tmp_path / "cell"), "--robot", str(maker), "--arg", "reach=0.5"]) == 0
    assert "`hand`" in capsys.readouterr().out.splitlines()[0]
    for place in maker.parents[2].rglob("*"):
        if place.is_file():
            place.unlink()
    made = ropsim.open(tmp_path / "cell")
    assert made.simulate(options=RunOptions(Fidelity.KINEMATIC)).ok
    assert made.cell is not None
    assert forward(made.cell.first.robot, [0.0, 0.0]).position[0] == pytest.approx(0.7)


def test_a_cell_reads_the_packages_of_its_project_with_its_requests(tmp_path: Path) -> None:
    write(tmp_path / "robots", "support")
    made = project(
        tmp_path,
        '[stations.a]\nrobot = "robots/support/urdf/arm.xacro"\ntip = "lower"\narg = { reach = 0.7 }\n'
        '[stations.b]\nrobot = "robots/support/urdf/arm.xacro"\nbase = { position = [3000, 0, 0] }\n'
        'package = { arm_resources = "robots/resources" }\n',
    )
    assert [one for one in made.diagnostics if one.is_error] == []
    assert made.cell is not None
    reaches = [forward(one.robot, [0.0, 0.0]).position[0] for one in made.cell.stations.values()]
    assert reaches == pytest.approx([0.7, 0.6])


def test_an_included_file_that_changes_is_read_again(tmp_path: Path) -> None:
    write(tmp_path / "robots", "support")
    cell = '[robot]\nmodel = "robots/support/urdf/arm.xacro"\n'
    made = project(tmp_path, cell)
    workspace = made.workspace
    hand = tmp_path / "robots" / "support" / "urdf" / "hand.xacro"
    for text, reach in ((HAND.replace("0.2 0 0", "0.25 0 0"), 0.65), (HAND.replace("0.2 0 0", "1 0 0"), 1.4)):
        hand.write_text(text, "utf-8")
        again = open_project(tmp_path, workspace)
        assert again.cell is not None
        assert forward(again.cell.first.robot, [0.0, 0.0]).position[0] == pytest.approx(reach)


def test_a_package_that_comes_later_is_found(tmp_path: Path) -> None:
    write(tmp_path / "robots", "support")
    (tmp_path / "robots" / "resources").rename(tmp_path.parent / f"{tmp_path.name}_away")
    cell = '[robot]\nmodel = "robots/support/urdf/arm.xacro"\n'
    assert "X992" in [one.code for one in project(tmp_path, cell).diagnostics]
    (tmp_path.parent / f"{tmp_path.name}_away").rename(tmp_path / "robots" / "resources")
    assert [one for one in project(tmp_path, cell).diagnostics if one.is_error] == []


@pytest.mark.parametrize(
    ("keys", "code", "words"),
    [
        ("tip = 3", "X804", "`robot.tip`"),
        ('tip = "hnd"', "X985", "did you mean `hand`"),
        ("arg = { reach = [1] }", "X804", "`robot.arg.reach`"),
        ('arg = "reach"', "X804", "a section"),
        ('package = { arm_resources = "../away" }', "U962", "`../away`"),
        ('tips = "hand"', "X802", "did you mean `tip`"),
    ],
)
def test_mistakes_in_requests_are_findings(tmp_path: Path, keys: str, code: str, words: str) -> None:
    write(tmp_path / "robots", "support")
    found = project(tmp_path, f'[robot]\nmodel = "robots/support/urdf/arm.xacro"\n{keys}\n').diagnostics
    assert any(one.code == code and words in f"{one.message} {one.hint}" for one in found), found


def test_robots_that_name_their_interface_take_no_requests(tmp_path: Path, capsys: Printed) -> None:
    assert main(["robot", "show", "puma560", "--tip", "link6"]) == 2
    assert "error[X922] robot-request-unused: `puma560` takes no `tip`" in capsys.readouterr().err
    main(["robot", "export", "puma560", str(tmp_path / "a.stp")])
    with pytest.raises(RobotFileError, match="takes no `tip` and no `arg`"):
        load_robot(tmp_path / "a.stp", tip="x", arguments={"a": "b"})
    assert {one.code for one in project(tmp_path, '[robot]\nmodel = "scara"\ntip = "x"\n').diagnostics} == {
        "X802"
    }


def test_mjcf_that_includes_a_file_beside_it_loads(tmp_path: Path) -> None:
    joint = '<joint name="j" axis="0 0 1"/><geom size="0.1" mass="1"/>'
    body = f'<worldbody><body name="a">{joint}</body></worldbody>'
    (tmp_path / "a.xml").write_text('<mujoco><include file="b.xml"/></mujoco>', "utf-8")
    (tmp_path / "b.xml").write_text(f"<mujoco>{body}</mujoco>", "utf-8")
    assert load_robot(tmp_path / "a.xml").n == 1


def test_what_is_requested_of_a_file_reaches_a_new_project(maker: Path, tmp_path: Path) -> None:
    new_robot_project(tmp_path / "cell", RobotSource(str(maker), "lower"))
    made = find_robot(tmp_path / "cell" / "robots" / "arm.stp").robot
    assert made is not None
    assert forward(made, [0.0, 0.0]).position[0] == pytest.approx(0.4)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("reech", "has no argument `reech`"),
        ("height", "has no argument `height`"),
    ],
)
def test_an_argument_that_a_file_does_not_have_is_an_error(maker: Path, name: str, words: str) -> None:
    with pytest.raises(RobotFileError, match=words) as error:
        load_robot(maker, arguments={name: "1"})
    assert "reach" in error.value.diagnostic.hint


def test_arguments_of_a_file_without_xacro_are_an_error(maker: Path) -> None:
    place = maker.with_name("plain.urdf")
    place.write_text('<robot name="a"><link name="b"/></robot>', "utf-8")
    with pytest.raises(RobotFileError, match="takes no arguments"):
        load_robot(place, arguments={"reach": "1"})


def test_a_misspelt_argument_is_named_where_its_default_names_a_file(maker: Path) -> None:
    maker.write_text(MAIN.replace('filename="hand.xacro"', 'filename="$(arg reach).xacro"'), "utf-8")
    with pytest.raises(RobotFileError, match="is not there") as error:
        load_robot(maker, arguments={"reech": "hand"})
    assert error.value.diagnostic.hint == "the file has no argument `reech`, did you mean `reach`?"


def test_a_given_package_folder_that_is_not_there_is_an_error(maker: Path, tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match="there is no file or folder") as error:
        load_robot(maker, packages={"arm_resources": str(tmp_path / "nowhere")})
    assert error.value.diagnostic.code == "X840"


def test_a_file_that_an_argument_names_wrongly_is_answered_with_the_arguments(maker: Path) -> None:
    maker.write_text(MAIN.replace('filename="hand.xacro"', 'filename="$(arg reach).xacro"'), "utf-8")
    with pytest.raises(RobotFileError, match=r"`0.4.xacro` is not there") as error:
        load_robot(maker)
    assert "`reach=0.4`" in error.value.diagnostic.hint
    assert "--arg NAME=VALUE" in error.value.diagnostic.hint


@pytest.mark.parametrize("words", [["export"], ["estimate"], ["import"]])
def test_every_written_file_has_its_meshes_beside_it(maker: Path, tmp_path: Path, words: list[str]) -> None:
    weighs = LINKS.replace(
        '<link name="lower"/>',
        '<link name="lower"><inertial><mass value="2"/><inertia ixx="0.1" iyy="0.1" izz="0.1" '
        'ixy="0" ixz="0" iyz="0"/></inertial></link>',
    )
    (maker.parents[2] / "resources" / "urdf" / "links.xacro").write_text(weighs, "utf-8")
    target = tmp_path / "cell" / "robots" / "arm.stp"
    to = ["--to", str(target)] if words == ["import"] else [str(target)]
    if main(["robot", *words, str(maker), *to]) == 0:
        assert load_robot(target).base_shapes[0].solid == Mesh("robots/meshes/arm/part.stl")
        assert (tmp_path / "cell" / "robots" / "meshes" / "arm" / "part.stl").read_bytes() == STL
    else:
        assert words == ["estimate"]
    again = tmp_path / "cell" / "robots" / "again.stp"
    if target.exists():
        assert main(["robot", "export", str(target), str(again)]) == 0
        assert load_robot(again).base_shapes == load_robot(target).base_shapes


@pytest.mark.parametrize(
    ("keys", "marked", "words"),
    [
        ('tip = "hnd"', "tip", "the tip is to be `hnd`"),
        ("arg = { reech = 0.5 }", "reech", "has no argument `reech`"),
        ('package = { arm_resources = "robots/nowhere" }', "arm_resources", "`robots/nowhere`"),
        (
            'package = { arm_resources = "robots/nowhere" }\narg = { reach = 0.5 }',
            "arm_resources",
            "`robots/nowhere`",
        ),
        ('package = { arm_resorces = "robots/resources" }', "arm_resorces", "did you mean `arm_resources`?"),
    ],
)
def test_a_mistake_in_a_request_stands_at_its_key_in_the_cell(
    tmp_path: Path, keys: str, marked: str, words: str
) -> None:
    write(tmp_path / "robots", "support")
    cell = f'[robot]\nmodel = "robots/support/urdf/arm.xacro"\n{keys}\n'
    (found,) = (one for one in project(tmp_path, cell).diagnostics if one.is_error and one.code != "X890")
    assert words in f"{found.message} {found.hint}"
    assert found.span is not None
    assert Path(found.span.source).name == "cell.toml"
    line = cell.splitlines()[found.span.line - 1]
    assert line[found.span.column - 1 :].startswith(marked)
    assert found.label == "in `robots/support/urdf/arm.xacro`"


def test_a_tip_that_is_not_said_stands_at_the_robot_of_the_cell(tmp_path: Path) -> None:
    write(tmp_path / "robots", "support")
    hand = tmp_path / "robots" / "support" / "urdf" / "hand.xacro"
    ends = "".join(
        f'<link name="{name}"/><joint name="to_{name}" type="fixed"><parent link="lower"/>'
        f'<child link="{name}"/><origin xyz="0.1 0 0"/></joint>'
        for name in ("one", "two")
    )
    hand.write_text(f'{HEAD}<xacro:macro name="hand" params="">{ends}</xacro:macro></robot>', "utf-8")
    cell = '[robot]\nmodel = "robots/support/urdf/arm.xacro"\n'
    (found,) = (one for one in project(tmp_path, cell).diagnostics if one.code == "X988")
    assert found.span is not None
    assert (Path(found.span.source).name, found.span.line) == ("cell.toml", 2)


def test_a_package_that_no_file_asks_for_is_named(maker: Path, tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match="asks for no package `arm_resorces`") as error:
        load_robot(maker, packages={"arm_resorces": str(tmp_path)})
    assert error.value.diagnostic.hint == "did you mean `arm_resources`?"


def test_an_argument_is_not_refused_where_a_file_is_missing_before_it(maker: Path) -> None:
    late = MAIN.replace('<xacro:arg name="reach" default="0.4"/>', "")
    late = late.replace(
        '<xacro:include filename="hand', '<xacro:arg name="reach"/><xacro:include filename="gone'
    )
    maker.write_text(late, "utf-8")
    with pytest.raises(RobotFileError, match="is not there") as error:
        load_robot(maker, arguments={"reach": "1", "other": "2"})
    assert "has no argument" not in error.value.diagnostic.hint
