"""Operations that change the modal state; every robot instruction carries a snapshot of it."""

from ropsim.icr.machine.site import Operation, Site
from ropsim.icr.machine.state import Registers
from ropsim.icr.machine.traps import out_of_range
from ropsim.icr.machine.world import World
from ropsim.icr.rules.operands import setting_fault

_FIELDS = {
    "SPD.PTP": "ptp_speed",
    "SPD.LIN": "path_speed",
    "SPD.ORI": "orientation_speed",
    "ACC.PTP": "ptp_acceleration",
    "ACC.LIN": "path_acceleration",
    "ACC.ORI": "orientation_acceleration",
    "JERK": "path_jerk",
}


def _frame(registers: Registers, _world: World, site: Site) -> None:
    name, pose = site.operand
    registers.modal = registers.changed((site.mnemonic, name), frame=name, X_BK=pose)


def _tool(registers: Registers, _world: World, site: Site) -> None:
    name, pose = site.operand
    registers.modal = registers.changed((site.mnemonic, name), tool=name, X_MT=pose)


def _setting(registers: Registers, _world: World, site: Site) -> None:
    value = registers.stack.pop()
    if fault := setting_fault(site.mnemonic, value):
        raise out_of_range(fault)
    registers.modal = registers.changed((site.mnemonic, value), **{_FIELDS[site.mnemonic]: value})


def _zone(registers: Registers, _world: World, site: Site) -> None:
    zone = registers.stack.pop()
    if fault := setting_fault("ZONE.DIST", zone):
        raise out_of_range(fault)
    registers.modal = registers.changed((site.mnemonic, zone), zone=zone, passes=False)


def _zone_fine(registers: Registers, _world: World, site: Site) -> None:
    registers.modal = registers.changed((site.mnemonic, None), zone=0.0, passes=False)


def _zone_via(registers: Registers, _world: World, site: Site) -> None:
    registers.modal = registers.changed((site.mnemonic, None), passes=True)


def _save(registers: Registers, _world: World, _site: Site) -> None:
    registers.saved.append(registers.modal)


def _restore(registers: Registers, _world: World, _site: Site) -> None:
    registers.modal = registers.saved.pop()


MODAL: dict[str, Operation] = {
    "FRAME": _frame,
    "TOOL": _tool,
    **dict.fromkeys(_FIELDS, _setting),
    "ZONE.FINE": _zone_fine,
    "ZONE.DIST": _zone,
    "ZONE.VIA": _zone_via,
    "MODAL.SAVE": _save,
    "MODAL.RESTORE": _restore,
}
"""Mnemonic -> operation."""
