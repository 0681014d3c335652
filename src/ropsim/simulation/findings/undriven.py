"""Robots without drives: they are where their references are, which is reported once per run."""

from collections.abc import Iterator

from ropsim.core import Diagnostic, Severity, define
from ropsim.flow import Fidelity
from ropsim.model import ROBOT, Cell

NO_DRIVES = define(
    "S750",
    "dynamics-not-simulated",
    Severity.HINT,
    "a robot has no drives, so it follows its references exactly",
    """
The model of the robot has no motors and gears, as one that was made from a DH table and limits only. Motion
is planned within the limits of its joints, cycle times are those of the plan, and torques, currents, path
errors and settling are not simulated: the arm is where its reference is.

Give the robot file `links` with masses and `drives` to simulate them. Nothing needs to be done where reach,
postures and cycle times are all that is asked for.
""",
)


def undriven(cell: Cell, fidelity: Fidelity) -> Iterator[Diagnostic]:
    """Yield a hint for each robot without drives in a run that was to simulate them.

    Args:
        cell: that is run.
        fidelity: that was requested.
    """
    if fidelity is Fidelity.KINEMATIC:
        return
    for name, station in cell.stations.items():
        if not station.robot.drives:
            where = "" if name == ROBOT else f" of station `{name}`"
            yield NO_DRIVES.at(
                None,
                f"`{station.robot.name}`{where} has no drives: its dynamics are not simulated",
                hint="its file may give `links` with masses and `drives`",
            )
