"""Hydraulic motors and cylinders as instances, with their valves, supplies and pins."""

from ropsim.model import (
    SUPPLY_NUMBERS,
    WRITTEN,
    Hydraulic,
    HydraulicCylinder,
    HydraulicSupply,
    HydraulicVane,
    Linkage,
    RobotModel,
    carrier_frame,
    pin_at,
)
from ropsim.nirox.building import UNSET, Building, Key, reals
from ropsim.part21 import Reference, Value
from ropsim.spatial import Pose


def write_hydraulic(
    building: Building, number: int, name: str, motor: Hydraulic, shared: HydraulicSupply | None
) -> tuple[Reference, Value]:
    """Make a hydraulic motor or cylinder and its valve, with the supply of that.

    Args:
        building: takes the instances.
        number: of the joint.
        name: of the joint.
        motor: to be written.
        shared: supply with an accumulator that it is at; None for one of constant pressure.

    Returns:
        The motor and the valve.
    """
    pressures = (motor.supply_pressure, motor.return_pressure, motor.bulk_modulus, motor.oil_density)
    key = ("amplifier", number)
    supply = _supply(building, key, name, tuple(map(float, pressures)), shared)
    flow = (motor.rated_flow, motor.rated_pressure_drop, motor.rated_input)
    spool = (motor.natural_frequency, motor.damping_ratio, motor.overlap, 0.0)
    valve = building.add(key, "SERVO_VALVE", f"valve {name}", supply, *map(float, (*flow, *spool)), UNSET)
    if motor.null_flow:
        building.add((*key, "null flow"), "VALVE_NULL_FLOW", valve, float(motor.null_flow))
    sizes: tuple[float, ...]
    if isinstance(motor, HydraulicCylinder):
        keyword, label = "HYDRAULIC_CYLINDER", f"cylinder {name}"
        volumes = (motor.dead_volume_a, motor.dead_volume_b)
        sizes = (motor.area_a, motor.area_b, motor.stroke, *volumes, motor.leakage, motor.moving_mass)
    else:
        keyword, label = "HYDRAULIC_ROTARY_MOTOR", f"motor {name}"
        volume = _middle_volume(motor) if isinstance(motor, HydraulicVane) else motor.chamber_volume
        sizes = (motor.displacement, volume, motor.leakage, motor.rotor_inertia)
    if isinstance(motor, HydraulicVane):
        made = building.add(("motor", number), keyword, label, *map(float, sizes))
        chambers = map(float, (motor.swing, motor.first_angle, motor.dead_volume))
        building.add(("motor", number, "vane"), "VANE_CHAMBERS", made, *chambers)
        return made, valve
    return building.add(("motor", number), keyword, label, *map(float, sizes)), valve


def _supply(
    building: Building,
    key: Key,
    name: str,
    pressures: tuple[float, ...],
    shared: HydraulicSupply | None,
) -> Reference:
    if shared is None:
        return building.add((*key, "supply"), "HYDRAULIC_SUPPLY", f"supply {name}", *pressures)
    made = building.add(("supply", shared.name), "HYDRAULIC_SUPPLY", shared.name, *pressures)
    numbers = (float(getattr(shared, one)) for one in SUPPLY_NUMBERS)
    building.add(("supply", shared.name, "accumulator"), "HYDRAULIC_ACCUMULATOR", made, *numbers)
    return made


def _middle_volume(motor: HydraulicVane) -> float:
    """Return the volume of each chamber where the vane is half way [m³]."""
    return motor.dead_volume + 0.5 * motor.displacement * motor.swing


def write_linkage(building: Building, robot: RobotModel, number: int, gear: Linkage) -> Reference:
    """Make the pins of a cylinder, in the frames of the two links that they are on."""
    joint = robot.joints[number]
    carrier = pin_at(carrier_frame(joint, Pose()).inverse(), gear.carrier_pin, WRITTEN)
    return building.add(
        ("gear", number),
        "LINKAGE_TRANSMISSION",
        f"linkage {joint.name}",
        building.at(("link", joint.parent)),
        reals(carrier),
        building.at(("link", number)),
        reals(gear.link_pin),
        float(gear.retracted_length),
    )
