"""Numbers of drives that are most often in another unit than the model has.

Bounds cover motors, cylinders and valves of arms, with a margin: from motors of 10 W to cylinders of
excavators. A number beyond them is reported with the unit in which it would be usual.
"""

from collections.abc import Iterator

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.model.drives.current_loop import CurrentLoopMotor
from ropsim.model.drives.drive import DcMotor
from ropsim.model.drives.hydraulics import HydraulicCylinder, HydraulicMotor, HydraulicVane
from ropsim.model.drives.thermal_motor import ThermalDcMotor
from ropsim.model.findings.doubt_diagnostics import UNLIKELY_DRIVE
from ropsim.model.findings.place import Attribute, AuditPlace, PlaceOf
from ropsim.model.mechanism.mechanism import Mechanism


@frozen_dataclass
class _Usual:
    """Usual range of a quantity.

    Attributes:
        unit: of the model.
        low: least usual value.
        high: greatest usual value.
        others: units in which it is often given, and their size in that of the model.
    """

    unit: str
    low: float
    high: float
    others: tuple[tuple[str, float], ...]


_LITRE, _TURN = 1e-3, 6.283185307179586
_PRESSURES = (("bar", 1e5), ("MPa", 1e6), ("kPa", 1e3), ("psi", 6894.757))
_AREAS = (("mm²", 1e-6), ("cm²", 1e-4))
_VOLUMES = (("cm³", 1e-6), ("l", _LITRE))
_FLOWS = (("l/min", _LITRE / 60.0), ("l/s", _LITRE))
_OF_HYDRAULICS = {
    "supply_pressure": _Usual("Pa", 5e5, 1e8, _PRESSURES),
    "rated_pressure_drop": _Usual("Pa", 5e4, 1e8, _PRESSURES),
    "bulk_modulus": _Usual("Pa", 5e7, 4e9, _PRESSURES),
    "rated_flow": _Usual("m³/s", 1e-7, 5e-2, _FLOWS),
}
_OF_CYLINDERS = {
    "area_a": _Usual("m²", 1e-5, 1.0, _AREAS),
    "area_b": _Usual("m²", 1e-5, 1.0, _AREAS),
    "stroke": _Usual("m", 5e-3, 8.0, (("mm", 1e-3), ("cm", 1e-2))),
    "dead_volume_a": _Usual("m³", 1e-8, 5e-2, _VOLUMES),
    "dead_volume_b": _Usual("m³", 1e-8, 5e-2, _VOLUMES),
}
_OF_MOTORS = {
    "displacement": _Usual("m³/rad", 1e-9, 1e-1, (("cm³ per turn", 1e-6 / _TURN), ("mm²", 1e-6))),
    "chamber_volume": _Usual("m³", 1e-9, 1e-1, _VOLUMES),
}
_OF_VANES = {
    "displacement": _OF_MOTORS["displacement"],
    "dead_volume": _OF_CYLINDERS["dead_volume_a"],
    "swing": _Usual("rad", 0.1, 6.3, (("°", _TURN / 360.0),)),
}
_OF_DC_MOTORS = {
    "torque_constant": _Usual("N·m/A", 1e-3, 2e1, (("mN·m/A", 1e-3),)),
    "resistance": _Usual("Ω", 1e-3, 1e3, (("mΩ", 1e-3),)),
    "inductance": _Usual("H", 1e-7, 5e-1, (("mH", 1e-3), ("µH", 1e-6))),
    "rotor_inertia": _Usual("kg·m²", 0.0, 1.0, (("kg·cm²", 1e-4), ("g·cm²", 1e-7))),
}
_USUAL = {
    DcMotor: _OF_DC_MOTORS,
    CurrentLoopMotor: _OF_DC_MOTORS,
    ThermalDcMotor: _OF_DC_MOTORS,
    HydraulicMotor: _OF_HYDRAULICS | _OF_MOTORS,
    HydraulicCylinder: _OF_HYDRAULICS | _OF_CYLINDERS,
    HydraulicVane: _OF_HYDRAULICS | _OF_VANES,
}


def drive_doubts(robot: Mechanism, place_of: PlaceOf) -> Iterator[Diagnostic]:
    """Yield the numbers of drives beyond the usual range.

    Args:
        robot: audited mechanism.
        place_of: where its numbers stand in the file that it was read from.
    """
    for axis, (joint, drive) in enumerate(zip(robot.axis_joints, robot.drives, strict=False)):
        for name, usual in _USUAL.get(type(drive.motor), {}).items():
            value = float(getattr(drive.motor, name))
            if usual.low <= value <= usual.high:
                continue
            fitting = [unit for unit, size in usual.others if usual.low <= value * size <= usual.high]
            hint = f"is it in {' or '.join(fitting)}?" if fitting else "compare it with the data sheet"
            yield UNLIKELY_DRIVE.at(
                place_of(AuditPlace(axis, Attribute.DRIVE, name)),
                f"the drive of joint `{joint.name}` has `{name}` = {value:g} {usual.unit}, usual are "
                f"{usual.low:g} to {usual.high:g} {usual.unit}",
                hint=hint,
                data={"found": value, "unit": usual.unit},
            )
