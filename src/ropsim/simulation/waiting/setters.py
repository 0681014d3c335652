"""Sources of a signal, their levels and conditions: reported for an endless wait."""

from collections.abc import Mapping
from itertools import pairwise

from ropsim.icr import Constant, Program
from ropsim.model import BeltDrive, IndexDrive, SwitchDrive
from ropsim.simulation.devices.device_run import DeviceRun
from ropsim.simulation.state.cell_run import CellRun

BOTH = frozenset({False, True})


def levels_set(program: Program, channel: str) -> frozenset[bool]:
    """Return the levels to which a program sets a channel; both where the level is worked out as it runs."""
    found: set[bool] = set()
    for procedure in program.procedures:
        code = procedure.code
        jumped_to = {step.operands[0] for step in code if step.mnemonic.startswith("J") and step.operands}
        for place, (before, step) in enumerate(pairwise(code), 1):
            if step.mnemonic != "OUT" or step.operands[0] != channel:
                continue
            level = before.operands[0] if before.mnemonic == "PUSH" and place not in jumped_to else None
            if not isinstance(level, Constant):
                return BOTH
            found.add(bool(level.value))
    return frozenset(found)


def program_setters(programs: Mapping[str, Program], channel: str, *levels: bool) -> list[str]:
    """Return the stations whose programs set a channel to one of some levels."""
    return [name for name, program in programs.items() if levels_set(program, channel) & {*levels}]


def device_note(run: CellRun, at: DeviceRun, channel: str, level: object, time: float) -> tuple[str, str]:
    """Return why a device does not bring a signal to a level, and a hint.

    Args:
        run: the cell.
        at: the device, which has nothing left to do.
        channel: the signal that it sets.
        level: that is waited for.
        time: [s].
    """
    name, drive = at.device.name, at.device.drive
    match drive:
        case BeltDrive() if not level:
            note = f"`{channel}` stays on as long as a part is in the barrier of the device `{name}`"
            return note, f"let a gripper take the part off `{name}`"
        case BeltDrive(run=signal):
            note = f"`{channel}` is set by the device `{name}` when a part comes to its barrier"
            riders = [part for part, seat in run.parts.seats.items() if seat.rides in at.bodies]
            if not riders:
                return (
                    f"{note}, and nothing lies on it",
                    f"let a program or a supply put a part onto `{name}`",
                )
            names = ", ".join(f"`{part}`" for part in riders[:3]) + (" and others" if len(riders) > 3 else "")
            lies = "lies" if len(riders) == 1 else "lie"
            if signal and not run.is_on(signal, time):
                off = f"{note}, but it stands, as `{signal}` is off ({names} {lies} on it)"
                return off, f"let `{signal}` come on"
            return (
                f"{note}, and none is on its way ({names} {lies} beyond it)",
                f"put parts before the barrier of `{name}`",
            )
        case SwitchDrive(signal=signal):
            level_words = "on" if run.is_on(signal, time) else "off"
            note = f"`{channel}` is set by the device `{name}`, which stands, as `{signal}` is {level_words}"
            return (
                note,
                f"let `{signal}` {'go off' if level_words == 'on' else 'come on'}, which `{name}` follows",
            )
        case IndexDrive(signal=signal):
            note = f"`{channel}` is set by the device `{name}`, which stands until `{signal}` comes on"
            return note, f"let `{signal}` come on again, or wait before it does"
