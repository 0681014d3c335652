"""A robot to a NIROX file."""

from ropsim.core import Diagnostic
from ropsim.express import Population, validate
from ropsim.model import RobotModel, WrittenRobot, check_counts
from ropsim.nirox.building import Building
from ropsim.nirox.diagnostics import REFUSED
from ropsim.nirox.schema_text import NAME, nirox_schema
from ropsim.nirox.written_arm import arm_losses, write_arm, write_origins
from ropsim.nirox.written_bodies import body_losses, write_bodies
from ropsim.nirox.written_drives import drive_losses, write_drives
from ropsim.nirox.written_looks import write_looks
from ropsim.part21 import ExchangeFile, Record, write_exchange
from ropsim.version import __version__

_HINT = "`ropsim robot audit` says more of the numbers of a robot"


def write_nirox(robot: RobotModel) -> WrittenRobot:
    """Return the NIROX file of a robot in its one canonical form.

    Read again it is the same robot, to the last bit, but for what is told as lost. What is written keeps to
    the schema; where the robot does not, the text is empty and the losses name the rule.

    Args:
        robot: to be written.

    Raises:
        MechanismError: the robot cannot be.
    """
    check_counts(robot)
    building = Building()
    writing = write_arm(building, robot)
    write_bodies(building, robot)
    write_drives(building, robot)
    write_looks(building, robot)
    write_origins(building, robot)
    losses = (*writing.losses(), *drive_losses(robot), *body_losses(robot), *arm_losses(robot))
    return _written(ExchangeFile(_header(robot), building.instances()), losses)


def _header(robot: RobotModel) -> tuple[Record, ...]:
    return (
        Record("FILE_DESCRIPTION", (("neutral model of an arm",), "2;1")),
        Record("FILE_NAME", (robot.name, "", ("",), ("",), "ropsim", f"ropsim {__version__}", "")),
        Record("FILE_SCHEMA", ((NAME,),)),
    )


def _written(file: ExchangeFile, losses: tuple[Diagnostic, ...]) -> WrittenRobot:
    try:
        text = write_exchange(file)
    except ValueError as error:
        return WrittenRobot("", (REFUSED.at(None, str(error)),))
    wrong = [one for one in validate(Population(nirox_schema(), file)) if one.is_error]
    if wrong:
        return WrittenRobot("", tuple(REFUSED.at(None, one.message, hint=_HINT) for one in wrong))
    return WrittenRobot(text, losses)
