"""Origins of estimated groups of parameters, in words: the rule, and how far it may be off."""

from collections.abc import Iterable, Iterator, Sequence
from math import isfinite

from ropsim.model import ArmClass, OriginKind, ParameterOrigin
from ropsim.robotfile.estimation import joint_friction, rotors, torque_limits
from ropsim.robotfile.estimation.accelerations import TO_FULL_SPEED, TO_FULL_SPEED_OF_WRIST, USED_SHARE
from ropsim.robotfile.estimation.joint_friction import CompletedFrictions
from ropsim.robotfile.estimation.link_masses import DENSITY

MASSES_OFF = "loads ±12 %"
"""How far gravity and inertia of the axes may be off with the rated payload, if the total mass is known."""
MASSES_WEAKLY_OFF = "loads ×1.75"
"""The same if the total mass is also an estimate."""
_UNPROVEN = (ArmClass.PALLETIZER, ArmClass.SCARA)


def mass_origin(arm_class: ArmClass, total: float, source: str) -> ParameterOrigin:
    """Return the origin of masses that are shares of a known total mass.

    Args:
        arm_class: of the arm.
        total: mass with the base [kg].
        source: where the total mass is from; empty if that is not said.
    """
    whole = f"{total:.4g} kg in all" + (f" ({source})" if source else "")
    return _mass_origin(arm_class, whole, MASSES_OFF)


def size_mass_origin(arm_class: ArmClass, total: float) -> ParameterOrigin:
    """Return the origin of masses where the total mass is also an estimate, by payload and reach.

    Args:
        arm_class: of the arm.
        total: mass with the base [kg].
    """
    return _mass_origin(arm_class, f"{total:.3g} kg in all by payload and reach", MASSES_WEAKLY_OFF)


def _mass_origin(arm_class: ArmClass, whole: str, off: str) -> ParameterOrigin:
    words = f"{whole}, in the shares of {arm_class.value} arms, as cylinders of {DENSITY:g} kg/m³"
    return ParameterOrigin(
        f"masses ({'unproven' if arm_class in _UNPROVEN else off})", OriginKind.ESTIMATED, words
    )


def torque_origin(names: Sequence[str], count: int, payload: float, why: str) -> ParameterOrigin:
    """Return the origin of torque limits.

    Args:
        names: of their axes.
        count: number of all axes.
        payload: that they hold [kg]; inf for none.
        why: further words.
    """
    which = "" if len(names) == count else f" of {', '.join(names)}"
    load = f"{payload:g} kg" if isfinite(payload) else "no load"
    words = f"multiples of the torque that holds the arm with {load} against gravity{why}"
    return ParameterOrigin(f"torque limits{which} ({torque_limits.ACCURACY})", OriginKind.ESTIMATED, words)


def replaced_words(names: Sequence[str], limits: Sequence[float], gravity: Sequence[float]) -> str:
    """Return why limits of a file are replaced, with both numbers of each.

    Args:
        names: of the axes.
        limits: in the file [N·m | N].
        gravity: greatest torque or force that gravity takes with the rated payload [N·m | N].
    """
    rows = zip(names, limits, gravity, strict=True)
    figures = ", ".join(f"{name} {limit:.4g} of which gravity takes {held:.4g}" for name, limit, held in rows)
    return f"; those of the file do not hold the arm: {figures}"


def balance_origin(names: Sequence[str]) -> ParameterOrigin:
    """Return the origin of published limits that do not hold the rated payload in every posture."""
    words = (
        f"gravity with the rated payload takes more than {100.0 * torque_limits.HELD_SHARE:.3g} % "
        "of the published "
        f"torque of {', '.join(names)}: springs or weights balance the arm, or "
        "loads have further limits"
    )
    return ParameterOrigin("balance of the arm", OriginKind.DERIVED, words)


def rotor_origin() -> ParameterOrigin:
    """Return the origin of rotors and gear ratios."""
    words = (
        f"{rotors.MAIN:g} s, of the wrist {rotors.WRIST:g} s, times torque limit over speed at the joint; "
        f"motors turn at {rotors.MOTOR_SPEED:g} rad/s at full speed"
    )
    return ParameterOrigin(f"rotors and gears ({rotors.ACCURACY})", OriginKind.ESTIMATED, words)


def friction_origins(names: Sequence[str], made: CompletedFrictions) -> list[ParameterOrigin]:
    """Return the origins of friction that is known of some axes, and by rule of the others.

    Args:
        names: of all axes.
        made: their friction.
    """
    words = (
        f"dry {100.0 * joint_friction.DRY:.3g} % of the torque limit, of the wrist "
        f"{100.0 * joint_friction.DRY_OF_WRIST:.3g} %; "
        f"viscous {100.0 * joint_friction.VISCOUS:.3g} % of it at full speed"
    )
    if made.unused:
        axes = ", ".join(names[k] for k in made.unused)
        words += f"; viscous friction of {axes} in the file is below a hundredth of that, and not used"
    every = range(len(names))
    by_rule = (tuple(k for k in every if k not in one) for one in (made.dry, made.viscous))
    known = (
        ParameterOrigin(group, OriginKind.DERIVED, "read from the file")
        for group in _frictions(names, made.dry, made.viscous)
    )
    estimated = (
        ParameterOrigin(f"{group} ({joint_friction.ACCURACY})", OriginKind.ESTIMATED, words)
        for group in _frictions(names, *by_rule)
    )
    return [*known, *estimated]


def _frictions(names: Sequence[str], dry: Sequence[int], viscous: Sequence[int]) -> Iterator[str]:
    """Yield the names of the groups of dry friction and of viscous friction, with their axes."""
    groups = (
        (("friction", dry),) if dry == viscous else (("dry friction", dry), ("viscous friction", viscous))
    )
    for group, axes in groups:
        if axes:
            yield group + ("" if len(axes) == len(names) else f" of {', '.join(names[k] for k in axes)}")


def acceleration_origin() -> ParameterOrigin:
    """Return the origin of joint accelerations and jerks."""
    words = (
        f"full speed within {TO_FULL_SPEED:g} s, of the wrist {TO_FULL_SPEED_OF_WRIST:g} s, as far as "
        f"{USED_SHARE:g} of the torque limits allow it in most postures; full acceleration within 0.1 s"
    )
    return ParameterOrigin("joint accelerations and jerks", OriginKind.ESTIMATED, words)


def without_accelerations(origins: Iterable[ParameterOrigin]) -> list[ParameterOrigin]:
    """Return origins without estimates of accelerations and jerks; speeds of the same groups stay."""
    found = []
    for one in origins:
        if one.kind is not OriginKind.ESTIMATED or "acceleration" not in one.parameters:
            found.append(one)
        elif "speed" in one.parameters:
            found.append(ParameterOrigin("joint speeds", OriginKind.ESTIMATED, one.source.partition(";")[0]))
    return found
