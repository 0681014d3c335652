"""Hydraulic motors and cylinders, each with the valve and the supply that it is at."""

from dataclasses import field

from ropsim.core import frozen_dataclass

_ROUNDING = 1e-9
"""Angles of stops and of the ranges of joints are rounded [rad]."""


@frozen_dataclass
class AtValve:
    """What is at a symmetric servo valve with four edges, and the oil that it gets.

    The spool opens as x'' = ωn²·(i/i_r - x) - 2·ζ·ωn·x'. Each edge that is open lets Q = Q_r·|y|·√(2·Δp/Δp_r)
    through, the fall of pressure Δp_r of data sheets being that of both edges; y is x, and with an overlap
    what x is beyond it, (|x| - o)/(1 - o). With a null flow all edges leak, the less the more they are closed
    (B. Eryilmaz, B. H. Wilson: Improved tracking control of hydraulic systems, ASME J. Dyn. Sys. Meas.
    Control 123 (2001), 457-462).

    Attributes:
        supply_pressure: over that of the air [Pa].
        return_pressure: the same [Pa].
        bulk_modulus: effective β of the oil [Pa].
        rated_flow: Q_r [m³/s], at the rated current and fall of pressure.
        rated_pressure_drop: Δp_r [Pa] over both edges.
        rated_input: i_r [A].
        natural_frequency: ωn of the spool [rad/s].
        damping_ratio: ζ of the spool.
        oil_density: [kg/m³], at which the flow is rated; no equation has it.
        null_flow: Q_0 through the valve at its centre, from supply to return, at the fall Δp_r [m³/s].
        overlap: o, the opening x at which the first edges open; 0 where they do so at the centre.
    """

    supply_pressure: float = field(kw_only=True)
    return_pressure: float = field(kw_only=True)
    bulk_modulus: float = field(kw_only=True)
    rated_flow: float = field(kw_only=True)
    rated_pressure_drop: float = field(kw_only=True)
    rated_input: float = field(kw_only=True)
    natural_frequency: float = field(kw_only=True)
    damping_ratio: float = field(kw_only=True)
    oil_density: float = field(default=870.0, kw_only=True)
    null_flow: float = field(default=0.0, kw_only=True)
    overlap: float = field(default=0.0, kw_only=True)


@frozen_dataclass
class HydraulicMotor(AtValve):
    """A hydraulic motor, or a cylinder with two equal areas, at a servo valve.

    Each chamber has p' = β/V·(Q - D·ω - leak), and the torque is D·(p_a - p_b) (H. E. Merritt: Hydraulic
    Control Systems, Wiley 1967). Of a cylinder ω is its speed [m/s], the torque a force [N], D its area [m²].

    Attributes:
        displacement: D [m³/rad | m²].
        chamber_volume: V of each chamber with its line, at mid-stroke [m³].
        leakage: from chamber to chamber [m³/(s·Pa)].
        rotor_inertia: J [kg·m²], or the moving mass [kg].
    """

    displacement: float
    chamber_volume: float
    leakage: float
    rotor_inertia: float

    def oil_stiffness(self, place: float) -> float:
        """Return the stiffness of the oil in both chambers [N·m/rad | N/m], the same at each place."""
        del place
        return 2.0 * self.bulk_modulus / self.chamber_volume * self.displacement**2


@frozen_dataclass
class HydraulicCylinder(AtValve):
    """A cylinder with one rod at a servo valve.

    Its rod is out by s, from 0 to the stroke. The chamber behind the piston holds V_a = V_0a + A_a·s, that
    around the rod V_b = V_0b + A_b·(stroke - s); p_a' = β/V_a·(Q_a - A_a·s' - leak), p_b' = β/V_b·(Q_b +
    A_b·s' + leak), and the force that drives the rod out is A_a·p_a - A_b·p_b (H. E. Merritt, Hydraulic
    Control Systems, Wiley 1967).

    Attributes:
        area_a: A_a, of the piston [m²].
        area_b: A_b, of the ring around the rod [m²].
        stroke: from the rod drawn in to the rod out [m].
        dead_volume_a: V_0a, of the chamber with its line while the rod is in [m³].
        dead_volume_b: V_0b, of the other one while the rod is out [m³].
        leakage: from chamber to chamber [m³/(s·Pa)].
        moving_mass: of rod and piston [kg].
    """

    area_a: float
    area_b: float
    stroke: float
    dead_volume_a: float
    dead_volume_b: float
    leakage: float
    moving_mass: float

    @property
    def rotor_inertia(self) -> float:
        """Return the inertia that moves with the shaft, here a mass [kg]."""
        return self.moving_mass

    def volumes(self, out: float) -> tuple[float, float]:
        """Return the volumes of both chambers [m³] where the rod is out by `out` [m]."""
        return self.dead_volume_a + self.area_a * out, self.dead_volume_b + self.area_b * (self.stroke - out)

    def oil_stiffness(self, out: float) -> float:
        """Return the stiffness of the oil in both chambers [N/m] where the rod is out [m], or at its end."""
        a, b = self.volumes(min(max(out, 0.0), self.stroke))
        return self.bulk_modulus * (self.area_a**2 / a + self.area_b**2 / b)


@frozen_dataclass
class HydraulicVane(AtValve):
    """A rotary motor whose vane swings between two stops, at a servo valve.

    Its chambers grow and shrink with the angle θ of its shaft: V_a = V_0 + D·(θ - θ_0) and V_b = V_0 +
    D·(θ_0 + θ_s - θ) (M. Jelali, A. Kroll: Hydraulic Servo-systems, Springer 2003, chapter 4). All else is as
    in `HydraulicMotor`.

    Attributes:
        displacement: D [m³/rad].
        swing: θ_s, from stop to stop [rad].
        first_angle: θ_0, angle of the shaft at which chamber a is smallest [rad].
        dead_volume: V_0, of each chamber with its line where it is smallest [m³].
        leakage: from chamber to chamber [m³/(s·Pa)].
        rotor_inertia: J [kg·m²].
    """

    displacement: float
    swing: float
    first_angle: float
    dead_volume: float
    leakage: float
    rotor_inertia: float

    def volumes(self, angle: float) -> tuple[float, float]:
        """Return the volumes of both chambers [m³] where the shaft is at an angle [rad], or at its stop."""
        turned = min(max(angle - self.first_angle, 0.0), self.swing)
        return (
            self.dead_volume + self.displacement * turned,
            self.dead_volume + self.displacement * (self.swing - turned),
        )

    def oil_stiffness(self, angle: float) -> float:
        """Return the stiffness of the oil in both chambers [N·m/rad] at an angle of the shaft [rad]."""
        a, b = self.volumes(angle)
        return self.bulk_modulus * (1.0 / a + 1.0 / b) * self.displacement**2

    def fits(self, ratio: float, lower: float, upper: float) -> bool:
        """Return whether it turns a joint behind a gear from one coordinate to another [rad | m]."""
        first, last = sorted((ratio * lower, ratio * upper))
        end = self.first_angle + self.swing
        return self.first_angle - _ROUNDING <= first and last <= end + _ROUNDING


Hydraulic = HydraulicMotor | HydraulicCylinder | HydraulicVane
