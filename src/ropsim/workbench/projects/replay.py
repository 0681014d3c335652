"""Packs of a project's runs: what `ropsim studio` sends to its page."""

from collections.abc import Iterable

from ropsim.core import Diagnostic
from ropsim.flow import Recording
from ropsim.workbench.project_diagnostics import NO_CELL
from ropsim.workbench.projects.project import Project, ProjectError


def pack_of(project: Project, recording: Recording, findings: Iterable[Diagnostic] = ()) -> bytes:
    """Return the pack of a run of a project; equal recordings give equal bytes.

    Args:
        project: of which the recording is a run.
        recording: as it was simulated.
        findings: of compiling, listed before those of the run.

    Raises:
        ProjectError: the project has no cell.
    """
    if project.cell is None:
        raise ProjectError(NO_CELL.at(None, f"`{project.folder}` has no cell to show a run in"))
    from ropsim.records import pack_bytes
    from ropsim.views import summarize

    before = tuple(findings)
    return pack_bytes(project.cell, recording, summarize(recording, before), before)
