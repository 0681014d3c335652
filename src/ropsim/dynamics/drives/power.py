"""The power that a drive draws from its supply, from recorded columns."""

from ropsim.dynamics.drives.block import Recorded
from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import Drive
from ropsim.spatial import Array


def drive_power(drive: Drive, columns: Recorded) -> Array:
    """Return the power that a drive draws [W], negative while it returns power, shape (rows,).

    It excludes amplifier, controller, brakes, and the electrical side of a valve.

    Args:
        drive: the drive.
        columns: recorded quantities of its axis by name: `q`, `qd`, the states of the drive and the output of
            its amplifier.
    """
    chain = chain_of(drive)
    speed = chain.transmission.speed(drive.transmission, columns)
    return chain.motor.power(drive.motor, columns, speed)
