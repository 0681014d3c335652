"""A robot to a NIROX file."""

from ropsim.core import Diagnostic
from ropsim.express import Population, validate
from ropsim.model import RobotModel, WrittenRobot, check_counts
from ropsim.nirox.diagnostics import LOST, REFUSED
from ropsim.nirox.further_data import NOTHING, FurtherData
from ropsim.nirox.rejoined import rejoined
from ropsim.nirox.schema_text import NAME, nirox_schema
from ropsim.nirox.writers.built import built
from ropsim.part21 import ExchangeFile, Record, write_exchange
from ropsim.version import __version__

_HINT = "`ropsim robot audit` says more of the numbers of a robot"


def write_nirox(robot: RobotModel, further: FurtherData = NOTHING) -> WrittenRobot:
    """Return the NIROX file of a robot in its one canonical form.

    Read again it is the same robot, to the last bit, except for reported losses. The text conforms to the
    schema; if the robot does not, the text is empty and the losses name the rule.

    Args:
        robot: to be written.
        further: other data of the file that it comes from, written again.

    Raises:
        MechanismError: the robot cannot be.
    """
    check_counts(robot)
    frames = tuple(one for one in further.frames if one.link < len(robot.joints))
    made = built(robot, frames)
    instances, gone = rejoined(made.building, further)
    losses = [*made.losses]
    if gone:
        names = ", ".join(f"#{one.number} {one.keyword[:60]}" for one in gone[:6])
        words = f"{len(gone)} kept entities refer to what the robot no longer has: {names}"
        losses.append(LOST.at(None, words))
    return _written(ExchangeFile(_header(robot), instances), tuple(losses))


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
