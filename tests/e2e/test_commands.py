"""The user's path on the command line, and everything that can be wrong on it.

The path itself is walked in processes of their own; what is wrong on it is told by the same commands in this
one, which needs not be started each time. `test_hostile_streams.py` has what only a process can meet.
"""

import contextlib
import io
import json
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from ropsim.cli.testing import build_parser, main
from ropsim.workbench import new_project
from support.patience import PATIENCE

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"


def process(*arguments: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command in a process of its own."""
    return sound(
        subprocess.run(
            [sys.executable, "-m", "ropsim", *arguments],
            capture_output=True,
            text=True,
            cwd=cwd,
            timeout=PATIENCE,
            check=False,
        )
    )


def ropsim(*arguments: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run a command in this process."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), contextlib.chdir(cwd or "."):
        try:
            code = main(arguments)
        except SystemExit as end:  # of the parser
            code = int(end.code or 0)
    return sound(subprocess.CompletedProcess(arguments, code, out.getvalue(), err.getvalue()))


def sound(found: subprocess.CompletedProcess[str]) -> subprocess.CompletedProcess[str]:
    """Return a result that shows no fault of ropsim itself."""
    assert "Traceback" not in found.stderr, found.stderr
    assert "bug in ropsim" not in found.stderr, found.stderr
    return found


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of the palletizing cell that a test may spoil."""
    folder = tmp_path / "cell"
    shutil.copytree(EXAMPLES / "palletizing", folder, ignore=shutil.ignore_patterns("out"))
    return folder


def program(project: Path, text: str) -> Path:
    (project / "programs" / "main.task").write_text(text)
    return project


def test_the_version_is_one_line() -> None:
    found = process("--version")
    assert found.returncode == 0
    assert found.stdout.startswith("ropsim ")


def test_help_names_every_command() -> None:
    shown = re.findall(r"^ {4}([a-z]+) +\S", process("--help").stdout, re.MULTILINE)
    (commands,) = (one for one in build_parser()._actions if one.choices)
    assert shown == list(commands.choices or ())
    assert len(shown) > 8


@pytest.mark.parametrize("name", ["fig5", "palletizing"])
def test_the_examples_are_right(name: str) -> None:
    found = ropsim("check", str(EXAMPLES / name))
    assert (found.returncode, found.stderr) == (0, "")


def test_a_run_writes_report_and_recording(project: Path, tmp_path: Path) -> None:
    report, record = tmp_path / "r" / "report.html", tmp_path / "r" / "run.npz"
    found = process("run", str(project), "--report", str(report), "--record", str(record), "--json")
    assert found.returncode == 0, found.stderr
    document = json.loads(found.stdout)
    assert document["ok"] is True
    assert document["summary"]["duration"] > 60
    assert report.read_text().startswith("<!DOCTYPE html>")
    assert record.stat().st_size > 1000


def test_a_kinematic_run_tells_its_cycle_time(project: Path) -> None:
    found = ropsim("run", str(project), "--kinematic")
    assert found.returncode == 0
    assert "cycle time" in found.stdout.lower()


def test_icr_can_be_compiled_verified_and_run(tmp_path: Path) -> None:
    task = str(EXAMPLES / "fig5" / "programs" / "main.task")
    code = tmp_path / "fig5.icr"
    assert process("icr", "compile", task, "-o", str(code)).returncode == 0
    assert process("icr", "verify", str(code)).returncode == 0
    found = process("icr", "run", str(code))
    assert found.returncode == 0
    assert "72 moves, 72 gripper actions" in found.stdout


def test_a_wrong_task_name_is_answered_in_the_words_of_the_paper(project: Path) -> None:
    text = (
        (EXAMPLES / "fig5" / "programs" / "main.task").read_text().replace("call release 2", "call relase 2")
    )
    found = process("run", str(program(project, text)))
    assert found.returncode == 1
    assert "Task not defined: `relase`" in found.stderr
    assert "did you mean `release`?" in found.stderr
    assert found.stderr.count("error[") == 1


def test_an_angle_out_of_range_names_joint_angle_limit_line_and_pass(project: Path) -> None:
    text = "program far\nunits mm, deg\nrepeat 2\n  mov joints (0, 0, 170, 0, 0, 0)\nendr\n"
    found = ropsim("run", str(program(project, text)))
    assert found.returncode == 1
    assert "M502" in found.stderr
    assert "main.task:4" in found.stderr
    for words in ("joint `3`", "170", "45", "pass"):
        assert words in found.stderr


def test_a_point_out_of_reach_is_a_finding_and_the_rest_goes_on(project: Path) -> None:
    text = "program far\nunits mm, deg\nmov (3000, 0, 500)\nmov (450, 100, 700)\n"
    found = ropsim("run", str(program(project, text)), "--json")
    assert found.returncode == 1
    document = json.loads(found.stdout)
    assert [one["code"] for one in document["diagnostics"]] == ["M501"]
    assert document["summary"]["duration"] > 0


def test_what_a_program_prints_is_shown_before_the_summary(project: Path) -> None:
    text = 'program talk\nrepeat 2\n  print "box", 1\n  wait 0.5 s\nendr\nmov home\n'
    found = ropsim("run", str(program(project, text)), "--kinematic")
    assert found.returncode == 0, found.stderr
    told = ["0.00 s  line 3  box 1", "0.50 s  line 3  box 1", ""]
    assert found.stdout.splitlines()[:3] == told
    document = json.loads(ropsim("run", str(project), "--kinematic", "--json").stdout)
    source = str(project / "programs" / "main.task")
    assert document["messages"] == [
        {"time": 0.0, "text": "box 1", "source": source, "line": 3, "pass": 1},
        {"time": 0.5, "text": "box 1", "source": source, "line": 3, "pass": 2},
    ]


def test_the_json_of_a_run_says_what_was_not_looked_at_and_what_settling_cost(project: Path) -> None:
    text = "program two\nunits mm, deg\nmov joints (10, 10, 10, 0, 30, 0) blend 10 mm\n"
    cell = project / "cell.toml"
    narrow = "in_position = [1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5]"  # the arm needs a while until it is there
    cell.write_text(cell.read_text("utf-8").replace("[controller]", f"[controller]\n{narrow}"), "utf-8")
    document = json.loads(ropsim("run", str(program(project, text)), "--json").stdout)
    result, summary = document["result"], document["summary"]
    assert result["unchecked"] == summary["unchecked"]["text"]
    assert result["unchecked"].startswith("not checked: rated payload · estimated: ")
    assert result["unchecked"].endswith(" · zones not flown (fine stop) on 1 line")
    assert result["settling"]["total"] == summary["settling"]["total"] >= summary["settling"]["longest"] > 0.0
    share = result["settling"]["total"] / result["cycle_time"]
    assert result["settling"]["share"] == summary["settling"]["share"] == pytest.approx(share)
    assert (result["settling"]["time"], result["settling"]["line"]) == (summary["settling"]["time"], 3)


def test_a_warning_of_the_compiler_counts_in_the_verdict(project: Path) -> None:
    text = "program warned\nunits mm, deg\nmov joints (10, 10, 10, 0, 30, 0) speed 50\n"
    document = json.loads(ropsim("run", str(program(project, text)), "--kinematic", "--json").stdout)
    assert document["counts"]["warnings"] == document["result"]["warnings"] > 0
    assert document["result"]["verdict"]["kind"] == "doubtful"


BAD_PROGRAMS = {
    "empty": "",
    "recursion": "task a\n  call b\nendp\ntask b\n  call a\nendp\ncall a\n",
    "nan": "mov (nan, 0, 0)\n",
    "absurd": "units mm\nmov (1e300, 0, 0)\n",
    "infinite": "units mm\nmov (1e999, 0, 0)\n",
    "endless": "x = 1\nwhile x > 0\n  x = 1\nendw\n",
    "unclosed": "repeat 3\nmov (1, 2, 3)\n",
    "binary": "\x00\x01\x02\x03",
}


@pytest.mark.parametrize("name", BAD_PROGRAMS)
def test_a_bad_program_gets_a_diagnostic_and_no_report(name: str, project: Path) -> None:
    report = project / "report.html"
    report.write_text("the last good report")
    found = ropsim("run", str(program(project, BAD_PROGRAMS[name])), "--report", str(report))
    assert found.returncode == (0 if name == "empty" else 1), found.stderr
    assert "[" in found.stderr
    if name not in ("empty", "absurd", "endless"):  # these compile; their report says what happened
        assert report.read_text() == "the last good report"


def test_ten_megabytes_of_noise_are_no_program(project: Path) -> None:
    noise = random.Random(1).randbytes(10_000_000)
    (project / "programs" / "main.task").write_bytes(noise)
    found = ropsim("run", str(project))
    assert found.returncode == 1
    assert "10.0 MB" in found.stderr


def test_noise_of_allowed_size_is_answered_in_few_words(project: Path) -> None:
    noise = random.Random(2).randbytes(2_000_000)
    (project / "programs" / "main.task").write_bytes(noise)
    assert ropsim("check", str(project)).returncode == 1
    (project / "programs" / "main.task").write_text(noise.decode("latin-1"), encoding="utf-8")
    found = ropsim("check", str(project))
    assert found.returncode == 1
    assert len(found.stderr) < 1_000_000


def test_missing_things_are_wrong_usage(tmp_path: Path, project: Path) -> None:
    assert ropsim("run", str(tmp_path / "nowhere")).returncode == 2
    assert ropsim("run", str(tmp_path)).returncode == 2
    found = ropsim("run", str(project), "mian")
    assert found.returncode == 2
    assert "did you mean `main`?" in found.stderr
    assert process("frobnicate").returncode == 2
    assert ropsim("explain", "M999").returncode == 2


def test_a_wrong_key_is_named_with_the_right_one(project: Path) -> None:
    cell = project / "cell.toml"
    cell.write_text(cell.read_text().replace("mass =", "maas =", 1))
    found = ropsim("run", str(project))
    assert found.returncode == 1
    assert "maas`" in found.stderr
    assert "mass" in found.stderr
    assert "cell.toml:" in found.stderr


@pytest.mark.parametrize("value", ["nan", "inf", "-5", "1e300", '"heavy"', "[1, 2]", "true"])
def test_an_impossible_mass_is_a_finding(value: str, project: Path) -> None:
    cell = project / "cell.toml"
    lines = [
        f"mass = {value}" if line.startswith("mass =") else line for line in cell.read_text().splitlines()
    ]
    cell.write_text("\n".join(lines))
    found = ropsim("run", str(project))
    assert found.returncode == 1
    assert "mass" in found.stderr


def test_a_report_that_cannot_be_written_is_said(project: Path, tmp_path: Path) -> None:
    blocker = tmp_path / "file"
    blocker.write_text("in the way")
    found = ropsim("run", str(project), "--kinematic", "--report", str(blocker / "r.html"))
    assert found.returncode == 2
    assert "cannot be written" in found.stderr
    assert blocker.read_text() == "in the way"


def test_results_never_overwrite_the_project_or_each_other(project: Path, tmp_path: Path) -> None:
    cell = (project / "cell.toml").read_text()
    assert ropsim("run", str(project), "--report", str(project / "cell.toml")).returncode == 2
    assert ropsim("run", str(project), "--record", str(project / "programs" / "main.task")).returncode == 2
    same = str(tmp_path / "same")
    assert ropsim("run", str(project), "--report", same, "--record", same).returncode == 2
    assert (project / "cell.toml").read_text() == cell


def test_every_code_can_be_explained() -> None:
    listed = json.loads(ropsim("explain", "--json").stdout)["codes"]
    assert len(listed) > 50
    assert "out of range" in ropsim("explain", "M502").stdout


def test_a_retired_code_is_explained() -> None:
    said = ropsim("explain", "m507")
    assert said.returncode == 0
    assert said.stdout.startswith("retired[M507] zone-not-simulated: the move has a zone")
    assert "M560" in said.stdout
    assert json.loads(ropsim("explain", "M507", "--json").stdout)["severity"] == "retired"


def test_robots_speak_degrees_and_millimetres() -> None:
    found = ropsim("robot", "fk", "puma560", "0", "45", "180", "0", "45", "0")
    assert "x 596.303  y -150.050  z 657.476 mm" in found.stdout
    listed = json.loads(
        ropsim("robot", "ik", "puma560", "596.303", "-150.05", "657.476", "0", "90", "0", "--json").stdout
    )
    assert len(listed["solutions"]) == len(listed["postures"]) == 3
    assert ropsim("robot", "show", "puma650").returncode in (1, 2)
    assert "estimated" in ropsim("robot", "show", "puma560").stdout


def test_ik_shows_the_postures_beyond_the_limits_and_what_they_exceed() -> None:
    pose = ("540", "-55", "955", "170", "10", "-170")
    found = ropsim("robot", "ik", "puma560", *pose)
    assert found.returncode == 0
    rows = found.stdout.splitlines()
    assert rows[0].split() == [
        *(word for k in range(1, 7) for word in (str(k), "[°]")),
        "posture",
        *["beyond", "its", "limits"],
    ]
    assert len(rows) == 1 + 8  # all branches of an arm with a spherical wrist
    document = json.loads(ropsim("robot", "ik", "puma560", *pose, "--json").stdout)
    assert len(document["solutions"]) + len(document["beyond_limits"]) == 8
    for branch, row in zip(document["beyond_limits"], rows[1 + len(document["solutions"]) :], strict=True):
        worst = branch["exceeds"][0]
        assert f"joint {worst['joint']} by {57.29577951308232 * worst['excess']:.1f}°" in row
        assert branch["posture"] in row


def test_ik_says_how_far_a_pose_is_out_of_reach() -> None:
    found = ropsim("robot", "ik", "puma560", "2000", "0", "0", "0", "0", "0")
    assert found.returncode == 1
    assert "no solution: out of reach; the wrist centre would be" in found.stdout
    assert "864.1 mm" in found.stdout


def test_a_new_project_runs_at_once(tmp_path: Path) -> None:
    made = process("new", "mine", cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    assert process("run", "mine", cwd=tmp_path).returncode == 0
    again = process("new", "mine", cwd=tmp_path)
    assert again.returncode == 2
    assert "not an empty folder" in again.stderr


def test_every_example_can_be_copied(tmp_path: Path) -> None:
    names = json.loads(ropsim("examples", "--json").stdout)["examples"]
    assert set(names) == {
        "crane",
        "fig5",
        "first_cell",
        "four_squares",
        "operator",
        "palletizing",
        "peg_in_hole",
        "track_and_table",
        "two_arms",
    }
    for name in names:
        assert ropsim("new", name, "--example", name, cwd=tmp_path).returncode == 0
        assert ropsim("check", name, cwd=tmp_path).returncode == 0
    found = ropsim("new", "x", "--example", "fig6", cwd=tmp_path)
    assert found.returncode == 2
    assert "did you mean `fig5`?" in found.stderr
    assert not (tmp_path / "x").exists()


def test_the_tutorial_shows_the_starter_as_it_is(tmp_path: Path) -> None:
    tutorial = (ROOT / "docs" / "tutorials" / "first-cell.md").read_text()
    made = new_project(tmp_path / "my_cell")
    for file in ("cell.toml", "programs/main.task"):
        assert (made / file).read_text().rstrip() in tutorial


def test_the_tutorial_leaves_a_program_that_runs(tmp_path: Path) -> None:
    """What section 4 breaks: a wrong word, mended again, and a point out of reach, taken out again."""
    made = new_project(tmp_path / "my_cell") / "programs" / "main.task"
    good = made.read_text()
    made.write_text(good.replace("  open\n", "  opne\n", 1))
    found = ropsim("check", "my_cell", cwd=tmp_path)
    assert (found.returncode, found.stderr.count("error[")) == (1, 1)
    assert "did you mean `open`?" in found.stderr
    made.write_text(good + "mov (2000, 0, 300)\n")
    found = ropsim("run", "my_cell", cwd=tmp_path)
    assert found.returncode == 1
    assert "M501" in found.stderr
    made.write_text(good)
    assert ropsim("run", "my_cell", cwd=tmp_path).returncode == 0


@pytest.mark.parametrize("option", ["--report", "--record"])
def test_a_folder_is_no_place_for_a_result(project: Path, tmp_path: Path, option: str) -> None:
    found = ropsim("run", str(project), option, str(tmp_path))
    assert found.returncode == 2
    assert "is a folder, needed is the name of a file" in found.stderr
    assert "simulating" not in found.stderr
