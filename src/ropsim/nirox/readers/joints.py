"""The joints of a file with their limits; missing data of an axis are estimated, and reported."""

from dataclasses import replace
from math import inf, isclose, pi

from ropsim.model import WITHOUT_END, Joint, JointType
from ropsim.nirox.diagnostics import ESTIMATED, IMPOSSIBLE
from ropsim.nirox.readers.mechanism import Mechanism, Moved
from ropsim.nirox.readers.seen import Seen

_SPEEDS = {JointType.REVOLUTE: pi, JointType.PRISMATIC: 0.5}  # [rad/s | m/s]
_TO_SPEED = 0.25  # [s] until the greatest speed is reached with the greatest acceleration
_TO_ACCELERATION = 0.1  # [s] until that is reached with the greatest jerk
_AGREES = 1e-6


class Joints:
    """The joints of a file.

    Attributes:
        estimated: names of axes of which limits were estimated.
    """

    def __init__(self, seen: Seen, mechanism: Mechanism, axes: list[int]) -> None:
        """Begin with the numbers of the joints that are axes."""
        self._seen = seen
        self._mechanism = mechanism
        self._axes = set(axes)
        self.estimated: list[str] = []
        self.joints = tuple(self._joint(number, one) for number, one in enumerate(mechanism.moved))

    def home(self, number: int, states: dict[int, float]) -> float:
        """Return the rest position of an axis [rad | m].

        Args:
            number: of the joint.
            states: values of pairs in the rest position, by number.
        """
        seen, joint, pair = self._seen, self.joints[number], self._mechanism.moved[number].pair
        coordinate = seen.user(pair, "axis_coordinate", "pair")
        exact = coordinate is not None and seen.has(coordinate, "home")
        if pair in states:
            found = states[pair] - joint.offset if joint.offset else states[pair]
        else:
            found = min(max(0.0, joint.lower), joint.upper)
        if coordinate is None or not exact:
            return found
        home = seen.real(coordinate, "home")
        if pair in states and not isclose(home, found, abs_tol=_AGREES):
            seen.note(
                IMPOSSIBLE, coordinate, f"`home` is {home:g}, the state says {found:g}", "keep one of them"
            )
        return home

    def _joint(self, number: int, moved: Moved) -> Joint:
        seen, pair = self._seen, moved.pair
        name = seen.text(moved.joint, "name") or str(number + 1)
        offset, lower, upper = self._range(moved)
        limits = seen.user(pair, "joint_limits", "pair")
        if limits is not None:
            seen.take(limits, "limits", number)
        train = seen.user(pair, "drive_train", "pair")
        lead = 0.0
        if moved.type is JointType.SCREW:
            lead = self._mechanism.units.length.si(seen.real(pair, "pitch"))
        joint = Joint(
            name,
            moved.type,
            moved.placement,
            offset,
            lower,
            upper,
            max_speed=self._most("max_speed", train, limits),
            max_acceleration=self._most("max_acceleration", train, limits),
            max_jerk=self._most("max_jerk", train, limits),
            max_effort=self._most("max_effort", None, limits),
            parent=moved.parent,
            lead=lead,
        )
        return self._estimated(joint, pair) if number in self._axes else joint

    def _range(self, moved: Moved) -> tuple[float, float, float]:
        """Return offset and limits of the coordinate of a joint."""
        seen, pair, units = self._seen, moved.pair, self._mechanism.units
        word, unit = "rotation", units.angle
        if moved.type is JointType.PRISMATIC:
            word, unit = "translation", units.length
        names = [f"{end}_limit_actual_{word}" for end in ("lower", "upper")]
        lower, upper = -inf, inf
        if moved.type.freedoms == 1:
            found = [unit.si(seen.real(pair, name)) if seen.has(pair, name) else None for name in names]
            lower = -inf if found[0] is None else found[0]
            upper = inf if found[1] is None else found[1]
        coordinate = seen.user(pair, "axis_coordinate", "pair")
        if coordinate is None:
            return 0.0, lower, upper
        seen.take(coordinate, "coordinate", self._mechanism.pairs[pair])
        offset = seen.real(coordinate, "offset")
        bounds = []
        for name, bound in (("lower", lower), ("upper", upper)):
            exact = seen.real(coordinate, name) if seen.has(coordinate, name) else bound - offset
            if abs(bound) != inf and not isclose(exact, bound - offset, abs_tol=_AGREES):
                words = f"`{name}` is {exact:g}, the range of the pair says {bound - offset:g}"
                seen.note(IMPOSSIBLE, coordinate, words, "keep one of them")
            bounds.append(exact)
        return offset, bounds[0], bounds[1]

    def _most(self, name: str, train: int | None, limits: int | None) -> float:
        for number in (train, limits):
            if number is not None and self._seen.has(number, name):
                return self._seen.real(number, name)
        return inf

    def _estimated(self, joint: Joint, pair: int) -> Joint:
        """Return an axis with estimates for missing data."""
        lower, upper = joint.lower, joint.upper
        if inf in (-lower, upper):
            if joint.measure is JointType.PRISMATIC:
                self._seen.note(IMPOSSIBLE, pair, "an axis that slides has no limits", "write its range")
            lower, upper = max(lower, -WITHOUT_END), min(upper, WITHOUT_END)
        speed = joint.max_speed if joint.max_speed < inf else _SPEEDS[joint.measure]
        acceleration = joint.max_acceleration if joint.max_acceleration < inf else speed / _TO_SPEED
        jerk = joint.max_jerk if joint.max_jerk < inf else acceleration / _TO_ACCELERATION
        found = replace(
            joint, lower=lower, upper=upper, max_speed=speed, max_acceleration=acceleration, max_jerk=jerk
        )
        if found != joint:
            self.estimated.append(joint.name)
            words = f"limits of axis `{joint.name}` are not said and estimated"
            self._seen.note(
                ESTIMATED, pair, words, "write those of the data sheet into DRIVE_TRAIN or JOINT_LIMITS"
            )
        return found
