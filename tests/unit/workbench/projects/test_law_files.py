"""Joint controllers in files of a project: block diagrams run, modules run where the folder is trusted."""

from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.blockdiagram import Axes, CascadeGains, Limits, OutputKind, cascade, write_diagram
from ropsim.cli.main import main
from ropsim.controller import ModuleError
from ropsim.core import Diagnostic
from ropsim.flow import MoveEvent
from ropsim.model import ControllerFile, JointType
from ropsim.robotfile import write_robot_file
from ropsim.robots import STANDARD_RATES, load, standard_gains
from ropsim.simulation import Fidelity, RunOptions
from ropsim.userfiles import Trust, set_trust
from ropsim.workbench import Project, ProjectError, open_overlaid, open_project
from support.diagrams import voltages

CELL = """\
[robot]
model = "puma560"

[controller]
file = "controllers/{name}"
"""
PROGRAM = "program p\nunits mm, deg, s\nmov (500, -200, 400)\n"
MODULE = """\
import pathlib

pathlib.Path({mark!r}).write_text("ran")


class Weight:
    from ropsim.controller import LawTraits

    traits = LawTraits()

    def __init__(self, robot, controller):
        from ropsim.robots import standard_gains

        self.gains = standard_gains(robot, controller.rates)

    def step(self, now, state):
        q, qd, _ = now.meas
        gains = self.gains
        asked = gains.kp * (now.ref[0] - q) + now.ref[1]
        return gains.kv * (asked - qd) + gains.ke * now.ref[1]


def joint_controller(robot, controller):
    return Weight(robot, controller)
"""


def diagram_text() -> str:
    robot = load("puma560")
    gains = standard_gains(robot, STANDARD_RATES)
    names = ("kp", "kv", "ki", "kf", "ke", "ka")
    given = CascadeGains(*(tuple(getattr(gains, name).tolist()) for name in names))
    axes = Axes((JointType.REVOLUTE,) * 6, 0.001, OutputKind.VOLTAGE)
    return write_diagram(cascade(axes, given, Limits(voltages(robot))))


DIAGRAM = diagram_text()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    made = tmp_path / "cell"
    (made / "programs").mkdir(parents=True)
    (made / "controllers").mkdir()
    (made / "programs" / "main.task").write_text(PROGRAM, "utf-8")
    return made


def write(folder: Path, name: str, text: str | None) -> Project:
    (folder / "cell.toml").write_text(CELL.format(name=name), "utf-8")
    if text is not None:
        (folder / "controllers" / name).write_text(text, "utf-8")
    return open_project(folder)


def errors(project: Project) -> list[Diagnostic]:
    return [one for one in project.compile().diagnostics if one.is_error]


def test_a_block_diagram_of_the_project_drives_the_arm(folder: Path) -> None:
    project = write(folder, "p_pi.p21", DIAGRAM)
    assert project.compile().diagnostics == ()
    recording = project.simulate()
    assert recording.ok
    assert recording.facts.stations[0].law == "controllers/p_pi.p21"
    sources = [one.source for one in recording.facts.stations[0].origins]
    assert "the law in `controllers/p_pi.p21`" in sources
    assert not any("speed loops" in one for one in sources)


def test_response_and_margins_are_those_of_the_diagram(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(folder, "p_pi.p21", DIAGRAM)
    assert main(["controller", "response", str(folder), "--axis", "2"]) == 0
    assert "file of the project at 1000 Hz" in capsys.readouterr().out


def test_a_mistake_in_a_diagram_stands_at_its_line_and_nothing_runs(folder: Path) -> None:
    project = write(folder, "p_pi.p21", DIAGRAM.replace("(1,-1)", "(1,-1,1)", 1))
    (finding,) = errors(project)
    assert finding.code == "X970"
    assert finding.span is not None
    assert finding.span.source == str(folder / "controllers" / "p_pi.p21")
    assert finding.span.source in project.texts
    with pytest.raises(ProjectError):
        project.simulate()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (",0.001", ",0.002", "runs at 500 Hz, the cell at 1000 Hz"),
        ("CONTROLLER('p_pi',$,$", "CONTROLLER('p_pi',$,'ur5e'", "is for the arm `ur5e`"),
        (".RADIAN.", ".METRE.", "in `metre` for joint `1`"),
    ],
)
def test_a_diagram_that_does_not_fit_is_found_in_the_cell_file(
    folder: Path, old: str, new: str, words: str
) -> None:
    text = DIAGRAM.replace(old, new)
    if old == ".RADIAN.":
        for one in ("RADIAN_PER_SECOND_SQUARED", "RADIAN_PER_SECOND"):
            text = text.replace(f".{one}.", f".{one.replace('RADIAN', 'METRE')}.")
    (finding,) = errors(write(folder, "p_pi.p21", text))
    assert finding.code == "C626"
    assert words in finding.message
    assert finding.span is not None
    assert finding.span.line == 5


