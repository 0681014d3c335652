"""Packs of a project's runs, sent by `ropsim studio` to its page."""

from collections.abc import Iterable

from ropsim.core import Diagnostic
from ropsim.flow import Recording
from ropsim.workbench.project_diagnostics import NO_CELL
from ropsim.workbench.projects.project import Project, ProjectError


def pack_of(project: Project, recording: Recording, findings: Iterable[Diagnostic] = ()) -> bytes:
    """Return the pack of a run of a project; equal recordings have equal bytes.

    Args:
        project: of which the recording is a run.
        recording: recording of the run.
        findings: of compiling, listed before findings of the run.

    Raises:
        ProjectError: the project has no cell.
    """
    if project.cell is None:
        raise ProjectError(NO_CELL.at(None, f"`{project.folder}` has no cell to show a run in"))
    from ropsim.records import pack_bytes
    from ropsim.views import summarize

    before = tuple(findings)
    return pack_bytes(project.cell, recording, summarize(recording, before), before)
