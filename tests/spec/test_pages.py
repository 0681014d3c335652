"""Tutorials and how-to pages: typed in an empty folder, their steps print what the pages show.

`ROPSIM_UPDATE_GOLDEN=1` writes what is printed today into the pages; read the diff.
"""

import os
import re
import runpy
import shlex
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from ropsim import icr
from ropsim.cli.testing import main
from ropsim.language import compile
from ropsim.workbench import environment_of, open_project
from support.manual import DOCS
from support.pages import Step, as_far_as_shown, commands, steps, with_output, write

PAGES = sorted([*(DOCS / "tutorials").glob("*.md"), *(DOCS / "how-to").glob("*.md")])
TRIED = [page for page in PAGES if any(step.language == "console" or step.path for step in steps(page))]
READ = {"editors", "extend", "install", "studio"}
"""Pages of which no step is executed; docs/README.md names them."""
EXTENDING = [page for page in TRIED if page.stem.startswith("extend-")]
"""Pages that add files to ropsim or to a package of their own."""
SOURCE = DOCS.parent / "src" / "ropsim"
SILENCED = " > /dev/null"
"""Behind a command whose findings matter and not its results."""
LONG = {"calibrate-from-a-trace"}
"""Pages that take some dozen seconds."""
PROGRESS = re.compile(r" *\d+%  |\w.*: .*  \((?:\d+ s|\d+:\d\d min)\)$")
"""A line that a command shows when its work takes longer than a second: on a busy machine."""
NAMED = re.compile(r"# (error|warning|hint): ([A-Z]\d{3})$")


def test_every_page_is_carried_out_but_for_those_that_the_list_of_pages_names() -> None:
    assert {page.stem for page in PAGES} - {page.stem for page in TRIED} == READ


def cases(pages: list[Path]) -> list[object]:
    """Return pages as cases of a test; the long ones are slow."""
    marks = {True: [pytest.mark.slow], False: []}
    return [pytest.param(page, id=page.stem, marks=marks[page.stem in LONG]) for page in pages]


@pytest.mark.parametrize("page", cases([page for page in TRIED if page not in EXTENDING]))
def test_a_page_does_what_it_says(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / ".config"))
    names: dict[str, object] = {}
    for step in steps(page):
        if step.path:
            write(step, tmp_path)
        elif step.language == "console":
            shows(step, page, lambda words: in_this_process(words, capsys))
        elif step.language == "task":
            compiles(step, project_in(tmp_path))
        elif step.language == "python":
            exec(step.text, names)


@pytest.mark.slow
@pytest.mark.parametrize("page", EXTENDING, ids=lambda page: page.stem)
def test_a_page_that_extends_ropsim_works_on_a_copy_of_its_source(page: Path, tmp_path: Path) -> None:
    todo = steps(page)
    copy_source(
        tmp_path / "src" / "ropsim", {Path(one.path).parts[2] for one in todo if one.path.startswith("src/")}
    )
    for step in todo:
        if step.path:
            write(step, tmp_path)
        elif step.language == "console":
            shows(step, page, lambda words: in_a_process(words, tmp_path))


def copy_source(target: Path, changed: set[str]) -> None:
    """Put the packages of ropsim below a folder: copies of those that are changed, links to all others."""
    target.mkdir(parents=True)
    for entry in SOURCE.iterdir():
        if entry.name in changed and entry.is_dir():
            shutil.copytree(entry, target / entry.name)
        elif entry.name in changed:
            shutil.copy2(entry, target / entry.name)
        else:
            (target / entry.name).symlink_to(entry)


def shows(step: Step, page: Path, printed_by: Callable[[str], str]) -> None:
    """Run the commands of a step and compare what they print, or put it into the page."""
    outputs = []
    for words, shown in commands(step):
        lines = printed_by(words).rstrip().splitlines()
        printed = [line.rstrip() for line in lines if not PROGRESS.match(line)]
        outputs.append(as_far_as_shown(printed, shown))
    if os.environ.get("ROPSIM_UPDATE_GOLDEN"):
        page.write_text(with_output(page.read_text("utf-8"), step, outputs), "utf-8")
        return
    for (words, shown), output in zip(commands(step), outputs, strict=True):
        assert output == shown, f"{step}: {words}"


def in_this_process(words: str, capsys: pytest.CaptureFixture[str]) -> str:
    """Run one command line and return what it prints, findings last."""
    capsys.readouterr()
    program, *arguments = shlex.split(words.removesuffix(SILENCED))
    if program == "ropsim":
        main(arguments)
    else:
        assert program == "python", words
        runpy.run_path(arguments[0], run_name="__main__")
    said = capsys.readouterr()
    return ("" if words.endswith(SILENCED) else said.out) + said.err


def in_a_process(words: str, folder: Path) -> str:
    """Run one command line with the source below a folder and return what it prints, findings last."""
    program, *arguments = shlex.split(words.removesuffix(SILENCED))
    command = {"ropsim": ["-m", "ropsim"], "python": []}[program]
    own = {"PYTHONPATH": str(folder / "src"), "ROPSIM_CONFIG_HOME": str(folder / ".config")}
    said = subprocess.run(
        [sys.executable, *command, *arguments],
        cwd=folder,
        env={**os.environ, **own},
        capture_output=True,
        text=True,
        check=False,
    )
    return ("" if words.endswith(SILENCED) else said.stdout) + said.stderr


def project_in(folder: Path) -> Path:
    """Return the project whose cell file was written last."""
    return max(folder.glob("*/cell.toml"), key=lambda path: path.stat().st_mtime_ns).parent


def compiles(step: Step, project: Path) -> None:
    """Compile a program in the cell of a project; its findings are those that its comments name."""
    environment = environment_of(open_project(project).cell)
    lines = enumerate(step.text.splitlines(), 1)
    named = {(number, match[2]) for number, line in lines if (match := NAMED.search(line))}
    compiled = compile(step.text, environment, str(step))
    assert {(one.span.line if one.span else 0, one.code) for one in compiled.diagnostics} == named, str(step)
    if not named:
        assert compiled.icr is not None
        assert icr.verify(compiled.icr) == ()
