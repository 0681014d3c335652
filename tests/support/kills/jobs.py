"""What the program writes: programs, journal, reports, recordings, cache and the list of trusted folders."""

import asyncio
import os
from contextlib import closing
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from ropsim.codegen import Engine, SourceFunction, load
from ropsim.flow import Recording
from ropsim.records import read_recording, recording_bytes, write_recording
from ropsim.studio.testing import Documents, Overwriting
from ropsim.userfiles import Draft, Journal, Trust, set_trust, trust_in
from ropsim.workbench import open_project
from ropsim.workbench.testing import Report
from support.kills.job import Job, Progress, Tell
from support.recordings import SOURCE, pick_and_place

MAIN = "programs/main.task"
OLD, NEW = "program main\nwait 1\n", "program main\nwait 2\n# " + 300 * "more words, " + "\n"
_CELL = '[robot]\nmodel = "puma560"\n'


def _project(folder: Path) -> Path:
    os.environ["ROPSIM_STATE_HOME"] = str(folder / "state")
    os.environ["ROPSIM_CONFIG_HOME"] = str(folder / "config")
    return folder / "cell"


def _prepare_project(folder: Path) -> None:
    project = _project(folder)
    (project / "programs").mkdir(parents=True)
    (project / "cell.toml").write_text(_CELL, "utf-8")
    (project / MAIN).write_text(OLD, "utf-8")


def _check_project(folder: Path) -> str:
    """Return the text of the program; the project must be as whole as before."""
    project = _project(folder)
    names = {one.name for one in project.rglob("*") if one.is_file() and not one.name.startswith(".ropsim-")}
    assert names == {"cell.toml", "main.task"}, names
    opened = open_project(project)
    assert not opened.diagnostics, opened.diagnostics
    assert list(opened.sources) == ["main"], opened.sources
    return (project / MAIN).read_text("utf-8")


def _edit_and_save(folder: Path, tell: Tell) -> None:
    """Do what a session does: keep the edit in the journal, save it, then take it out of the journal."""
    documents = Documents(_project(folder))
    asyncio.run(documents.look())
    with closing(Journal(_project(folder))) as journal:
        document, _ = documents.edit(MAIN, NEW, 1)
        assert document is not None
        journal.write(documents.drafts)
        tell(Progress.PROMISED)
        finding = asyncio.run(documents.save(document, Overwriting.REFUSED))
        assert finding is None, finding
        journal.write(documents.drafts)


def _check_save(folder: Path, progress: Progress) -> None:
    written = _check_project(folder)
    documents = Documents(_project(folder))
    asyncio.run(documents.look())
    with closing(Journal(_project(folder))) as journal:
        drafts, findings = journal.read()
    assert findings == (), findings
    documents.recover(drafts)
    document, _ = documents.find(MAIN)
    assert document is not None
    assert written in {OLD, NEW}, "half-written"
    assert document.text in {OLD, NEW}, "half-written"
    if progress is not Progress.BEGUN:
        assert document.text == NEW, "the text is lost"


def _journal(folder: Path, tell: Tell) -> None:
    with closing(Journal(_project(folder))) as journal:
        for number in range(3):
            journal.write({MAIN: Draft(f"{number} {NEW}", ""), "cell.toml": Draft(_CELL, "")})
            tell(Progress.PROMISED)


def _check_journal(folder: Path, progress: Progress) -> None:
    assert _check_project(folder) == OLD
    with closing(Journal(_project(folder))) as journal:
        drafts, findings = journal.read()
    assert findings == (), findings
    texts = [draft.text for draft in drafts.values()]
    assert progress is Progress.BEGUN or drafts.keys() == {MAIN, "cell.toml"}, "the drafts are lost"
    assert not texts or texts[0] in {f"{number} {NEW}" for number in range(3)}, "half-written"


@cache
def _recordings() -> tuple[Recording, Recording]:
    first = pick_and_place(1, 10.0)
    return first, replace(first, facts=replace(first.facts, project="another"))


@cache
def _pages() -> tuple[Report, Report]:
    first, second = (Report.of(one, {SOURCE.name: SOURCE}) for one in _recordings())
    return first, second


def _either(path: Path, contents: tuple[bytes, bytes], progress: Progress) -> None:
    found = path.read_bytes()
    assert found in contents, "half-written"
    assert progress is not Progress.DONE or found == contents[1], "not written"


def _prepare_recording(folder: Path) -> None:
    write_recording(_recordings()[0], folder / "run.npz")


def _record(folder: Path, tell: Tell) -> None:
    write_recording(_recordings()[1], folder / "run.npz")


def _check_recording(folder: Path, progress: Progress) -> None:
    first, second = (recording_bytes(one) for one in _recordings())
    _either(folder / "run.npz", (first, second), progress)
    assert read_recording(folder / "run.npz").duration == _recordings()[0].duration


def _prepare_report(folder: Path) -> None:
    _pages()[0].save(folder / "report.html")


def _report(folder: Path, tell: Tell) -> None:
    replace(_pages()[1], sources={}).save(folder / "report.html")


def _check_report(folder: Path, progress: Progress) -> None:
    pages = _pages()[0].html().encode(), replace(_pages()[1], sources={}).html().encode()
    _either(folder / "report.html", pages, progress)


def _prepare_nothing(folder: Path) -> None:
    (folder / "cache").mkdir()


def _generate(folder: Path, tell: Tell) -> None:
    os.environ["ROPSIM_CACHE_DIR"] = str(folder / "cache")
    double = SourceFunction("double", "void(f8[::1], f8[::1])", "def double(x, out): out[0] = 2.0 * x[0]")
    out = np.empty(1)
    load("doubling", (double,), Engine.NUMBA)(np.array([21.0]), out)
    assert out[0] == 42.0


def _check_cache(folder: Path, progress: Progress) -> None:
    _generate(folder, lambda _: None)


def _trust(folder: Path, tell: Tell) -> None:
    set_trust(_project(folder), Trust.GIVEN)


def _prepare_trust(folder: Path) -> None:
    _prepare_project(folder)
    other = _project(folder).parent / "other"
    other.mkdir()
    (other / "cell.toml").write_text(_CELL, "utf-8")
    set_trust(other, Trust.GIVEN)


def _check_trust(folder: Path, progress: Progress) -> None:
    project = _project(folder)
    assert trust_in(project.parent / "other") is Trust.GIVEN, "the list is lost"
    assert progress is not Progress.DONE or trust_in(project) is Trust.GIVEN


JOBS = {
    one.name: one
    for one in (
        Job("save", _prepare_project, _edit_and_save, _check_save),
        Job("journal", _prepare_project, _journal, _check_journal),
        Job("report", _prepare_report, _report, _check_report),
        Job("recording", _prepare_recording, _record, _check_recording),
        Job("cache", _prepare_nothing, _generate, _check_cache),
        Job("trust", _prepare_trust, _trust, _check_trust),
    )
}
