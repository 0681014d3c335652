"""The power that a drive draws from its supply, from what is recorded of it."""

from ropsim.dynamics.drives.block import Recorded
from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import Drive
from ropsim.spatial import Array


def drive_power(drive: Drive, columns: Recorded) -> Array:
    """Return the power that a drive draws [W], negative where it gives back, shape (rows,).

    What amplifier, controller, brakes, and the electrical side of a valve take is no part of it.

    Args:
        drive: the drive.
        columns: recorded quantities of its axis by name: `q`, `qd`, the states of the drive and the output of
            its amplifier.
    """
    chain = chain_of(drive)
    speed = chain.transmission.speed(drive.transmission, columns)
    return chain.motor.power(drive.motor, columns, speed)
