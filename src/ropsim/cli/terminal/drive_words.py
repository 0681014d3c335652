"""Words of the command line on the drives of an arm."""

from ropsim.cli.terminal.coordinates import shown
from ropsim.core import plural
from ropsim.model import (
    BacklashGear,
    BallScrew,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    Elastic,
    HydraulicCylinder,
    HydraulicMotor,
    HydraulicVane,
    LaggingMotor,
    Linkage,
    RobotModel,
    ThermalDcMotor,
)

NO_DRIVES = "drives: none known, the arm is exactly where it is told to be"


def drive_lines(robot: RobotModel) -> list[str]:
    """Return a line for each kind of drive, with its axes if there are several."""
    if not robot.drives:
        return [NO_DRIVES]
    kinds: dict[str, list[int]] = {}
    for axis, drive in enumerate(robot.drives):
        kinds.setdefault(_kind(drive), []).append(axis)
    lines = []
    for kind, axes in kinds.items():
        names = ", ".join(robot.axis_joints[axis].name for axis in axes)
        where = f" ({plural(len(axes), 'joint')}: {names})" if len(kinds) > 1 else ""
        lines.append(f"drives: {kind}{_ratios([robot.drives[axis] for axis in axes])}{where}")
    return lines


def _kind(drive: Drive) -> str:
    """Return the kind of a drive, in the plural."""
    gear = drive.transmission
    gears = "elastic gears" if isinstance(gear, Elastic) else "gears"
    if isinstance(gear, BacklashGear):
        gears = "elastic gears with play"
    if isinstance(gear, BallScrew):
        gears = "ball screws"
    if not isinstance(gear, BallScrew | Elastic | Linkage) and abs(gear.ratio) == 1.0:
        gears = "directly at the joints"
    match drive.motor:
        case HydraulicCylinder():
            return "hydraulic cylinders at servo valves"
        case HydraulicVane():
            return f"rotary vane motors at servo valves, {gears}"
        case HydraulicMotor():
            return f"hydraulic motors at servo valves, {gears}"
        case CurrentLoopMotor() | LaggingMotor():
            return f"motors in current loops, {gears}"
        case ThermalDcMotor():
            return f"DC motors that grow warm, {gears}"
        case DcMotor():
            return f"DC motors, {gears}"
        case _:
            return f"motors that give the torque they are told, {gears}"


def _ratios(drives: list[Drive]) -> str:
    """Return the span of the ratios of gears; empty for linkages, and where motors drive directly."""
    gears = [one.transmission for one in drives if not isinstance(one.transmission, BallScrew | Linkage)]
    sizes = sorted(abs(one.ratio) for one in gears)
    if not sizes or sizes[-1] == 1.0:
        return ""
    least, most = (f"{shown(size, 2):g}" for size in (sizes[0], sizes[-1]))
    return f" of {least} to 1" if least == most else f" of {least} to {most} to 1"
