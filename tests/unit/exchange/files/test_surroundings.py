"""Files around a robot file: beside it, and in packages upwards; nothing else on the disk."""

from pathlib import Path

import pytest

from ropsim.exchange import around_file, in_project
from ropsim.exchange.testing import MOST_DEPTH, MOST_FOLDERS


def package(folder: Path, name: str, **files: str) -> Path:
    """Make a package with files, `_` for `/` in their names."""
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(f"<package><name>{name}</name></package>", "utf-8")
    for file, text in files.items():
        place = folder / file.replace("_", "/")
        place.parent.mkdir(exist_ok=True)
        place.write_text(text, "utf-8")
    return folder


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a home folder with a workspace: an arm, its resources beside it, and another one deeper."""
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    source = tmp_path / "ws" / "src"
    package(source / "maker" / "arm", "arm_support", urdf_arm="arm", meshes_a="mesh")
    package(source / "maker" / "res", "arm_resources", urdf_colours="colours")
    package(source / "other" / "deep" / "tools", "tools", urdf_x="tool")
    (tmp_path / "secret").write_text("secret", "utf-8")
    (source / "maker" / "secret").write_text("secret", "utf-8")
    return source


def texts(file: Path, *names: str, **packages: str) -> list[str | None]:
    folder = around_file(file, packages)
    paths = [folder.path(name) for name in names]
    return [None if path is None else folder.text(path) for path in paths]


def test_files_beside_and_of_packages_upwards_are_read(workspace: Path) -> None:
    names = "arm", "../meshes/a", "package://arm_support/meshes/a", "package://arm_resources/urdf/colours"
    assert texts(workspace / "maker" / "arm" / "urdf" / "arm", *names) == ["arm", "mesh", "mesh", "colours"]
    assert texts(workspace / "maker" / "arm" / "urdf" / "arm", "package://tools/urdf/x") == ["tool"]


@pytest.mark.parametrize(
    "name",
    [
        "../../secret",
        "../../../../secret",
        "package://arm_support/../secret",
        "package://nobody/x",
        "package://secret",
        "file://../../secret",
    ],
)
def test_nothing_outside_of_packages_is_read(workspace: Path, name: str) -> None:
    file = workspace / "maker" / "arm" / "urdf" / "arm"
    absolute = str(workspace / "maker" / "secret")
    assert texts(file, name, absolute, f"file://{absolute}") == [None, None, None]
    folder = around_file(file)
    path = folder.path(name)
    assert path is None or not folder.has(path)


def test_a_link_out_of_a_package_is_not_followed(workspace: Path) -> None:
    (workspace / "maker" / "arm" / "urdf" / "link").symlink_to(workspace / "maker" / "secret")
    assert texts(workspace / "maker" / "arm" / "urdf" / "arm", "link") == [None]


def test_a_given_folder_counts_before_those_that_are_found(workspace: Path) -> None:
    file = workspace / "maker" / "arm" / "urdf" / "arm"
    (workspace / "mine" / "urdf").mkdir(parents=True)
    (workspace / "mine" / "urdf" / "colours").write_text("mine", "utf-8")
    found = texts(file, "package://arm_resources/urdf/colours", arm_resources=str(workspace / "mine"))
    assert found == ["mine"]


def test_without_a_manifest_the_folder_around_is_read_but_never_the_home_folder(
    workspace: Path, tmp_path: Path
) -> None:
    place = tmp_path / "Downloads"
    (place / "robots" / "arm").mkdir(parents=True)
    for name in ("secret", "scene"):
        (place / "robots" / name).write_text(name, "utf-8")
    (place / "secret").write_text("secret", "utf-8")
    assert texts(place / "robots" / "arm" / "arm.xml", "../scene", "../../secret") == ["scene", None]
    assert texts(place / "arm.xml", "secret", "../secret") == ["secret", None]


def test_without_a_manifest_the_folder_of_the_name_is_the_package(workspace: Path) -> None:
    arm = workspace / "plain_description" / "urdf"
    arm.mkdir(parents=True)
    (arm / "arm.urdf").write_text("arm", "utf-8")
    (arm.parent / "mesh").write_text("mesh", "utf-8")
    names = "package://plain_description/mesh", "../mesh", "../../maker/secret"
    assert texts(arm / "arm.urdf", *names) == ["mesh", "mesh", None]


def test_without_a_workspace_two_folders_above_the_package_are_searched(tmp_path: Path) -> None:
    arm = package(tmp_path / "a" / "b" / "c" / "arm", "arm", urdf_arm="arm")
    package(tmp_path / "a" / "b" / "near", "near", urdf_x="near")
    package(tmp_path / "a" / "far", "far", urdf_x="far")
    assert texts(arm / "urdf" / "arm", "package://near/urdf/x", "package://far/urdf/x") == ["near", None]


def test_the_search_ends_below_the_home_folder_and_after_a_number_of_folders(
    workspace: Path, tmp_path: Path
) -> None:
    package(tmp_path / "elsewhere", "elsewhere", urdf_x="x")
    deep = workspace.joinpath(*"abcde"[: MOST_DEPTH + 1])
    package(deep, "too_deep", urdf_x="x")
    file = workspace / "maker" / "arm" / "urdf" / "arm"
    assert texts(file, "package://elsewhere/urdf/x", "package://too_deep/urdf/x") == [None, None]
    for number in range(MOST_FOLDERS + 1):
        (workspace / "maker" / f"a{number:05}").mkdir()
    assert texts(file, "package://tools/urdf/x") == [None]


def test_a_project_reads_its_own_files_only(workspace: Path) -> None:
    project = workspace / "maker"
    folder = in_project(project, "arm/urdf/arm")
    paths = [folder.path(name) for name in ("arm", "package://arm_resources/urdf/colours", "../../secret")]
    assert [path and folder.text(path) for path in paths] == ["arm", "colours", "secret"]
    assert folder.path("../../../other/x") is None
    assert folder.path("package://tools/urdf/x") is None
