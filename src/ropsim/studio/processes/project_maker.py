"""A new project is made in a process of its own, where its first program is tried, not in the web process."""

import multiprocessing
from multiprocessing.connection import Connection
from pathlib import Path

from ropsim.core import Diagnostic, RopsimError
from ropsim.studio.diagnostics import WORKER_LOST
from ropsim.studio.processes.child import Child


def project_made(place: Path, example: str, robot: str, neutral: Path) -> Path:
    """Return the folder of a project that was made; this waits for it.

    Args:
        place: where to.
        example: whose copy it becomes where no robot is named.
        robot: built-in robot that it is for; empty for none.
        neutral: working folder of the process, where no project lies.

    Raises:
        RopsimError: it cannot be made there, or nothing of these names is there.
    """
    near, far = multiprocessing.Pipe()
    child = Child("ropsim project", f"{__name__}:make", far, str(neutral))
    with near:
        near.send((place, example, robot))
        try:
            made = near.recv()
        except (EOFError, OSError):
            words = "the process that makes the project has ended unexpectedly"
            made = WORKER_LOST.at(None, words, hint="look what is in the folder, and try again")
    child.exit_code()
    if isinstance(made, Diagnostic):
        raise RopsimError(made)
    return Path(made)


def make(far: Connection) -> None:
    """Make the project that is requested, in this process, and answer with its folder or a finding."""
    from ropsim.workbench import new_project, new_robot_project

    place, example, robot = far.recv()
    try:
        far.send(new_robot_project(place, robot) if robot else new_project(place, example))
    except RopsimError as error:
        far.send(error.diagnostic)
