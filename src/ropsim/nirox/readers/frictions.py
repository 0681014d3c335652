"""The friction of a pair in a file, as the law at the motor that the model has."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from ropsim.model import Friction, FrictionLaw, LoadFriction, LugreFriction, StribeckFriction
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.readers.seen import Seen


class _Entry(NamedTuple):
    """An entity of friction.

    Attributes:
        seen: the file.
        number: of the entity.
        ratio: by which speeds of the entity are to be multiplied, and torques divided, to be at the motor.
        smoothing: speed of the joint over which dry friction changes its sign [rad/s | m/s].
    """

    seen: Seen
    number: int
    ratio: float
    smoothing: float

    def torque(self, name: str) -> float:
        """Return a torque at the motor [N·m | N]."""
        return self.seen.real(self.number, name) / self.ratio

    def speed(self, name: str) -> float:
        """Return a speed at the motor [rad/s | m/s]."""
        return self.seen.real(self.number, name) * self.ratio

    def rate(self, name: str) -> float:
        """Return a torque over a speed, or over an angle, at the motor."""
        return self.seen.real(self.number, name) / self.ratio**2


def _coulomb_viscous(entry: _Entry) -> FrictionLaw:
    positive = entry.torque("coulomb")
    given = entry.seen.has(entry.number, "coulomb_negative")
    negative = entry.torque("coulomb_negative") if given else positive
    return Friction(entry.rate("viscous"), positive, -negative, entry.smoothing)


def _stribeck(entry: _Entry) -> FrictionLaw:
    exponent = entry.seen.real(entry.number, "exponent")
    torques = (entry.torque("coulomb"), entry.torque("breakaway"))
    speed = entry.speed("stribeck_velocity")
    return StribeckFriction(entry.rate("viscous"), *torques, speed, exponent, entry.smoothing)


def _load_dependent(entry: _Entry) -> FrictionLaw:
    share = entry.seen.real(entry.number, "coefficient")
    if share >= 1.0:
        what = f"`coefficient` is {share:g}, allowed is less than 1: such a gear would not turn"
        raise entry.seen.impossible(entry.number, what)
    return LoadFriction(entry.rate("viscous"), entry.torque("coulomb"), share, entry.smoothing)


def _lugre(entry: _Entry) -> FrictionLaw:
    coulomb, breakaway = entry.torque("coulomb"), entry.torque("breakaway")
    if not 0.0 < coulomb <= breakaway:
        what = "`coulomb` is 0, or more than `breakaway`: there would be nothing for bristles to bear"
        raise entry.seen.impossible(entry.number, what)
    return LugreFriction(
        entry.rate("viscous"),
        coulomb,
        breakaway,
        entry.speed("stribeck_velocity"),
        entry.rate("bristle_stiffness"),
        entry.rate("bristle_damping"),
        entry.smoothing,
    )


_LAWS: Mapping[str, Callable[[_Entry], FrictionLaw]] = MappingProxyType(
    {
        "coulomb_viscous_friction": _coulomb_viscous,
        "stribeck_friction": _stribeck,
        "load_dependent_friction": _load_dependent,
        "lugre_friction": _lugre,
    }
)


def read_friction(seen: Seen, pair: int, ratio: float, number: int) -> FrictionLaw:
    """Return the friction of a pair; none without an entity of it.

    Args:
        seen: the file.
        pair: number of the pair.
        ratio: of its gear.
        number: of the joint.

    Raises:
        ImpossibleError: numbers of a law do not go together.
    """
    entries = seen.users(pair, "joint_friction", "pair")
    if not entries:
        return Friction()
    one = entries[0]
    seen.take(one, "friction", number)
    for other in entries[1:]:
        seen.note(LOST, other, "the joint has friction on both sides: this one has no effect")
    smoothing = Friction().smoothing_speed
    companion = seen.user(one, "friction_smoothing", "friction")
    if companion is not None:
        seen.take(companion, "friction", number, "smoothing")
        smoothing = seen.real(companion, "speed")
    at_joint = seen.text(one, "side") == "joint_side"
    entry = _Entry(seen, one, abs(ratio) if at_joint else 1.0, smoothing)
    law = next(law for entity, law in _LAWS.items() if seen.is_a(one, entity))
    return law(entry)
