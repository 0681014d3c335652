"""Robots as files: meshes are found again, and no file that was read is replaced."""

import os
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.model import LARGEST_MESH, Mesh
from ropsim.workbench import NamedRobot, find_robot

TETRAHEDRON = """solid t
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 10 0 vertex 10 0 0 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 10 0 0 vertex 0 0 10 endloop endfacet
facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 0 10 vertex 0 10 0 endloop endfacet
facet normal 0 0 1 outer loop vertex 10 0 0 vertex 0 10 0 vertex 0 0 10 endloop endfacet
endsolid
"""


def arm(*meshes: str) -> str:
    """Return a URDF file whose link is drawn by meshes."""
    looks = "".join(f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>' for mesh in meshes)
    return (
        f'<robot name="r"><link name="base"/><link name="tool0">{looks}</link>'
        '<joint name="j" type="revolute"><parent link="base"/><child link="tool0"/><axis xyz="0 0 1"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="10"/></joint></robot>'
    )


def meshes_of(found: NamedRobot) -> list[Path]:
    """Return the mesh files of a robot."""
    assert found.robot is not None
    shapes = [shape.solid for link in found.robot.links for shape in link.shapes]
    return [found.mesh_root / solid.file for solid in shapes if isinstance(solid, Mesh)]


def written(path: Path, text: str = TETRAHEDRON) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    return path


@pytest.mark.parametrize("name", ["robots/a.urdf", "robots/a.xml", "a.urdf", "robots/a.stp", "robots/a.toml"])
def test_meshes_of_a_robot_that_came_in_are_found(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written(tmp_path / "far" / "m.stl")
    source = written(tmp_path / "far" / "arm.urdf", arm("m.stl"))
    (tmp_path / "project").mkdir()
    monkeypatch.chdir(tmp_path / "project")
    assert main(["robot", "import", str(source), "--to", name]) == 0
    (tmp_path / "far" / "m.stl").unlink()
    found = find_robot(name)
    assert [one for one in found.findings if one.code in {"X991", "X995"} and "mesh" in one.message] == []
    (mesh,) = meshes_of(found)
    assert mesh.read_text("utf-8") == TETRAHEDRON
    assert mesh.resolve() == (Path(name).parent / "meshes" / "a" / "m.stl").resolve()


def test_meshes_of_sdformat_count_from_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written(tmp_path / "m.stl")
    source = written(tmp_path / "arm.urdf", arm("m.stl"))
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "import", str(source), "--to", "robots/a.sdf"]) == 0
    assert "<uri>meshes/a/m.stl</uri>" in Path("robots/a.sdf").read_text("utf-8")


def test_meshes_that_stay_in_their_project_count_from_the_file_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written(tmp_path / "geometry" / "m.stl")
    monkeypatch.chdir(tmp_path)
    text = (
        'convention = "standard"\njoints = [{ a = 300, limits = [-90, 90] }]\n'
        'links = [{ shapes = [{ mesh = "geometry/m.stl" }] }]\n'
    )
    written(tmp_path / "robots" / "arm.toml", text)
    assert main(["robot", "export", "robots/arm.toml", "robots/arm.urdf"]) == 0
    assert meshes_of(find_robot("robots/arm.urdf")) == [tmp_path / "geometry" / "m.stl"]
    assert sorted(one.name for one in tmp_path.rglob("*.stl")) == ["m.stl"]


