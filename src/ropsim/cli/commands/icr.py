"""`ropsim icr`: compile, verify and run the neutral robot program, and its two forms."""

import argparse
from collections.abc import Iterator, Mapping
from pathlib import Path

from ropsim import icr, language
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.core import Diagnostic, SourceText, replace_file
from ropsim.flow import (
    GripInstruction,
    Instruction,
    MessageInstruction,
    MoveInstruction,
    OutputInstruction,
    WaitInstruction,
)
from ropsim.records import diagnostic_document
from ropsim.spatial import Pose, quaternion
from ropsim.userfiles import KEPT_ANSWERS, read_program_file
from ropsim.workbench import CompiledProgram, ProjectError, Workspace, open_project

_BINARY = ".icb"
"""Ending of binary programs."""


def compile_(options: argparse.Namespace, output: Output) -> int:
    """Print or write the ICR of a task program."""
    texts, compiled = _open(options.path)
    code = output.findings(compiled.diagnostics, texts)
    text = icr.disassemble(compiled.icr) if compiled.icr is not None and code == 0 else ""
    if text and options.output:
        _write(options.output, text.encode())
    elif text:
        output.text(text.rstrip())
    output.document({"ok": code == 0, "icr": text, **diagnostic_document(compiled.diagnostics)})
    return code


def asm(options: argparse.Namespace, output: Output) -> int:
    """Write the binary form of a program."""
    texts, compiled = _open(options.path)
    code = output.findings(compiled.diagnostics, texts)
    content, identity = b"", ""
    found = compiled.diagnostics
    if code == 0 and compiled.icr is not None:
        try:
            content, identity = icr.encoded(compiled.icr), icr.program_id(compiled.icr)
        except icr.UnverifiedError as error:
            found = (*found, *error.diagnostics)
            code = output.findings(error.diagnostics, texts)
    if content:
        _write(options.output, content)
        output.text(f"wrote {options.output}: {len(content)} bytes, id {identity}")
    output.document({"ok": code == 0, "id": identity, "bytes": len(content), **diagnostic_document(found)})
    return code


def dis(options: argparse.Namespace, output: Output) -> int:
    """Print or write the text of a binary program."""
    return compile_(options, output)


def verify(options: argparse.Namespace, output: Output) -> int:
    """Verify a program against rules V1 to V9."""
    texts, compiled = _open(options.path)
    code = output.findings(compiled.diagnostics, texts)
    identity = ""
    if code == 0 and compiled.icr is not None:
        identity = icr.program_id(compiled.icr)
        output.text(f"`{compiled.icr.name}` is a valid program, id {identity}")
    output.document({"ok": code == 0, "id": identity, **diagnostic_document(compiled.diagnostics)})
    return code


def run(options: argparse.Namespace, output: Output) -> int:
    """Execute a program without a robot and print the instructions in order."""
    texts, compiled = _open(options.path)
    code = output.findings(compiled.diagnostics, texts)
    if code or compiled.icr is None:
        output.document({"ok": False, **diagnostic_document(compiled.diagnostics)})
        return 1
    trace = icr.run(compiled.icr)
    lines = [instruction_text(one) for one in trace.instructions]
    output.text("\n".join([" line pass  instruction", *lines]))
    output.text(f"{len(trace.moves)} moves, {len(trace.grips)} gripper actions; {trace.steps} machine steps")
    traps: tuple[Diagnostic, ...] = (trace.trap,) if trace.trap else ()
    code = output.findings(traps, texts)
    output.document(
        {"ok": code == 0, "instructions": lines, "steps": trace.steps, **diagnostic_document(traps)}
    )
    return code


def instruction_text(one: Instruction) -> str:
    """Return one line for an instruction: source line, pass, operation; millimetres and degrees.

    Joint coordinates and values of external axes are in rad and m: only a robot determines which.
    """
    place = f"{one.origin.span.line if one.origin.span else 0:>5} #{one.origin.visit:<4}"
    match one:
        case MoveInstruction():
            what = " ".join([_target_text(one), *_path_words(one)])
        case GripInstruction():
            what = f"{one.action.value} {one.tool}".rstrip()
        case OutputInstruction():
            what = f"set {one.channel} = {one.value}"
        case WaitInstruction():
            what = f"wait {one.duration:g} s"
        case MessageInstruction():
            what = f"message {one.text!r}"
        case _:
            what = "sync"
    return f"{place} {what}"


def _target_text(move: MoveInstruction) -> str:
    if move.target is None:
        return f"{move.kind} home"
    if not isinstance(move.target, Pose):
        return f"{move.kind} joints {move.target}"
    w, i, j, k = (float(c) for c in move.target.orientation)
    yaw, pitch, roll = (57.29577951308232 * angle for angle in quaternion.to_zyx((w, i, j, k)))
    what = f"{move.kind} {_place_text(move.target)} mm, roll {roll:.2f} pitch {pitch:.2f} yaw {yaw:.2f} deg"
    what += f" in {move.modal.frame}" if move.modal.frame else ""
    return what + (f" external ({', '.join(f'{e:.6g}' for e in move.external)})" if move.external else "")


def _path_words(move: MoveInstruction) -> Iterator[str]:
    """Yield the words on the path of a move."""
    if move.modal.passes:
        yield "passing by"
    if move.via:
        yield "via " + ", ".join(map(_place_text, move.via)) + " mm"
    if move.angle is not None:
        yield f"angle {57.29577951308232 * move.angle:.2f} deg"
    for one in move.triggers:
        place = f"{one.time:g} s" if one.distance is None else f"{1e3 * one.distance:g} mm"
        yield f"at {place} {one.side.value} set {one.channel} = {one.value}"
    if move.posture is not None and move.posture.words:
        yield f"config ({', '.join(move.posture.words)})"
    if move.posture is not None and move.posture.turns:
        yield f"turns ({', '.join(map(str, move.posture.turns))})"
    if move.guard is not None:
        limit = "" if move.guard.timeout is None else f" timeout {move.guard.timeout:g} s"
        yield f"until {move.guard.channel} {move.guard.comparison.value} {move.guard.value}{limit}"
    if move.tracking is not None:
        by = move.tracking
        yield f"track {by.channel} = {by.value:g} along {by.direction} gain {by.gain:g}"


def _place_text(pose: Pose) -> str:
    x, y, z = (1e3 * float(c) for c in pose.position)
    return f"x {x:.3f} y {y:.3f} z {z:.3f}"


def _open(path: str) -> tuple[Mapping[str, SourceText], CompiledProgram]:
    """Return the texts of a project and its program; a binary program has no texts."""
    if path.endswith(_BINARY) and Path(path).exists():
        return {}, _read_binary(path)
    project = open_project(path, Workspace(KEPT_ANSWERS))
    program = project.program()
    project.workspace.keep()
    return project.texts, program


def _read_binary(path: str) -> CompiledProgram:
    content, found = read_program_file(Path(path), path)
    program = None
    if content is not None:
        program, found = icr.read_binary(content, path)
    if program is not None:
        found = icr.verify(program)
    code = language.Code.known(program) if program is not None else None
    return CompiledProgram(SourceText(path, ""), code, found)


def _write(path: str, content: bytes) -> None:
    try:
        replace_file(Path(path), content)
    except OSError as error:
        raise ProjectError(cannot_write(path, error)) from error
