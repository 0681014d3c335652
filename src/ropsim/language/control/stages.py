"""Parts of the control statements processed in groups; a group with unchanged context is skipped."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, Generic, Protocol, TypeVar

from ropsim.language.check.one_part import Left
from ropsim.language.control.way import Way
from ropsim.language.questions import Group
from ropsim.query import splice


class _Step(Protocol):
    """A part on the way."""

    @property
    def unit(self) -> str:
        """Return its name."""
        ...

    @property
    def mentions(self) -> tuple[str, ...]:
        """Return the names that it mentions."""
        ...

    @property
    def left(self) -> Left:
        """Return its effect on later parts."""
        ...


S = TypeVar("S", bound=_Step)
S_co = TypeVar("S_co", bound=_Step, covariant=True)


class _Stage(Protocol[S_co]):
    """A group of parts on the way."""

    @property
    def group(self) -> Group:
        """Return their units."""
        ...

    @property
    def steps(self) -> tuple[S_co, ...]:
        """Return the parts."""
        ...

    @property
    def mentions(self) -> frozenset[str]:
        """Return the names that they mention."""
        ...

    @property
    def left(self) -> Left:
        """Return their effect on later parts."""
        ...


G = TypeVar("G", bound=_Stage[Any])


class Stages(ABC, Generic[S, G]):
    """Goes through the parts."""

    def __init__(self) -> None:
        self._way = Way()
        self._passed: list[S | G] = []

    @abstractmethod
    def is_as_before(self, stage: G) -> bool:
        """Return whether all parts of a group with unchanged context would have unchanged results."""

    @abstractmethod
    def is_step_as_before(self, step: S) -> bool:
        """Return whether a part with unchanged context would have an unchanged result."""

    @abstractmethod
    def step(self, unit: str, known: S | None) -> S:
        """Process a part; `known` is its last result if its context is unchanged."""

    @abstractmethod
    def leaves_as_before(self, before: S, step: S) -> bool:
        """Return whether the effect of a part on later parts is unchanged."""

    @abstractmethod
    def stage(self, group: Group, steps: tuple[S, ...]) -> G:
        """Put parts together."""

    def go_through(self, groups: Sequence[Group], past: Sequence[G]) -> list[G]:
        """Return the stages of all groups; `past` are the last ones."""
        unchanged = splice([one.group for one in past], groups)
        found = [self._pass(one) for one in unchanged.known_above(past)]
        found += self._between(unchanged.between(groups), unchanged.between(past))
        found += [self._pass(one) for one in unchanged.known_below(past)]
        return found

    def catch_up(self) -> Way:
        """Return the state behind the parts so far."""
        for one in self._passed:
            self.go_behind(one)
        self._passed.clear()
        return self._way

    def pass_by(self, one: S | G) -> None:
        """Skip an unchanged part or group; the state behind it is computed when it is requested."""
        self._passed.append(one)

    def go_behind(self, one: S | G) -> None:
        """Continue the state behind a skipped part or group."""
        self._way.pass_by(one.left)

    def went(self, before: S | None, step: S | None) -> None:
        """Continue the state behind a part, from its last and its present result; None if there is none."""
        way = self.catch_up()
        if before is not None:
            way.would_go_on(before.left)
        if step is not None:
            way.go_on(step.left)

    def _pass(self, stage: G) -> G:
        if not self._catch_up_if_new().is_new_to(stage.mentions) and self.is_as_before(stage):
            self.pass_by(stage)
            return stage
        return self.stage(stage.group, tuple(self._pass_step(one.unit, one) for one in stage.steps))

    def _between(self, groups: Sequence[Group], past: Sequence[G]) -> list[G]:
        """Return the stages of groups that differ from the last ones."""
        units = [unit for group in groups for unit in group]
        steps = [step for stage in past for step in stage.steps]
        unchanged = splice([one.unit for one in steps], units)
        made = [self._pass_step(one.unit, one) for one in unchanged.known_above(steps)]
        for one in unchanged.between(steps):
            self.went(one, None)
        made += [self._pass_step(unit, None) for unit in unchanged.between(units)]
        made += [self._pass_step(one.unit, one) for one in unchanged.known_below(steps)]
        found, at = [], 0
        for group in groups:
            found.append(self.stage(group, tuple(made[at : at + len(group)])))
            at += len(group)
        return found

    def _pass_step(self, unit: str, before: S | None) -> S:
        is_known = before is not None and not self._catch_up_if_new().is_new_to(before.mentions)
        known = before if is_known else None
        if known is not None and self.is_step_as_before(known):
            self.pass_by(known)
            return known
        step = self.step(unit, known)
        if before is not None and self.leaves_as_before(before, step):
            self.pass_by(step)
        else:
            self.went(before, step)
        return step

    def _catch_up_if_new(self) -> Way:
        """Return the state; the last skipped part counts only if something changed before it."""
        if self._way.drift:
            return self.catch_up()
        if self._passed:
            self._way.left = self._way.left_before = self._passed[-1].left
        return self._way
