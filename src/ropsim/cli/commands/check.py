"""`ropsim check`: compile and print diagnostics."""

import argparse

from ropsim.cli.terminal.output import Output
from ropsim.cli.terminal.watch import watch
from ropsim.records import diagnostic_document
from ropsim.userfiles import KEPT_ANSWERS
from ropsim.views import count_text
from ropsim.workbench import Workspace, open_project, task_findings


def check(options: argparse.Namespace, output: Output) -> int:
    """Compile every program of a project and return the exit code."""
    if options.watch:
        return watch(options, output)
    project = open_project(options.path, Workspace(KEPT_ANSWERS))
    compiled = project.compile()
    more, texts = task_findings(project)
    found = (*compiled.diagnostics, *more)
    code = output.findings(found, {**project.texts, **texts})
    if code == 0:
        names = ", ".join(sorted(compiled.programs)) or "no program"
        tasks = f", {len(texts)} of tasks" if texts else ""
        others = f", {count_text(found)}" if found else ""
        output.text(f"checked {names}{tasks}: no errors{others}")
    output.document({"ok": code == 0, "programs": sorted(compiled.programs), **diagnostic_document(found)})
    project.workspace.keep()
    return code
