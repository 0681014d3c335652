"""A project made ready to run: opened with its unsaved texts and compiled."""

from collections.abc import Callable, Mapping
from pathlib import Path

from ropsim import icr
from ropsim.core import Diagnostic, RopsimError, frozen_dataclass, kept_from_collection
from ropsim.flow import Recording
from ropsim.model import Cell
from ropsim.records import inputs_of
from ropsim.simulation import needs_check
from ropsim.studio.wire.jobs import InputChange, LiveStart, Simulate
from ropsim.studio.wire.replies import RunReply
from ropsim.views import plain_findings
from ropsim.workbench import Project, Workspace, found_in, open_overlaid, pack_of

MOST_ROWS = 400_000
"""Recorded rows of a run in the studio: 26 minutes at the full rate, 53 at half of it, and so on."""


@frozen_dataclass
class Runnable:
    """A program that can run.

    Attributes:
        project: as it would be if the texts were saved.
        name: of the program.
        cell: where it runs.
        codes: verified code of the programs, by station.
        findings: warnings of reading and compiling.
    """

    project: Project
    name: str
    cell: Cell
    codes: Mapping[str, icr.Program]
    findings: tuple[Diagnostic, ...]

    @property
    def code(self) -> icr.Program:
        """Return the verified code of the program that has the name."""
        return self.codes[self.cell.station_of(self.name).name]

    def finished(self, recording: Recording) -> RunReply:
        """Return the reply to a run of this program."""
        pack = pack_of(self.project, recording, self.findings)
        inputs, ways = used_inputs(recording), not needs_check(recording)
        results = results_of(recording)
        return RunReply("done", self.name, pack=pack, inputs=inputs, ways=ways, results=results)


def results_of(recording: Recording) -> Mapping[str, tuple[str, ...]]:
    """Return the keys of the lines of the programs of a run, by document, each key once.

    A program without an executed line has no keys, although it belongs to the run.
    """
    found: dict[str, set[str]] = {}
    for station in recording.facts.stations:
        keys = recording.content.results.get(station.name, {})
        found.setdefault(station.source, set()).update(keys.values())
    return {source: tuple(sorted(keys)) for source, keys in found.items() if source}


def used_inputs(recording: Recording) -> tuple[InputChange, ...]:
    """Return the changes of inputs that a run was given and has used."""
    return tuple(InputChange(one.signal, one.time, one.value) for one in inputs_of(recording).inputs)


def run_job(job: Simulate | LiveStart, workspace: Workspace, run: Callable[[Runnable], RunReply]) -> RunReply:
    """Return the reply to a run; a program with errors is refused, and so is one that its arm cannot run.

    Args:
        job: folder, texts and program.
        workspace: that has read the project before.
        run: carries the program out.
    """
    try:
        ready = made_ready(job, workspace)
        return ready if isinstance(ready, RunReply) else run(ready)
    except RopsimError as error:
        return RunReply("refused", job.program, findings=plain_findings([error.diagnostic]))


def made_ready(job: Simulate | LiveStart, workspace: Workspace) -> Runnable | RunReply:
    """Return the program of a job, opened and compiled, or why it is refused.

    Raises:
        RopsimError: the project or program does not exist.
    """
    with kept_from_collection():  # the workspace keeps results for the texts
        return _made_ready(job, workspace)


def _made_ready(job: Simulate | LiveStart, workspace: Workspace) -> Runnable | RunReply:
    project = open_overlaid(Path(job.folder), job.texts, workspace)
    if project.is_broken:
        return RunReply("refused", job.program, findings=plain_findings(project.diagnostics))
    compiled = project.program(job.program or None)
    name = next(key for key, text in project.sources.items() if text == compiled.source)
    programs = project.programs(job.program or None)
    findings = (*project.diagnostics, *found_in(programs))
    if any(one.is_error for one in findings):
        return RunReply("refused", name, findings=plain_findings(findings))
    cell, codes = project.runnable(programs)
    return Runnable(project, name, cell, codes, findings)
