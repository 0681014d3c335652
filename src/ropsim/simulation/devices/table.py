"""Motions of the drives of devices: a file and an entry here for each kind.

A new kind is a member of `DeviceDrive`; mypy then reports each `match` without a case for it.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from ropsim.model import BeltDrive, DeviceDrive, IndexDrive, SwitchDrive
from ropsim.simulation.devices.belt import Belt
from ropsim.simulation.devices.device_run import Driving
from ropsim.simulation.devices.index import Index
from ropsim.simulation.devices.switch import Switch

DRIVINGS: Mapping[type[DeviceDrive], Callable[..., Driving]] = MappingProxyType(
    {BeltDrive: Belt, SwitchDrive: Switch, IndexDrive: Index}
)
"""Makes the running state of a drive at time 0, by the class of its record."""
