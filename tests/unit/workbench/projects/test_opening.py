"""Opening what is no ordinary project: an answer at once, never an exception of the operating system."""

import os
import shutil
from pathlib import Path

import pytest

from ropsim.userfiles import example_names
from ropsim.workbench import ProjectError, new_project, open_project


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return new_project(tmp_path / "cell")


def code_of(path: str | Path) -> str:
    with pytest.raises(ProjectError) as caught:
        open_project(path).program()
    return caught.value.diagnostic.code


def test_a_name_beyond_what_the_file_system_allows_cannot_be_opened() -> None:
    assert code_of("a" * 5000) == "X841"


def test_a_pipe_is_refused_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "p.task")
    assert code_of(tmp_path / "p.task") == "X841"


def test_a_device_without_end_is_refused_and_not_read(tmp_path: Path) -> None:
    (tmp_path / "z.task").symlink_to("/dev/zero")
    assert code_of(tmp_path / "z.task") == "X841"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_folder_without_permission_is_named(project: Path) -> None:
    programs = project / "programs"
    programs.chmod(0)
    try:
        with pytest.raises(ProjectError, match="programs"):
            open_project(project)
    finally:
        programs.chmod(0o755)


def test_a_task_goes_before_code_that_was_compiled_from_it(project: Path) -> None:
    (project / "programs" / "main.icr").write_text("ICR 1.0 main\nPROC main\n  HALT\nEND\n")
    sources = open_project(project).sources
    assert sources["main"].name.endswith("main.task")
    assert sources["main.icr"].name.endswith("main.icr")


def test_a_program_that_the_cell_file_names_and_that_is_missing_is_told(project: Path) -> None:
    cell = project / "cell.toml"
    cell.write_text(cell.read_text().replace("[cell]\n", '[cell]\nprogram = "mian"\n'))
    with pytest.raises(ProjectError) as caught:
        open_project(project).program()
    found = caught.value.diagnostic
    assert found.code == "X844"
    assert found.span is not None
    assert cell.read_text().splitlines()[found.span.line - 1] == 'program = "mian"'
    assert found.message.startswith("station `robot` runs `mian`: the project has no program `mian`")
    assert open_project(project / "programs" / "main.task").program().source.name.endswith("main.task")


def test_what_a_run_refuses_is_found_by_compiling_alone(project: Path) -> None:
    cell = project / "cell.toml"
    cell.write_text(cell.read_text().replace("[cell]\n", '[cell]\nprogram = "mian"\n'))
    with pytest.raises(ProjectError) as caught:
        open_project(project).programs()
    assert open_project(project).compile().diagnostics == (caught.value.diagnostic,)


def test_a_project_without_a_program_is_told_by_compiling(project: Path) -> None:
    shutil.rmtree(project / "programs")
    (found,) = open_project(project).compile().diagnostics
    assert (found.code, found.span.line if found.span else 0) == ("X844", 7)
    assert found.message.endswith("it has none")


@pytest.mark.parametrize(("kind", "code"), [("link", "X840"), ("pipe", "X841"), ("device", "U962")])
def test_a_program_that_is_no_ordinary_file_is_told_and_not_left_out(
    project: Path, kind: str, code: str
) -> None:
    program = project / "programs" / "main.task"
    program.unlink()
    if kind == "pipe":
        os.mkfifo(program)
    else:
        program.symlink_to("nowhere" if kind == "link" else os.devnull)
    (found,) = open_project(project).compile().diagnostics
    assert found.code == code_of(project) == code
    assert ("is a link, and what it leads to is not there" in found.message) == (kind == "link")


def test_the_lock_of_an_editor_and_a_folder_are_no_programs(project: Path) -> None:
    (project / "programs" / ".#main.task").symlink_to("somebody@somewhere.1234")
    (project / "programs" / "old.task").mkdir()
    opened = open_project(project)
    assert (list(opened.sources), opened.compile().diagnostics) == (["main"], ())


def test_the_only_program_runs_where_none_is_named(project: Path) -> None:
    (project / "programs" / "main.task").rename(project / "programs" / "other.task")
    assert open_project(project).program().source.name.endswith("other.task")


def test_a_project_can_be_made_in_the_empty_folder_one_stands_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    new_project(".")
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["cell.toml", "programs"]
    assert open_project(".").program().icr is not None


@pytest.mark.parametrize("place", ["a" * 300, "taken/x"])
def test_a_project_that_cannot_be_made_leaves_nothing(tmp_path: Path, place: str) -> None:
    (tmp_path / "taken").write_text("a file")
    with pytest.raises(ProjectError) as caught:
        new_project(tmp_path / place, example_names()[0])
    assert caught.value.diagnostic.code == "X849"
    assert [entry.name for entry in tmp_path.iterdir()] == ["taken"]


def test_a_copy_of_a_project_elsewhere_is_the_same_project(project: Path, tmp_path: Path) -> None:
    link = tmp_path / "link"
    link.symlink_to(project, target_is_directory=True)
    copy = shutil.copytree(project, tmp_path / "copy")
    assert open_project(link).program().icr is not None
    assert open_project(copy).program().icr is not None


def test_a_station_whose_program_has_no_text_is_told_at_its_place(project: Path) -> None:
    (project / "cell.toml").write_text(
        '[stations.left]\nrobot = "puma560"\nprogram = "mian"\n\n[stations.right]\nrobot = "scara"\n', "utf-8"
    )
    (project / "programs" / "main.task").write_text("program main\nmov home\n", "utf-8")
    opened = open_project(project)
    left, right = opened.compile().diagnostics
    assert (left.code, right.code) == ("X844", "X844")
    assert left.message == "station `left` runs `mian`: the project has no program `mian`, it has `main`"
    assert "`main`" in left.hint
    assert 'program = ""' in right.hint
    assert [found.span.line for found in (left, right) if found.span] == [3, 5]
    with pytest.raises(ProjectError) as caught:
        opened.programs()
    assert caught.value.diagnostic == left


def test_a_robot_beside_stations_is_told_at_its_section_what_it_lacks(project: Path) -> None:
    (project / "cell.toml").write_text(
        '[robot]\nmodel = "puma560"\n\n[stations.right]\nrobot = "scara"\nprogram = "two"\n', "utf-8"
    )
    (project / "programs" / "main.task").unlink()
    for name in ("one", "two"):
        (project / "programs" / f"{name}.task").write_text(f"program {name}\nmov home\n", "utf-8")
    (found,) = open_project(project).compile().diagnostics
    assert (found.code, found.span.line if found.span else 0) == ("X844", 1)
    assert found.message.startswith("station `robot` runs `main`: ")
    assert "`program` in `[cell]`" in found.hint


def test_a_station_without_a_program_stands_still(project: Path) -> None:
    (project / "cell.toml").write_text(
        '[stations.left]\nrobot = "scara"\nprogram = "main"\n'
        '[stations.right]\nrobot = "scara"\nprogram = ""\n',
        "utf-8",
    )
    (project / "programs" / "main.task").write_text("program main\nmov home\n", "utf-8")
    opened = open_project(project)
    assert opened.compile().diagnostics == ()
    assert list(opened.programs()) == ["left"]