@pytest.mark.parametrize(
    ("name", "code"),
    [("none.p21", "X840"), ("law.toml", "X930"), ("../law.p21", "U962"), ("", "X930")],
)
def test_a_file_that_cannot_be_is_a_finding(folder: Path, name: str, code: str) -> None:
    found = errors(write(folder, name, None))
    assert [one.code for one in found] == [code]


def test_a_module_does_not_run_until_the_folder_is_trusted(folder: Path, tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    project = write(folder, "mine.py", MODULE.format(mark=str(mark)))
    (finding,) = errors(project)
    assert finding.code == "C628"
    assert "ropsim trust" in finding.hint
    assert finding.span is not None
    assert (finding.span.line, finding.span.column) == (5, 8)
    with pytest.raises(ProjectError, match="not trusted"):
        project.simulate()
    assert main(["controller", "response", str(folder)]) == 1
    assert not mark.exists()
    set_trust(folder, Trust.GIVEN)
    trusted = open_project(folder)
    assert errors(trusted) == []
    assert not mark.exists()  # reading and checking run nothing of a trusted project either
    recording = trusted.simulate()
    assert mark.read_text() == "ran"
    assert recording.facts.stations[0].law == "controllers/mine.py"
    assert main(["controller", "response", str(folder), "--axis", "1"]) == 0


def test_a_cell_names_its_module_and_the_text_that_counts_is_the_unsaved_one(folder: Path) -> None:
    write(folder, "p_pi.p21", DIAGRAM)
    cell = CELL.format(name="other.p21")
    project = open_overlaid(folder, {"cell.toml": cell, "controllers/other.p21": DIAGRAM})
    assert project.cell is not None
    file = project.cell.first.controller.gains
    assert isinstance(file, ControllerFile)
    assert (file.path, file.text) == ("controllers/other.p21", DIAGRAM)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("def joint_controller(robot, controller):\n    return 1 / 0\n", "line 2 fails: ZeroDivisionError"),
        ("x = 1\n", "defines no function `joint_controller`"),
        ("def joint_controller(robot, controller):\n    return 3\n", "returns int"),
        ("raise SystemExit(3)\n", "line 1 fails: SystemExit: 3"),
        ("def joint_controller(robot, controller):\n    import none_such\n", "fails: ModuleNotFoundError"),
    ],
)
def test_a_module_that_fails_is_a_finding(folder: Path, text: str, words: str) -> None:
    write(folder, "mine.py", text)
    set_trust(folder, Trust.GIVEN)
    recording_error = None
    try:
        open_project(folder).simulate()
    except Exception as error:
        recording_error = error
    assert recording_error is not None
    found = getattr(recording_error, "diagnostic", None)
    assert isinstance(found, Diagnostic)
    assert found.code == "C629"
    assert words in found.message


def test_a_module_that_is_no_python_is_found_by_check_at_its_line(folder: Path) -> None:
    write(folder, "mine.py", "x = 1\ndef law(:\n")
    set_trust(folder, Trust.GIVEN)
    (finding,) = errors(open_project(folder))
    assert finding.code == "C629"
    assert finding.span is not None
    assert finding.span.line == 2


def test_gains_beside_a_file_are_a_conflict(folder: Path) -> None:
    write(folder, "p_pi.p21", DIAGRAM)
    text = CELL.format(name="p_pi.p21") + "law = 'fixed gains'\n"
    (folder / "cell.toml").write_text(text, "utf-8")
    assert "belongs to a built-in law" in errors(open_project(folder))[0].message


def test_an_arm_without_drives_takes_no_file(folder: Path) -> None:
    write(folder, "p_pi.p21", DIAGRAM)
    robot = replace(load("two_link"), drives=())
    (folder / "arm.toml").write_text(write_robot_file(robot).text, "utf-8")
    text = CELL.format(name="p_pi.p21").replace("puma560", "arm.toml")
    (folder / "cell.toml").write_text(text, "utf-8")
    assert [one.code for one in errors(open_project(folder))] == ["X930"]


