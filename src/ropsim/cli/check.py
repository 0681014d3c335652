"""`ropsim check`: compile and print diagnostics."""

import argparse

from ropsim.cli.output import Output
from ropsim.cli.watch import watch
from ropsim.records import diagnostic_document
from ropsim.userfiles import kept_by_user
from ropsim.views import count_text
from ropsim.workbench import Workspace, open_project


def check(options: argparse.Namespace, output: Output) -> int:
    """Compile every program of a project and return the exit code."""
    if options.watch:
        return watch(options, output)
    project = open_project(options.path, Workspace(kept_by_user()))
    compiled = project.compile()
    code = output.findings(compiled.diagnostics, project.texts)
    if code == 0:
        names = ", ".join(sorted(compiled.programs)) or "no program"
        others = f", {count_text(compiled.diagnostics)}" if compiled.diagnostics else ""
        output.text(f"checked {names}: no errors{others}")
    output.document(
        {"ok": code == 0, "programs": sorted(compiled.programs), **diagnostic_document(compiled.diagnostics)}
    )
    project.workspace.keep()
    return code
