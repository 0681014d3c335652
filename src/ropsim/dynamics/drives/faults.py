"""Faults that make a drive impossible."""

from collections.abc import Sequence
from math import inf, isfinite

from ropsim.dynamics.drives.chain import chain_of
from ropsim.model import (
    BallScrew,
    Drive,
    GuardedAmplifier,
    Hydraulic,
    HydraulicCylinder,
    HydraulicSupply,
    HydraulicVane,
    Joint,
    JointType,
    Linkage,
    LugreFriction,
    Motor,
    StribeckFriction,
    ThermalDcMotor,
)

Fault = tuple[str, str]
"""Impossible value of a drive, and the reason."""

_OPEN = frozenset({"max_effort", "max_current", "max_rise"})
"""Limits that may be infinite."""

MOST_EXPONENT = 1.7
"""A gas of single atoms that keeps its heat has 5/3."""

SHARED = ("supply_pressure", "return_pressure", "bulk_modulus", "oil_density")
"""Attributes that drives at one supply have in common."""


def drive_fault(drive: Drive) -> Fault | None:
    """Return the impossible value of a drive and the reason, None for a valid drive.

    Args:
        drive: the drive.
    """
    chain = chain_of(drive)
    if chain.motor.takes is not chain.amplifier.kind:
        takes, gives = chain.motor.takes.value, chain.amplifier.kind.value
        return "the motor", f"takes {takes}, but its amplifier puts out {gives}"
    if isinstance(drive.amplifier, GuardedAmplifier) is not isinstance(drive.motor, ThermalDcMotor):
        return "the amplifier", "and the motor do not go together; it is one that is watched, or none of both"
    if isinstance(drive.motor, HydraulicCylinder) is not isinstance(drive.transmission, Linkage):
        return (
            "the transmission",
            "and the motor do not go together; a cylinder needs a linkage, others a gear",
        )
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
    if not isinstance(drive.transmission, Linkage) and not 0.0 < abs(drive.transmission.ratio) < inf:
        size = abs(drive.transmission.ratio)
        return "magnitude of `ratio`", f"is `{size}`; it must be positive and finite"
    if found := _oil_fault(drive) or _link_fault(drive) or _screw_fault(drive):
        return found
    if isinstance(drive.motor, ThermalDcMotor) and (found := _thermal_fault(drive.motor)):
        return found
    if isinstance(drive.friction, StribeckFriction | LugreFriction) and (
        found := _breakaway_fault(drive.friction)
    ):
        return found
    if chain.transmission.states and not drive.motor.rotor_inertia > 0.0:
        found_inertia = f"is `{drive.motor.rotor_inertia}`; behind an elastic gear it must be positive"
        return "`rotor_inertia`", found_inertia
    return None


def _thermal_fault(motor: ThermalDcMotor) -> Fault | None:
    if not motor.resistance_drift >= 0.0:
        return "`resistance_drift`", f"is `{motor.resistance_drift}`; it must be 0 or more"
    if not -1e-2 <= motor.torque_drift <= 0.0:
        return "`torque_drift`", f"is `{motor.torque_drift}`; it must be between -0.01 and 0"
    if not 0.0 <= motor.start_rise * -motor.torque_drift < 1.0 or not motor.start_rise >= 0.0:
        return "`start_rise`", f"is `{motor.start_rise}`; it must be 0 or more, and leave the motor torque"
    return None


def _breakaway_fault(friction: StribeckFriction | LugreFriction) -> Fault | None:
    if friction.breakaway < friction.coulomb:
        why = f"is `{friction.breakaway}`; it is at least `coulomb`, {friction.coulomb}"
        return "`breakaway`", why
    if isinstance(friction, LugreFriction) and not friction.coulomb > 0.0:
        return "`coulomb`", f"is `{friction.coulomb}`; of bristles it must be positive"
    return None


def _oil_fault(drive: Drive) -> Fault | None:
    found = _hydraulic_fault(drive.motor) if isinstance(drive.motor, Hydraulic) else None
    return found or (_supply_fault(drive.supply, drive.motor) if drive.supply else None)


def _hydraulic_fault(motor: Hydraulic) -> Fault | None:
    if not 0.0 <= motor.return_pressure < motor.supply_pressure:
        found = f"is `{motor.return_pressure}`; it must be between 0 and the supply pressure"
        return "`return_pressure`", found
    if isinstance(motor, HydraulicCylinder) and motor.area_b > motor.area_a:
        return "`area_b`", f"is `{motor.area_b}`; the ring around the rod cannot be larger than the piston"
    if not motor.leakage >= 0.0:
        return "`leakage`", f"is `{motor.leakage}`; it must be 0 or more"
    if not 0.0 <= motor.null_flow < motor.rated_flow:
        return "`null_flow`", f"is `{motor.null_flow}`; it must be 0 or more, and less than the rated flow"
    if not 0.0 <= motor.overlap < 1.0:
        return "`overlap`", f"is `{motor.overlap}`; it must be 0 or more, and less than 1"
    if not motor.rotor_inertia >= 0.0:
        name = "moving_mass" if isinstance(motor, HydraulicCylinder) else "rotor_inertia"
        return f"`{name}`", f"is `{motor.rotor_inertia}`; it must be 0 or more"
    return None


