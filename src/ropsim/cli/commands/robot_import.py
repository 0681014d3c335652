"""`ropsim robot import`: a robot of another format becomes a file of a project, with its meshes."""

import argparse
from pathlib import Path

from ropsim.cli.commands.robot_export import wrote
from ropsim.cli.terminal.named_robot import asked_robot
from ropsim.cli.terminal.output import Output, cannot_write
from ropsim.workbench import RobotFileError, carried, plain_name, project_of_robot


def import_(options: argparse.Namespace, output: Output) -> int:
    """Write a robot into a file of a project, and copy its meshes beside it."""
    asked = asked_robot(options, output)
    if asked.robot is None:
        return 1
    file = Path(options.file or f"robots/{plain_name(Path(options.name))}.stp")
    moved = carried(asked.robot, asked.mesh_root, file)
    options.file = str(file)
    code = wrote(asked, moved.robot, options, output)
    if code == 0:
        try:
            moved.copy(project_of_robot(file))
        except OSError as error:
            raise RobotFileError(cannot_write(str(error.filename or file), error)) from error
    return code
