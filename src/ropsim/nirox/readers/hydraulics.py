"""Hydraulic motors and cylinders of a file, with their valves, supplies and pins."""

from collections.abc import Sequence

from ropsim.model import (
    BASE_LINK,
    SUPPLY_NUMBERS,
    Amplifier,
    Drive,
    HydraulicCylinder,
    HydraulicMotor,
    HydraulicSupply,
    HydraulicVane,
    Joint,
    JointType,
    Linkage,
    Motor,
    Point,
    ValveAmplifier,
    carrier_frame,
    linkage,
    pin_at,
)
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.seen import Seen
from ropsim.spatial import Pose

HYDRAULIC = ("hydraulic_rotary_motor", "hydraulic_cylinder")


def read_hydraulic(
    seen: Seen, motor: int, valve: int, at_input: float, number: int
) -> tuple[Amplifier, Motor]:
    """Return a hydraulic motor or cylinder with the numbers of its valve and of the supply of that."""
    supply = seen.ref(valve, "supply")
    seen.take(valve, "amplifier", number)
    if seen.user(supply, "hydraulic_accumulator", "supply") is None:
        seen.take(supply, "amplifier", number, "supply")
    if seen.real(valve, "hysteresis") or seen.has(valve, "max_slew"):
        seen.note(LOST, valve, "hysteresis and `max_slew` have no effect")
    most = seen.real(valve, "max_input")
    common = {
        "leakage": seen.real(motor, "internal_leakage"),
        "supply_pressure": seen.real(supply, "supply_pressure"),
        "return_pressure": seen.real(supply, "return_pressure"),
        "bulk_modulus": seen.real(supply, "effective_bulk_modulus"),
        "rated_flow": seen.real(valve, "rated_flow"),
        "rated_pressure_drop": seen.real(valve, "rated_pressure_drop"),
        "rated_input": most,
        "natural_frequency": seen.real(valve, "natural_frequency"),
        "damping_ratio": seen.real(valve, "damping_ratio"),
        "oil_density": seen.real(supply, "oil_density"),
        "null_flow": _null_flow(seen, valve, number),
        "overlap": _overlap(seen, valve),
    }
    if seen.is_a(motor, "hydraulic_cylinder"):
        sizes = ("area_a", "area_b", "stroke", "dead_volume_a", "dead_volume_b", "moving_mass")
        cylinder = HydraulicCylinder(**{name: seen.real(motor, name) for name in sizes}, **common)
        return ValveAmplifier(most), cylinder
    rotor = seen.real(motor, "rotor_inertia")
    rotor = rotor + at_input if at_input else rotor
    chambers = seen.user(motor, "vane_chambers", "motor")
    if chambers is not None:
        seen.take(chambers, "motor", number, "vane")
        own = {name: seen.real(chambers, name) for name in ("swing", "first_angle", "dead_volume")}
        displacement = seen.real(motor, "displacement")
        vane = HydraulicVane(displacement=displacement, rotor_inertia=rotor, **own, **common)
        return ValveAmplifier(most), vane
    made = HydraulicMotor(
        displacement=seen.real(motor, "displacement"),
        chamber_volume=seen.real(motor, "chamber_volume"),
        rotor_inertia=rotor,
        **common,
    )
    return ValveAmplifier(most), made


def read_supply(seen: Seen, valve: int) -> HydraulicSupply | None:
    """Return the supply with an accumulator that a valve is at; None for one of constant pressure."""
    supply = seen.ref(valve, "supply")
    entry = seen.user(supply, "hydraulic_accumulator", "supply")
    if entry is None:
        return None
    name = seen.text(supply, "name")
    seen.take(supply, "supply", name)
    seen.take(entry, "supply", name, "accumulator")
    return HydraulicSupply(name, **{one: seen.real(entry, one) for one in SUPPLY_NUMBERS})


def _null_flow(seen: Seen, valve: int, number: int) -> float:
    """Return the flow through a valve at its centre [m³/s]."""
    companion = seen.user(valve, "valve_null_flow", "valve")
    if companion is None:
        return 0.0
    seen.take(companion, "amplifier", number, "null flow")
    flow, rated = seen.real(companion, "flow"), seen.real(valve, "rated_flow")
    if flow >= rated:
        raise seen.impossible(companion, f"`flow` is {flow:g} m³/s, allowed is less than the rated {rated:g}")
    return flow


def _overlap(seen: Seen, valve: int) -> float:
    """Return the overlap of a valve; an underlap is no overlap, which is reported."""
    overlap = seen.real(valve, "overlap")
    if overlap >= 1.0:
        raise seen.impossible(valve, f"`overlap` is {overlap:g}, allowed is less than 1")
    if overlap < 0.0:
        seen.note(LOST, valve, "an underlap has no effect", "say what flows at the centre: VALVE_NULL_FLOW")
    return max(overlap, 0.0)


class Linkages:
    """The linkages of a file, on the joints that they turn.

    Args:
        seen: the file.
        mechanism: its links and joints.
        joints: of the robot.
    """

    def __init__(self, seen: Seen, mechanism: Mechanism, joints: Sequence[Joint]) -> None:
        self._seen = seen
        self._mechanism = mechanism
        self._joints = joints

    def read(self, through: int, number: int) -> Linkage | None:
        """Return a linkage that turns a joint; None where it lies between other links, which is reported."""
        seen, mechanism, joint = self._seen, self._mechanism, self._joints[number]
        carrier = mechanism.base if joint.parent == BASE_LINK else mechanism.moved[joint.parent].link
        ends = {seen.ref(through, f"link_{end}"): self._point(through, f"anchor_{end}") for end in (1, 2)}
        moved = mechanism.moved[number].link
        if ends.keys() != {carrier, moved}:
            self._lost(through, "it does not lie between the two links of its pair")
            return None
        if joint.type is not JointType.REVOLUTE:
            self._lost(through, "it moves a pair that is not a revolute one")
            return None
        seen.take(through, "gear", number)
        frames = mechanism.frames
        on_carrier = carrier_frame(joint, frames.get(carrier, Pose()))
        pins = pin_at(on_carrier, ends[carrier]), pin_at(frames.get(moved, Pose()), ends[moved])
        retracted = seen.real(through, "retracted_length")
        return linkage(*pins, retracted, 0.5 * (joint.lower + joint.upper))

    def can_be(self, through: int, drive: Drive, number: int) -> bool:
        """Return whether a cylinder turns its joint one way over all of its range; else it is reported.

        The same goes for a vane between its stops.
        """
        gear, joint = drive.transmission, self._joints[number]
        if not isinstance(gear, Linkage):
            if not isinstance(drive.motor, HydraulicVane) or drive.motor.fits(
                gear.ratio, joint.lower, joint.upper
            ):
                return True
            self._lost(through, "its vane does not swing over the limits of its pair")
            return False
        if gear.is_about_axis:
            self._lost(through, "a pin lies on the axis of its pair")
        elif gear.dead_centre(joint.lower, joint.upper) is not None:
            self._lost(through, "pins and axis are in line within the limits of its pair")
        elif isinstance(drive.motor, HydraulicCylinder) and not gear.fits(
            drive.motor.stroke, joint.lower, joint.upper
        ):
            self._lost(through, "its cylinder does not reach over the limits of its pair")
        else:
            return True
        return False

    def _lost(self, through: int, why: str) -> None:
        self._seen.note(LOST, through, f"{why}: the robot has no drives")

    def _point(self, through: int, name: str) -> Point:
        x, y, z = self._seen.reals(through, name)
        return x, y, z
