"""Frozen dataclasses of the house against those of the standard library."""

import copy
import inspect
import pickle
from dataclasses import KW_ONLY, FrozenInstanceError, dataclass, field, fields, is_dataclass, replace
from typing import Any, ClassVar
from weakref import ref

import pytest

from ropsim.core import frozen_dataclass, frozen_without_equality, maker


@frozen_dataclass
class Ours:
    """A line with all that a field can be."""

    kind: ClassVar[str] = "class"
    x: float
    y: float = 2.0
    tags: list[str] = field(default_factory=list, compare=False)
    hidden: int = field(default=3, repr=False)
    data: dict[str, int] = field(default_factory=dict, hash=False)
    made: int = field(init=False, default=0)
    _: KW_ONLY
    unit: str = "mm"

    def __post_init__(self) -> None:
        object.__setattr__(self, "made", int(self.x))


@frozen_dataclass
class Longer(Ours):
    """One field more."""

    z: float = 0.0


@frozen_dataclass
class Empty:
    """Nothing."""


@frozen_dataclass
class Angle:
    """Equal modulo a turn."""

    degrees: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Angle) and self.degrees % 360 == other.degrees % 360

    def __hash__(self) -> int:
        return hash(self.degrees % 360)


@frozen_without_equality
class Single:
    """Equal to itself."""

    x: int


@dataclass(frozen=True, slots=True)
class Theirs:
    """The same fields by the standard library."""

    kind: ClassVar[str] = "class"
    x: float
    y: float = 2.0
    tags: list[str] = field(default_factory=list, compare=False)
    hidden: int = field(default=3, repr=False)
    data: dict[str, int] = field(default_factory=dict, hash=False)
    made: int = field(init=False, default=0)
    _: KW_ONLY
    unit: str = "mm"

    def __post_init__(self) -> None:
        object.__setattr__(self, "made", int(self.x))


CALLS: tuple[tuple[tuple[float, ...], dict[str, Any]], ...] = (
    ((1.0,), {}),
    ((1.0, 5.0), {"unit": "m"}),
    ((), {"x": 1.5, "tags": ["a"], "hidden": 7}),
)


@pytest.mark.parametrize(("arguments", "named"), CALLS)
def test_objects_are_those_of_the_standard_library(
    arguments: tuple[float, ...], named: dict[str, Any]
) -> None:
    classes: tuple[Any, ...] = (Ours, Theirs)
    ours, theirs = (cls(*arguments, **named) for cls in classes)
    assert repr(ours) == repr(theirs).replace("Theirs", "Ours")
    assert hash(ours) == hash(theirs)
    assert [getattr(ours, one.name) for one in fields(ours)] == [
        getattr(theirs, one.name) for one in fields(theirs)
    ]


@pytest.mark.parametrize("arguments", [(), (1.0, 2.0, [], 3, 0, "mm"), (1.0,) * 9])
def test_wrong_calls_are_refused_by_both(arguments: tuple[Any, ...]) -> None:
    classes: tuple[Any, ...] = (Ours, Theirs)
    for cls in classes:
        with pytest.raises(TypeError, match="argument"):
            cls(*arguments)


def test_signatures_and_patterns_are_the_same() -> None:
    assert [str(one) for one in inspect.signature(Ours).parameters.values()][:2] == [
        "x: float",
        "y: float = 2.0",
    ]
    assert list(inspect.signature(Ours).parameters) == list(inspect.signature(Theirs).parameters)
    assert Ours.__match_args__ == Theirs.__match_args__
    assert is_dataclass(Ours(1.0))
    assert not hasattr(Ours(1.0), "__dict__")


def test_a_class_without_objects_has_its_signature_and_a_subclass_its_constructor() -> None:
    @frozen_dataclass
    class Base:
        """Nobody makes one."""

        x: float
        y: float = 2.0

    @frozen_dataclass
    class Half(Base):
        """Calls the constructor above it."""

        def __init__(self, x: float) -> None:
            Base.__init__(self, x / 2)

    assert str(inspect.signature(Base)) == "(x: float, y: float = 2.0) -> None"
    assert (Half(3.0).x, Half(3.0).y, Base(5.0).x) == (1.5, 2.0, 5.0)


