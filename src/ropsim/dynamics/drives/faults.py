"""What makes a drive impossible."""

from math import inf, isfinite

from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import Drive, HydraulicMotor

_OPEN = frozenset({"max_effort", "max_current"})
"""Limits that may be infinite."""


def drive_fault(drive: Drive) -> tuple[str, str] | None:
    """Return what of a drive is impossible and why, None for a drive that can exist.

    Args:
        drive: the drive.
    """
    chain = chain_of(drive)
    if chain.motor.takes is not chain.amplifier.kind:
        takes, gives = chain.motor.takes.value, chain.amplifier.kind.value
        return "the motor", f"takes {takes}, but its amplifier puts out {gives}"
    pairs = (
        (chain.amplifier, drive.amplifier),
        (chain.motor, drive.motor),
        (chain.transmission, drive.transmission),
    )
    for block, record in pairs:
        for name in block.positive:
            value = float(getattr(record, name))
            if not (value > 0.0 and (isfinite(value) or name in _OPEN)):
                return f"`{name}`", f"is `{value}`; it must be positive and finite"
    if not (drive.ratio != 0.0 and abs(drive.ratio) < inf):
        return "magnitude of `ratio`", f"is `{abs(drive.ratio)}`; it must be positive and finite"
    if isinstance(drive.motor, HydraulicMotor) and not (
        0.0 <= drive.motor.return_pressure < drive.motor.supply_pressure and drive.motor.leakage >= 0.0
    ):
        found = f"is `{drive.motor.return_pressure}`; it must be between 0 and the supply pressure"
        return "`return_pressure`", found
    if chain.transmission.states and not drive.motor.rotor_inertia > 0.0:
        found = f"is `{drive.motor.rotor_inertia}`; behind an elastic gear it must be positive"
        return "`rotor_inertia`", found
    return None
