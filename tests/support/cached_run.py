"""Run a small project with a fault at one call of its cache; print what came of it.

Arguments: PROJECT FAULT CALL, where the call is a number from 1. The cache folder is that of the environment.
"""

import json
import sys
from collections.abc import Callable, Mapping
from hashlib import sha256
from pathlib import Path

from ropsim.core import kept_findings
from ropsim.core.disk import user_folders
from ropsim.flow import Fidelity
from ropsim.records import recording_bytes
from ropsim.simulation import RunOptions
from ropsim.userfiles import KEPT_ANSWERS
from ropsim.workbench import Workspace, open_project
from ropsim.workbench.testing import LEAST_LINES
from support.counted_system import FAULTS, counted, number

_LONG = "# a line\n" * LEAST_LINES
TEXTS = {
    "cell.toml": '[robot]\nmodel = "puma560"\n',
    "programs/main.task": f"program main\nunits mm, deg, s\nmov (400, 0, 300)\nwave (450, 100, 300)\n{_LONG}",
    "kb/own.pl": "task(wave(L), [params([L-location]), body([mov(L)])]).\n",
}
"""Texts of a project: machine code, answers of the compiler and Prolog serve its run."""


def write_project(folder: Path, texts: Mapping[str, str]) -> Path:
    """Write a project into a folder and return it."""
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")
    return folder


def run_of(project: Path) -> tuple[str, list[str]]:
    """Return the digest of the recording of a run, with what it found, and the codes of its text."""
    workspace = Workspace(KEPT_ANSWERS)
    opened = open_project(project, workspace)
    compiled = opened.compile()
    recording = opened.simulate(options=RunOptions(fidelity=Fidelity.KINEMATIC))
    workspace.keep()
    return sha256(recording_bytes(recording)).hexdigest(), [one.code for one in compiled.diagnostics]


def main() -> None:
    """Run with a fault and print digest, findings, calls, and why nothing was kept, as JSON."""
    project, fault, call = sys.argv[1:]
    folder = user_folders.cache_folder()
    acted: Callable[[str], None] = FAULTS[fault](folder)
    with counted(folder, number(int(call)), acted) as counting:
        digest, codes = run_of(Path(project))
    found = {
        "digest": digest,
        "codes": codes,
        "calls": len(counting.names),
        "places": counting.places,
        "why": [one.code for one in kept_findings()],
    }
    sys.stdout.write(json.dumps(found))
