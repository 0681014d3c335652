"""`ropsim new` and `ropsim examples`: start from something that runs."""

import argparse
import shlex

from ropsim.cellfile import is_foreign_file
from ropsim.cli.terminal.named_robot import asked_robot, requested
from ropsim.cli.terminal.output import Output
from ropsim.userfiles import STARTER, example_names, example_summary
from ropsim.workbench import added_estimates, new_project, new_robot_project


def new(options: argparse.Namespace, output: Output) -> int:
    """Make a project folder from an example, or for a robot."""
    if options.robot:
        options.name = options.robot
        asked = asked_robot(options, output)
        if asked.robot is None:
            return 1
        place = new_robot_project(options.path, requested(options, options.robot))
        if is_foreign_file(options.robot) and (added := added_estimates(asked.robot)):
            names = ", ".join(one.parameters for one in added)
            words = "for a rated payload: `ropsim robot estimate`"
            output.text(f"the file has no motors; estimated are {names} ({words})")
    else:
        place = new_project(options.path, options.example or STARTER)
    output.text(f"made {place}; next: ropsim run {shlex.quote(str(place))}")
    output.document({"ok": True, "path": str(place)})
    return 0


def examples(options: argparse.Namespace, output: Output) -> int:
    """List the examples."""
    del options
    width = max(map(len, example_names()))
    output.text("\n".join(f"{name:{width}}  {example_summary(name)}" for name in example_names()))
    output.document({"examples": {name: example_summary(name) for name in example_names()}})
    return 0