def test_meshes_in_the_folder_for_them_are_not_replaced_by_each_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A robot whose meshes lie in `meshes/arm` and below already; both have one name."""
    other = TETRAHEDRON.replace("10", "20")
    first = written(tmp_path / "robots" / "meshes" / "arm" / "m.stl")
    second = written(tmp_path / "robots" / "meshes" / "arm" / "fine" / "m.stl", other)
    source = written(tmp_path / "robots" / "arm.urdf", arm("meshes/arm/fine/m.stl", "meshes/arm/m.stl"))
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "import", str(source)]) == 0
    assert (first.read_text("utf-8"), second.read_text("utf-8")) == (TETRAHEDRON, other)
    assert meshes_of(find_robot("robots/arm.stp")) == [second, first]


def test_a_link_in_the_place_of_a_mesh_is_replaced_and_not_followed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written(tmp_path / "far" / "m.stl")
    source = written(tmp_path / "far" / "arm.urdf", arm("m.stl"))
    mine = written(tmp_path / "mine.stl", "mine")
    place = tmp_path / "meshes" / "a" / "m.stl"
    place.parent.mkdir(parents=True)
    place.symlink_to(mine)
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "import", str(source), "--to", "a.stp"]) == 0
    assert mine.read_text("utf-8") == "mine"
    assert place.read_text("utf-8") == TETRAHEDRON


@pytest.mark.parametrize("command", ["import", "export", "estimate"])
@pytest.mark.parametrize("spelling", ["same", "dots", "link", "hard link"])
def test_a_robot_does_not_replace_the_file_that_it_is_read_from(
    command: str,
    spelling: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    source = written(tmp_path / "arm.urdf", arm())
    content = source.read_bytes()
    monkeypatch.chdir(tmp_path)
    target = {"same": "arm.urdf", "dots": f"../{tmp_path.name}/arm.urdf"}.get(spelling, "other.urdf")
    if spelling == "link":
        Path(target).symlink_to(source)
    if spelling == "hard link":
        os.link(source, target)
    words = ["robot", command, "arm.urdf", *(["--to"] if command == "import" else []), target]
    assert main([*words, *(["--payload", "2"] if command == "estimate" else [])]) == 2
    assert source.read_bytes() == content
    assert "is the file that is read, and is not replaced" in capsys.readouterr().err


def test_a_robot_does_not_replace_a_file_that_its_file_includes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    part = written(tmp_path / "part.xml", arm().replace("<robot", '<robot xmlns:xacro="x"'))
    content = part.read_bytes()
    written(
        tmp_path / "arm.xacro",
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="part.xml"/></robot>',
    )
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "import", "arm.xacro", "--to", "part.xml"]) == 2
    assert part.read_bytes() == content


def test_another_file_is_replaced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Results of commands replace older ones, as those of `robot show --png` do."""
    written(tmp_path / "arm.urdf", arm())
    monkeypatch.chdir(tmp_path)
    for _ in range(2):
        assert main(["robot", "import", "arm.urdf", "--to", "arm.stp"]) == 0


def test_a_mesh_that_is_too_large_is_named_and_not_copied(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with (tmp_path / "big.stl").open("wb") as stream:
        stream.truncate(LARGEST_MESH + 1)
    written(tmp_path / "arm.urdf", arm("big.stl"))
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "show", "arm.urdf"]) == 0
    assert "the meshes `big.stl` are not drawn: they have more than 50 MB" in capsys.readouterr().err
    assert main(["robot", "import", "arm.urdf", "--to", "robots/a.stp"]) == 0
    assert not Path("robots/meshes").exists()


def test_a_mesh_that_is_too_large_to_be_copied_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = 'convention = "standard"\njoints = [{ a = 300, limits = [-90, 90] }]\n'
    written(tmp_path / "arm.toml", text + 'links = [{ shapes = [{ mesh = "big.stl" }] }]\n')
    with (tmp_path / "big.stl").open("wb") as stream:
        stream.truncate(LARGEST_MESH + 1)
    monkeypatch.chdir(tmp_path)
    assert main(["robot", "export", "arm.toml", "far/a.toml"]) == 2
    said = capsys.readouterr().err
    assert "big.stl" in said
    assert "it has more than 50 MB" in said
    assert not Path("far/a.toml").exists()


def test_a_robot_file_that_is_too_large_is_called_no_program(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with (tmp_path / "arm.urdf").open("wb") as stream:
        stream.truncate(5_000_001)
    assert main(["robot", "show", str(tmp_path / "arm.urdf")]) == 1
    said = capsys.readouterr().err
    assert "has 5.0 MB, at most 5 MB of text are read" in said
    assert "program" not in said
