"""What commands say to people, where it is more than a list."""

from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.workbench import new_project


def said(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    main(arguments)
    return capsys.readouterr().out


def test_a_check_with_warnings_does_not_sound_like_one_without(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project = new_project(tmp_path / "cell")
    assert said(["check", str(project)], capsys) == "checked main: no errors\n"
    program = "units mm, deg\nmov joints (10, 10, 10, 0, 30, 0) speed 50\n"
    (project / "programs" / "main.task").write_text(program)
    assert said(["check", str(project)], capsys) == "checked main: no errors, 1 warning\n"


def test_a_folder_with_a_blank_is_quoted_in_the_next_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert said(["new", "my cell"], capsys) == "made my cell; next: ropsim run 'my cell'\n"


def test_the_numbers_of_a_robot_stand_below_their_titles(capsys: pytest.CaptureFixture[str]) -> None:
    lines = said(["robot", "show", "puma560"], capsys).splitlines()
    header, *rows = lines[2:9]
    assert len(rows) == 6
    for title in ("lower", "upper", "speed", "acceleration", "torque or force"):
        end = header.index(title) + len(title)
        assert all(row[:end].rstrip() == row[:end] and row[end : end + 1] in {"", " "} for row in rows)
    assert max(map(len, lines)) <= 80


def test_a_robot_is_drawn_into_a_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("ropsim.views.robot_png", lambda robot: robot.name.encode())
    picture = tmp_path / "arm.png"
    lines = said(["robot", "show", "two_link", "--png", str(picture)], capsys).splitlines()
    assert lines[-1] == f"wrote {picture}"
    assert picture.read_bytes() == b"two_link"
    assert main(["robot", "show", "two_link", "--png", str(picture / "arm.png")]) == 2
    assert "arm.png" in capsys.readouterr().err


def test_trust_says_in_words_that_there_is_no_code(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    project = new_project(tmp_path / "cell")
    assert said(["trust", str(project)], capsys) == f"{project} is trusted; there is no code in it\n"
    (project / "controllers").mkdir()
    (project / "controllers" / "law.py").write_text("")
    assert said(["trust", str(project)], capsys).splitlines()[1:] == ["  controllers/law.py"]


def test_a_recording_under_the_name_of_a_table_is_refused_before_the_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    project = new_project(tmp_path / "cell")
    assert main(["run", str(project), "--record", str(tmp_path / "run.csv")]) == 2
    assert f"--record {tmp_path / 'run.npz'}" in capsys.readouterr().err
    assert [one.name for one in tmp_path.iterdir()] == ["cell"]


def test_the_bare_word_lists_the_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    shown = capsys.readouterr().out
    assert all(f"\n    {command} " in shown for command in ("new", "check", "run", "studio"))


@pytest.mark.parametrize(("words", "near"), [(["chekc"], "check"), (["robot", "lst"], "list")])
def test_a_command_that_does_not_exist_is_answered_with_the_nearest(
    words: list[str], near: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(words)
    assert ended.value.code == 2
    assert f"did you mean `{near}`?" in capsys.readouterr().err
