"""Laws of friction as instances, at the motor."""

from typing import assert_never

from ropsim.model import Friction, FrictionLaw, LoadFriction, LugreFriction, StribeckFriction
from ropsim.nirox.building import UNSET, Building
from ropsim.part21 import Enumeration, Value

_MOTOR_SIDE = Enumeration("MOTOR_SIDE")


def write_friction(building: Building, number: int, law: FrictionLaw) -> None:
    """Make the friction of a joint; nothing where there is none.

    Args:
        building: so far.
        number: of the joint.
        law: of its drive.
    """
    if law == Friction():
        return
    key = ("friction", number)
    keyword, own = _entity(law)
    common = building.at(("pair", number)), _MOTOR_SIDE, float(law.viscous), float(law.coulomb_positive)
    made = building.add(key, keyword, *common, *own)
    if law.smoothing_speed != Friction().smoothing_speed:
        building.add((*key, "smoothing"), "FRICTION_SMOOTHING", made, float(law.smoothing_speed))


def _entity(law: FrictionLaw) -> tuple[str, tuple[Value, ...]]:
    """Return the entity of a law, and the attributes that it has after those of all laws."""
    match law:
        case StribeckFriction():
            own = (law.breakaway, law.stribeck_speed, law.exponent)
            return "STRIBECK_FRICTION", tuple(map(float, own))
        case LoadFriction():
            return "LOAD_DEPENDENT_FRICTION", (float(law.load_share),)
        case LugreFriction():
            bristles = (law.bristle_stiffness, law.bristle_damping)
            return "LUGRE_FRICTION", tuple(map(float, (law.breakaway, law.stribeck_speed, *bristles)))
        case Friction():
            positive, negative = float(law.coulomb_positive), -float(law.coulomb_negative)
            return "COULOMB_VISCOUS_FRICTION", (UNSET if negative == positive else negative,)
        case _:
            assert_never(law)