ENTITIES = """\
[robot]
model = "puma560"

[controller.entities]
interpolator = "controllers/weaving.py"
path_planner = "controllers/slow.py"
joint_interpolator = "controllers/through.py"
inverse_transform = "controllers/through.py"
path_corrector = "controllers/through.py"
sensor_interface = "controllers/through.py"
"""
SLOW = """\
from dataclasses import dataclass, replace
from typing import Any


@dataclass(frozen=True)
class Slow:
    inner: Any

    def plan(self, move, q_start):
        planned = self.inner.plan(move, q_start)
        if planned.joints is None:
            return planned
        joints = planned.limits.joints
        joints = replace(joints, speed=0.5 * joints.speed)
        return replace(planned, limits=replace(planned.limits, joints=joints))


def path_planner(standard, cell, station):
    return Slow(standard)
"""
WEAVING = """\
from dataclasses import replace

import numpy as np

from ropsim.planning import StandardInterpolator


class Weaving:
    straight = StandardInterpolator(distance=0.002)

    def sample(self, path, sampling):
        points = self.straight.sample(path, sampling)
        s = np.linspace(0.0, 1.0, len(points.matrices))
        matrices = points.matrices.copy()
        matrices[:, 2, 3] += 0.003 * np.sin(np.pi * s) ** 4 * np.sin(40.0 * s)
        return replace(points, matrices=matrices)


def interpolator(standard, cell, station):
    return Weaving()
"""
THROUGH = """\
def joint_interpolator(standard, cell, station):
    return standard


inverse_transform = path_corrector = sensor_interface = joint_interpolator
"""
LINE = "program p\nunits mm, deg, s\nmov (500, -200, 400)\nlin (500, 200, 400) speed 200 mm/s\n"


def test_entities_of_a_trusted_project_take_the_place_of_the_built_in_ones(folder: Path) -> None:
    (folder / "programs" / "main.task").write_text(LINE, "utf-8")
    for name, text in (("slow", SLOW), ("weaving", WEAVING), ("through", THROUGH)):
        (folder / "controllers" / f"{name}.py").write_text(text, "utf-8")
    (folder / "cell.toml").write_text('[robot]\nmodel = "puma560"\n', "utf-8")
    before = open_project(folder).simulate(options=RunOptions(Fidelity.KINEMATIC))
    (folder / "cell.toml").write_text(ENTITIES, "utf-8")
    found = errors(open_project(folder))
    assert {one.code for one in found} == {"C628"}
    assert any("makes the path planner and is not run" in one.message for one in found)
    lines = {one.message.split("`")[1]: one.span.line for one in found if one.span is not None}
    assert lines["controllers/weaving.py"] == 5
    assert lines["controllers/slow.py"] == 6
    set_trust(folder, Trust.GIVEN)
    project = open_project(folder)
    assert errors(project) == []
    after = project.simulate(options=RunOptions(Fidelity.KINEMATIC))
    assert after.ok
    (first, line), (slow, woven) = (
        [one for one in made.events if isinstance(one, MoveEvent)] for made in (before, after)
    )
    assert first.travel is not None
    assert slow.travel is not None
    assert slow.travel > 1.4 * first.travel
    assert line.path_error_max is not None
    assert woven.path_error_max is not None
    assert line.path_error_max < 1e-5
    assert 0.002 < woven.path_error_max < 0.004


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("def path_planner(standard, cell, station):\n    return 3\n", "returns int"),
        ("def planner():\n    return 3\n", "defines no function `path_planner`"),
        ("import none_such\n", "path planner: `controllers/slow.py`, line 1 fails: ModuleNotFoundError"),
    ],
)
def test_an_entity_that_cannot_be_made_is_a_finding(folder: Path, text: str, words: str) -> None:
    cell = '[robot]\nmodel = "puma560"\n[controller.entities]\npath_planner = "controllers/slow.py"\n'
    (folder / "cell.toml").write_text(cell, "utf-8")
    (folder / "controllers" / "slow.py").write_text(text, "utf-8")
    set_trust(folder, Trust.GIVEN)
    with pytest.raises(ModuleError, match=words) as refused:
        open_project(folder).simulate()
    assert refused.value.diagnostic.code == "C629"


def test_an_unknown_entity_or_a_diagram_for_one_is_found(folder: Path) -> None:
    cell = '[robot]\nmodel = "puma560"\n[controller.entities]\npath_planer = "a.py"\ninterpolator = "a.p21"\n'
    (folder / "cell.toml").write_text(cell, "utf-8")
    assert [one.code for one in errors(open_project(folder))] == ["X802", "X930"]
