"""Tutorials and how-to pages: whoever types what they say, in an empty folder, sees what they show.

`ROPSIM_UPDATE_GOLDEN=1` writes what is printed today into the pages; read the diff.
"""

import os
import re
import runpy
import shlex
from pathlib import Path

import pytest

from ropsim import icr
from ropsim.cli.main import main
from ropsim.language import compile
from ropsim.workbench import environment_of, open_project
from support.manual import DOCS
from support.pages import Step, as_far_as_shown, commands, steps, with_output

PAGES = sorted([*(DOCS / "tutorials").glob("*.md"), *(DOCS / "how-to").glob("*.md")])
TRIED = [page for page in PAGES if any(step.language == "console" or step.path for step in steps(page))]
READ = {"add-a-diagnostic", "editors", "extend", "install", "studio"}
"""Pages of which no step is carried out; docs/README.md says which these are."""
SILENCED = " > /dev/null"
"""Behind a command whose findings matter and not its results."""
PROGRESS = re.compile(r" *\d+%  |\w.*: .*  \(\d+ s\)$")
"""A line that a command shows when its work takes longer than a second: on a busy machine."""
NAMED = re.compile(r"# (error|warning|hint): ([A-Z]\d{3})$")


def test_every_page_is_carried_out_but_for_those_that_the_list_of_pages_names() -> None:
    assert {page.stem for page in PAGES} - {page.stem for page in TRIED} == READ


@pytest.mark.parametrize("page", TRIED, ids=lambda page: page.stem)
def test_a_page_does_what_it_says(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / ".config"))
    names: dict[str, object] = {}
    for step in steps(page):
        if step.path:
            write(step)
        elif step.language == "console":
            shows(step, page, capsys)
        elif step.language == "task":
            compiles(step, project_in(tmp_path))
        elif step.language == "python":
            exec(step.text, names)


def write(step: Step) -> None:
    """Write a file of the page, or add to it."""
    path = Path(step.path)
    path.parent.mkdir(parents=True, exist_ok=True)
    before = path.read_text("utf-8") if step.mode == "append" else ""
    path.write_text(before + step.text, "utf-8")


def shows(step: Step, page: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Run the commands of a step and compare what they print, or put it into the page."""
    outputs = []
    for words, shown in commands(step):
        capsys.readouterr()
        carry_out(words.removesuffix(SILENCED))
        said = capsys.readouterr()
        results = "" if words.endswith(SILENCED) else said.out
        lines = (results + said.err).rstrip().splitlines()
        printed = [line.rstrip() for line in lines if not PROGRESS.match(line)]
        outputs.append(as_far_as_shown(printed, shown))
    if os.environ.get("ROPSIM_UPDATE_GOLDEN"):
        page.write_text(with_output(page.read_text("utf-8"), step, outputs), "utf-8")
        return
    for (words, shown), output in zip(commands(step), outputs, strict=True):
        assert output == shown, f"{step}: {words}"


def carry_out(words: str) -> None:
    """Run one command line, in this process."""
    program, *arguments = shlex.split(words)
    if program == "ropsim":
        main(arguments)
    else:
        assert program == "python", words
        runpy.run_path(arguments[0], run_name="__main__")


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
