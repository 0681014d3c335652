"""`ropsim run`: compile, plan, simulate, verify, report."""

import argparse
import math
import shlex
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim import icr
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.cli.terminal.progress import Progress
from ropsim.cli.terminal.real_time import RealTime
from ropsim.core import Diagnostic
from ropsim.flow import Recording
from ropsim.records import diagnostic_document, readable
from ropsim.userfiles import KEPT_ANSWERS
from ropsim.views import Comparison, Message, messages, messages_text, result_figures
from ropsim.workbench import (
    NOT_WRITABLE,
    CompiledProgram,
    Project,
    ProjectError,
    Workspace,
    found_in,
    open_project,
    program_arm,
)

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions


def run(options: argparse.Namespace, output: Output) -> int:
    """Run a program of a project and return the exit code."""
    project = open_project(options.path, Workspace(KEPT_ANSWERS))
    sources = project.texts
    _check_places(options, project)
    project.changes(options.what_if)  # impossible changes are reported before anything runs
    programs = {} if project.is_broken else project.programs(options.program)
    before = (*project.diagnostics, *found_in(programs))
    if not programs or any(one.is_error for one in before):
        output.document({"ok": False, **diagnostic_document(before)})
        return output.findings(before, sources)
    project.workspace.keep()
    output.engine_note()
    pace = RealTime() if options.real_time else None
    recording = _simulate(project, programs, options, pace)
    if options.collisions:
        recording = _checked(project, recording)
    report = project.report(recording, before)
    if options.what_if:
        report = replace(report, comparison=_compared(project, recording, options))
    if options.report:
        report = report.drawn()
    compared = report.comparison.notes if report.comparison else ()
    findings, printed = (*report.before, *recording.findings, *compared), messages(recording)
    code = output.findings(findings, sources)
    if printed:
        output.text(f"{messages_text(printed)}\n")
    output.text(report.text(output.style))
    if pace is not None:
        output.text(pace.text())
    written = _write(options, recording, report.save)
    for path in written:
        output.text(f"wrote {path}")
    output.document(
        {
            "ok": code == 0,
            "messages": [message_entry(one) for one in printed],
            "result": readable(result_figures(report.summary)),
            "summary": readable(report.summary),
            **({"what_if": comparison_entry(report.comparison)} if report.comparison else {}),
            **({"real_time": pace.document()} if pace is not None else {}),
            "written": written,
            **diagnostic_document(findings),
        }
    )
    return code


def comparison_entry(comparison: Comparison) -> list[dict[str, object]]:
    """Return the runs with a change as mappings."""
    return [
        {
            "change": one.change,
            "cycle_time": one.cycle_time,
            "cycle_time_valid": one.valid,
            "difference": comparison.difference(one) if one.valid else None,
            "energy": _finite(one.energy),
            "energy_difference": _finite(comparison.energy_difference(one)),
            **diagnostic_document(one.findings),
        }
        for one in comparison.alternatives
    ]


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def message_entry(message: Message) -> dict[str, object]:
    """Return a message as a mapping."""
    return {
        "time": message.time,
        "text": message.text,
        "source": message.source,
        "line": message.line,
        "pass": message.visit,
    }


def _check_places(options: argparse.Namespace, project: Project) -> None:
    """Require that a recording has its ending, and that results replace neither inputs nor each other.

    Raises:
        ProjectError: X847, they would, or the recording has another ending than `.npz`.
    """
    taken = {Path(name).resolve(): f"the project's `{name}`" for name in project.texts}
    if options.inputs:
        taken[Path(options.inputs).resolve()] = "the recorded inputs"
    for place in filter(None, [options.report, options.record]):
        if Path(place).is_dir():
            message = f"`{place}` is a folder, needed is the name of a file"
            raise ProjectError(NOT_WRITABLE.at(None, message, hint=f"such as `{Path(place) / 'run'}`"))
        if Path(place).resolve() in taken:
            message = f"`{place}` would replace {taken[Path(place).resolve()]}"
            raise ProjectError(NOT_WRITABLE.at(None, message, hint="choose another place"))
        taken[Path(place).resolve()] = "the other result"
    if options.record and Path(options.record).suffix.lower() not in ("", ".npz"):
        message = f"`{options.record}` cannot hold a recording, which is an NPZ archive"
        hint = f"write `--record {shlex.quote(str(Path(options.record).with_suffix('.npz')))}`"
        raise ProjectError(NOT_WRITABLE.at(None, message, hint=hint))


def _simulate(
    project: Project,
    programs: Mapping[str, CompiledProgram],
    options: argparse.Namespace,
    pace: RealTime | None,
) -> Recording:
    cell, codes = project.runnable(programs)
    with Progress(f"simulating {project.folder.resolve().name}") as progress:
        progress(0.0, "preparing the arm (compiled once, then cached)")
        from ropsim.codegen import compiling_reported
        from ropsim.simulation import run as simulate

        arms = {name: program_arm(code, cell, cell.stations[name]) for name, code in codes.items()}
        traces = [icr.run(code, icr.StillWorld(arm=arms[name])) for name, code in codes.items()]
        given = _run_options(options, _counted(traces, progress))
        if pace is None:
            return simulate(cell, codes, given)
        with compiling_reported(pace.compiled):
            return simulate(cell, codes, pace.paced(given))


def _checked(project: Project, recording: Recording) -> Recording:
    with Progress(f"checking collisions, {project.folder.resolve().name}") as progress:
        return project.checked(recording, lambda share: progress(share, "ways"))


def _compared(project: Project, recording: Recording, options: argparse.Namespace) -> Comparison:
    with Progress(f"what if, {project.folder.resolve().name}") as progress:
        printed = _run_options(options, lambda text: progress(0.0, text))
        return project.what_if(options.what_if, options.program, printed, recording)


def _run_options(options: argparse.Namespace, progress: Callable[[str], None]) -> "RunOptions":
    from ropsim.flow import Interventions
    from ropsim.records import read_inputs, with_inputs
    from ropsim.simulation import Fidelity, RunOptions

    given = read_inputs(options.inputs) if options.inputs else Interventions()
    fidelity = Fidelity.KINEMATIC if options.kinematic else Fidelity.DYNAMIC
    return with_inputs(RunOptions(fidelity, progress=progress), given)


def _counted(traces: Collection[icr.DryRun], progress: Callable[[float, str], None]) -> Callable[[str], None]:
    """Return a progress with the total number of moves, from runs without robots."""
    # a trace that ends early, at an input without a value there, has no total number of moves
    total = 0 if any(trace.trap for trace in traces) else sum(len(trace.moves) for trace in traces)
    done = 0

    def step(text: str) -> None:
        nonlocal done
        done += 1
        progress(*((min(done / total, 1.0), f"{text} of {total}") if total else (0.0, text)))

    return step


def _write(
    options: argparse.Namespace, recording: Recording, save_report: Callable[[str], None]
) -> list[str]:
    from ropsim.records import write_recording

    written: list[str] = []
    if options.report:
        _guarded(options.report, lambda: save_report(options.report))
        written.append(options.report)
    if options.record:
        _guarded(options.record, lambda: write_recording(recording, options.record))
        written.append(options.record)
    return written


def _guarded(path: str, write: Callable[[], None]) -> None:
    try:
        write()
    except OSError as error:
        problem: Diagnostic = cannot_write(path, error)
        raise ProjectError(problem) from error
