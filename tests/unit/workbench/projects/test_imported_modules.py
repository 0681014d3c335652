"""Modules of a project import its other files: under trust, apart from other projects, none from outside."""

import sys
from pathlib import Path

import pytest

from ropsim.controller import ModuleError
from ropsim.core import Diagnostic
from ropsim.model import ControllerFile
from ropsim.simulation import Fidelity, RunOptions
from ropsim.userfiles import Trust, set_trust
from ropsim.workbench import Project, ProjectError, open_project

CELL = '[robot]\nmodel = "puma560"\n[controller.entities]\npath_planner = "controllers/mine.py"\n'
PROGRAM = "program p\nunits mm, deg, s\nmov (500, -200, 400)\n"
MINE = """\
from helpers import SHARE


def path_planner(standard, cell, station):
    from slowed import Slowed

    return Slowed(standard, SHARE)
"""
SLOWED = """\
from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Slowed:
    inner: object
    share: float

    def plan(self, move, q_start):
        planned = self.inner.plan(move, q_start)
        joints = planned.limits.joints
        slower = replace(joints, speed=self.share * joints.speed)
        return replace(planned, limits=replace(planned.limits, joints=slower))
"""


def project(folder: Path, files: dict[str, str], trust: Trust = Trust.GIVEN) -> Project:
    for name, text in {"cell.toml": CELL, "programs/main.task": PROGRAM, **files}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
    set_trust(folder, trust)
    return open_project(folder)


def helped(share: float) -> dict[str, str]:
    return {
        "controllers/mine.py": MINE,
        "controllers/helpers.py": f"SHARE = {share}\n",
        "controllers/slowed.py": SLOWED,
    }


@pytest.fixture(autouse=True)
def _own_trust(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))


def duration(opened: Project) -> float:
    return opened.simulate(options=RunOptions(Fidelity.KINEMATIC)).duration


def errors(opened: Project) -> list[Diagnostic]:
    return [one for one in opened.compile().diagnostics if one.is_error]


def file_of(opened: Project) -> ControllerFile:
    assert opened.cell is not None
    return opened.cell.first.controller.entities[0].file


def test_two_open_projects_with_modules_of_the_same_names_do_not_meet(tmp_path: Path) -> None:
    before, places = set(sys.modules), list(sys.path)
    quick, slow = project(tmp_path / "a", helped(1.0)), project(tmp_path / "b", helped(0.25))
    first, second, again = duration(quick), duration(slow), duration(quick)
    assert first == again
    assert second > 2.0 * first
    assert not {"helpers", "slowed", "mine", "project_module"} & set(sys.modules) - before
    assert sys.path == places


def test_what_is_imported_belongs_to_the_cell_and_to_the_texts_of_the_project(tmp_path: Path) -> None:
    opened = project(tmp_path / "a", helped(1.0))
    assert [one.path for one in file_of(opened).modules] == [
        "controllers/helpers.py",
        "controllers/slowed.py",
    ]
    assert str(tmp_path / "a" / "controllers" / "helpers.py") in opened.texts
    other = project(tmp_path / "a", helped(0.5))
    assert opened.cell != other.cell  # what is kept for one content is not used for another


@pytest.mark.parametrize(
    ("text", "files"),
    [
        ("import helpers\nSHARE = helpers.SHARE\n", {"controllers/helpers.py": "SHARE = 0.25\n"}),
        ("from .helpers import SHARE\n", {"controllers/helpers.py": "SHARE = 0.25\n"}),
        ("from . import helpers\nSHARE = helpers.SHARE\n", {"controllers/helpers.py": "SHARE = 0.25\n"}),
        ("from ..gains import *\n", {"gains.py": "SHARE = 0.25\n"}),
        ("from shared.gains import SHARE\n", {"shared/gains.py": "SHARE = 0.25\n"}),
        ("from shared import gains\nSHARE = gains.SHARE\n", {"shared/gains.py": "SHARE = 0.25\n"}),
        ("import shared.deep.gains as g\nSHARE = g.SHARE\n", {"shared/deep/gains.py": "SHARE = 0.25\n"}),
        (
            "import shared.gains\nSHARE = shared.SHARE\n",
            {"shared/__init__.py": "from .gains import SHARE\n", "shared/gains.py": "SHARE = 0.25\n"},
        ),
        (
            "from first import SHARE\n",  # each imports the other
            {
                "controllers/first.py": "SHARE = 0.25\nimport second\n",
                "controllers/second.py": "import first\nassert first.SHARE == 0.25\n",
            },
        ),
    ],
)
def test_every_form_of_import_finds_files_of_the_project(
    tmp_path: Path, text: str, files: dict[str, str]
) -> None:
    mine = text + MINE.partition("\n")[2]
    slow = project(tmp_path / "a", {"controllers/mine.py": mine, "controllers/slowed.py": SLOWED, **files})
    assert errors(slow) == []
    assert duration(slow) > 2.0 * duration(project(tmp_path / "b", helped(1.0)))


def test_without_trust_nothing_that_is_imported_runs(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    files = {**helped(1.0), "controllers/helpers.py": f"open({str(mark)!r}, 'w').close()\nSHARE = 1.0\n"}
    opened = project(tmp_path / "a", files, Trust.WITHHELD)
    assert "C628" in [one.code for one in errors(opened)]
    with pytest.raises(ProjectError):
        duration(opened)
    assert not mark.exists()
    duration(project(tmp_path / "a", files))
    assert mark.exists()


@pytest.mark.parametrize("text", ["from ...outside import SHARE\n", "from .... import outside\n"])
def test_a_file_outside_of_the_project_is_refused_at_its_line(tmp_path: Path, text: str) -> None:
    (tmp_path / "outside.py").write_text("SHARE = 1.0\n", "utf-8")
    opened = project(tmp_path / "a", {"controllers/mine.py": "\n" + text})
    (found,) = errors(opened)
    assert (found.code, found.span and found.span.line) == ("U962", 2)


def test_a_link_that_leads_outside_is_refused(tmp_path: Path) -> None:
    (tmp_path / "outside.py").write_text("SHARE = 1.0\n", "utf-8")
    (tmp_path / "a" / "controllers").mkdir(parents=True)
    (tmp_path / "a" / "controllers" / "helpers.py").symlink_to(tmp_path / "outside.py")
    opened = project(tmp_path / "a", {"controllers/mine.py": MINE, "controllers/slowed.py": SLOWED})
    assert [one.code for one in errors(opened)] == ["U962"]


def test_a_mistake_in_an_imported_file_is_found_there(tmp_path: Path) -> None:
    wrong = project(tmp_path / "a", {**helped(1.0), "controllers/helpers.py": "\nSHARE = \n"})
    (found,) = errors(wrong)
    assert found.code == "C629"
    assert found.span is not None
    assert (Path(found.span.source).name, found.span.line) == ("helpers.py", 2)
    fails = project(tmp_path / "b", {**helped(1.0), "controllers/helpers.py": "\n\nSHARE = 1 / 0\n"})
    with pytest.raises(ModuleError, match=r"`controllers/helpers.py`, line 3 fails: ZeroDivisionError"):
        duration(fails)