def _screw_fault(drive: Drive) -> Fault | None:
    screw = drive.transmission
    if not isinstance(screw, BallScrew):
        return None
    for name in ("efficiency", "back_efficiency"):
        value = float(getattr(screw, name))
        if not 0.0 < value <= 1.0:
            return f"`{name}`", f"is `{value}`; it must be positive, and 1 at most"
    if not screw.screw_inertia >= 0.0:
        return "`screw_inertia`", f"is `{screw.screw_inertia}`; it must be 0 or more"
    return None


def _link_fault(drive: Drive) -> Fault | None:
    link = drive.link
    if link is None:
        return None
    if not 0.0 < link.stiffness < inf:
        return "`stiffness`", f"of the link is `{link.stiffness}`; it must be positive and finite"
    for name in ("damping", "hub_inertia"):
        value = float(getattr(link, name))
        if not 0.0 <= value < inf:
            return f"`{name}`", f"of the link is `{value}`; it must be 0 or more, and finite"
    if drive.has_idle_hub:
        return "`hub_inertia`", "is `0`; before an elastic link the hub, or a rotor on a rigid gear, has one"
    return None


def _supply_fault(supply: HydraulicSupply, motor: Motor) -> Fault | None:
    if not isinstance(motor, Hydraulic):
        return "`supply`", f"is `{supply.name}`; an electric motor has no supply of oil"
    of, full = f"of the supply `{supply.name}`", motor.supply_pressure
    for name in ("gas_volume", "precharge", "pump_flow", "line_volume", "pump_band"):
        value = float(getattr(supply, name))
        if not 0.0 < value < inf:
            return f"`{name}`", f"{of} is `{value}`; it must be positive and finite"
    for name in ("precharge", "pump_band"):
        value = float(getattr(supply, name))
        if not value < full:
            return f"`{name}`", f"{of} is `{value}`; it must be less than the supply pressure, {full}"
    if not full < supply.relief_pressure < inf:
        why = f"{of} is `{supply.relief_pressure}`; it must be more than the supply pressure, {full}"
        return "`relief_pressure`", why
    if not 1.0 <= supply.exponent <= MOST_EXPONENT:
        return "`exponent`", f"{of} is `{supply.exponent}`; a gas has 1 to {MOST_EXPONENT:g}"
    return None


def shared_supply_fault(drives: Sequence[Drive]) -> tuple[int, Fault] | None:
    """Return why drives cannot be at one supply, and the number of the second of them; None where they can.

    Drives at one supply have its pressure, its return and its oil.

    Args:
        drives: of an arm, each of which can exist.
    """
    first: dict[str, tuple[HydraulicSupply, tuple[float, ...]]] = {}
    for axis, drive in enumerate(drives):
        motor, supply = drive.motor, drive.supply
        if not isinstance(motor, Hydraulic) or supply is None:
            continue
        oil = tuple(float(getattr(motor, name)) for name in SHARED)
        known, other = first.setdefault(supply.name, (supply, oil))
        if supply != known:
            return axis, ("`supply`", f"`{supply.name}` has other numbers than at another joint")
        for name, own, theirs in zip(SHARED, oil, other, strict=True):
            if own != theirs:
                why = f"is `{own}`; another joint at the supply `{supply.name}` has `{theirs}`"
                return axis, (f"`{name}`", why)
    return None


def range_fault(drive: Drive, joint: Joint) -> Fault | None:
    """Return why a drive cannot move its joint over the range that it has, None where it can.

    A cylinder that turns a joint is in line with the axis at its dead centres, where it has no lever, and its
    rod comes out by its stroke. A vane swings between its stops.

    Args:
        drive: that can exist.
        joint: that it moves.
    """
    gear, motor = drive.transmission, drive.motor
    if isinstance(motor, HydraulicVane) and not isinstance(gear, Linkage):
        return _swing_fault(motor, gear.ratio, joint)
    if not isinstance(gear, Linkage) or not isinstance(motor, HydraulicCylinder):
        return None
    if joint.type is not JointType.REVOLUTE:
        return "the linkage", f"moves a joint of type {joint.type.value}; a cylinder turns a turning joint"
    if not isfinite(joint.upper - joint.lower):
        return "the linkage", "has a stroke, and its joint has no limits"
    if gear.is_about_axis:
        return "the linkage", "has a pin on the axis of its joint, where it has no lever"
    if gear.dead_centre(joint.lower, joint.upper) is not None:
        return "the linkage", "has a dead centre within the range of its joint"
    if not gear.fits(motor.stroke, joint.lower, joint.upper):
        first, last = (gear.retracted_length + way for way in gear.ways(joint.lower, joint.upper))
        longest = gear.retracted_length + motor.stroke
        return (
            "the linkage",
            f"is {first:.5g} to {last:.5g} m long over the range of its joint; its cylinder is "
            f"{gear.retracted_length:.5g} to {longest:.5g} m long",
        )
    return None


def _swing_fault(motor: HydraulicVane, ratio: float, joint: Joint) -> Fault | None:
    if not isfinite(joint.upper - joint.lower):
        return "the vane", "has stops, and its joint has no limits"
    if not motor.fits(ratio, joint.lower, joint.upper):
        first, last = sorted((ratio * joint.lower, ratio * joint.upper))
        end = motor.first_angle + motor.swing
        return (
            "the vane",
            f"turns from {first:.5g} to {last:.5g} rad over the range of its joint; its stops are at "
            f"{motor.first_angle:.5g} and {end:.5g} rad",
        )
    return None