def test_equal_is_what_has_equal_fields_and_one_class() -> None:
    assert Ours(1.0) == Ours(1.0, tags=["not compared"])
    assert Ours(1.0) != Ours(1.5)
    assert Ours(1.0) != Ours(1.0, data={"a": 1})
    other: object = Theirs(1.0)
    assert Ours(1.0) != other
    longer: Ours = Longer(1.0)
    assert longer != Ours(1.0)
    assert Longer(1.0, z=1.0) != Longer(1.0)
    assert len({Longer(1.0), Longer(1.0), Ours(1.0), Empty(), Empty()}) == 3
    assert Empty() == Empty()


def test_a_class_keeps_what_it_says_itself() -> None:
    assert Angle(10) == Angle(370)
    assert len({Angle(10), Angle(370)}) == 1
    assert Single(1) != Single(1)
    one = Single(1)
    assert ref(one)() is one


@pytest.mark.parametrize("one", [Ours(1.0), Longer(1.0, z=4.0), Empty(), Angle(3)])
def test_nothing_can_be_changed(one: Any) -> None:
    with pytest.raises(FrozenInstanceError):
        one.x = 3.0
    with pytest.raises(FrozenInstanceError):
        del one.x
    with pytest.raises(FrozenInstanceError):
        one.another = 3.0


@pytest.mark.parametrize("one", [Ours(1.0, tags=["a"]), Longer(1.0, z=4.0), Empty()])
def test_copies_are_equal(one: Any) -> None:
    assert pickle.loads(pickle.dumps(one)) == one
    assert copy.copy(one) == copy.deepcopy(one) == one


@frozen_dataclass
class Odd:
    """Fields that are called like what a constructor may use."""

    missing: int
    set_x: int
    x: list[int] = field(default_factory=list)
    make_x: int = 2
    default_x: int = 3


def test_fields_may_have_any_name() -> None:
    one = Odd(5, 6)
    assert (one.missing, one.set_x, one.x, one.make_x, one.default_x) == (5, 6, [], 2, 3)
    assert Odd(5, 6, [1]).x == [1]


def test_replaced_fields_are_told_anew() -> None:
    changed = replace(Longer(1.0, unit="m"), x=7.0)
    assert (changed.x, changed.made, changed.unit, changed.z) == (7.0, 7, "m", 0.0)


@frozen_dataclass
class Counted:
    """With a field that nobody gives, and one with a name that functions like for their object."""

    self: int
    turns: int = field(init=False, default=4)


def test_a_field_that_is_not_given_has_its_default() -> None:
    assert Counted(1).turns == 4
    assert Counted(self=1) == Counted(1)


def test_a_class_that_says_when_it_is_equal_has_the_hash_of_its_fields() -> None:
    @frozen_dataclass
    class Same:
        x: int

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Same)

    assert hash(Same(1)) == hash(Same(1))


def test_a_class_that_asks_its_parent_keeps_its_own_answer() -> None:
    @frozen_dataclass
    class Parent:
        x: int

    class Never(Parent):
        def __eq__(self, other: object) -> bool:
            assert super().__eq__(other) in (True, NotImplemented)
            return False

        def __hash__(self) -> int:
            return super().__hash__() ^ 1

    one = Never(1)
    assert [one == Never(1) for _ in range(3)] == [False, False, False]
    assert hash(one) == hash(one) == hash(Parent(1)) ^ 1
    assert Parent(1) == Parent(1)


def test_deleting_is_told_as_such() -> None:
    with pytest.raises(FrozenInstanceError, match="cannot delete field 'x'"):
        del Ours(1.0).x


class Child(Longer):
    """A class of its own that is no dataclass of the house."""

    __slots__ = ()


def test_an_object_of_many_fields_is_of_its_own_class_and_frozen() -> None:
    for one in (Longer(1.5, z=2.0), Child(1.5, z=2.0)):
        assert (one.x, one.y, one.z, one.made, one.unit) == (1.5, 2.0, 2.0, 1, "mm")
        with pytest.raises(FrozenInstanceError):
            one.x = 2.0  # type: ignore[misc]  # what is tested
    assert type(Longer(1.5)) is Longer
    assert type(Child(1.5)) is Child


def test_a_maker_makes_what_a_call_of_the_class_makes() -> None:
    made = maker(Angle)(30)
    assert type(made) is Angle
    assert made.degrees == 30
    with pytest.raises(FrozenInstanceError):
        made.degrees = 2  # type: ignore[misc]  # what is tested
