"""Frozen, slotted dataclasses in a third of the time: hundreds of them are made whenever a process starts."""

from collections.abc import Callable
from dataclasses import MISSING, Field, FrozenInstanceError, dataclass, field, fields
from reprlib import recursive_repr
from typing import Any, ParamSpec, TypeVar, cast, dataclass_transform

P = ParamSpec("P")
T = TypeVar("T")

_MANY = 4
"""Number of fields from which setting them while the object has another class is faster; the change costs as
much as three."""
_become = vars(object)["__class__"].__set__


@dataclass_transform(frozen_default=True, field_specifiers=(field,))
def frozen_dataclass(cls: type[T]) -> type[T]:
    """Make the same class as `dataclass(frozen=True, slots=True)`, with equality by class and fields."""
    made: type[T] = dataclass(slots=True, init=False, eq=False, repr=False)(cls)
    return _completed(made, _METHODS | _EQUALITY, cls)


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
def frozen_without_equality(cls: type[T]) -> type[T]:
    """Make the same for classes with another meaning of equal; objects can be referred to weakly."""
    made: type[T] = dataclass(slots=True, init=False, eq=False, repr=False, weakref_slot=True)(cls)
    return _completed(made, _METHODS, cls)


def maker(cls: Callable[P, T]) -> Callable[P, T]:
    """Return a function that makes objects of a frozen dataclass in two thirds of the time of its own call.

    It is for records of which thousands are made at one place: it takes all fields, and calls no
    `__post_init__`.
    """
    made = cast("type[Any]", cls)
    names = [one.name for one in fields(made)]
    known = {"__new__": object.__new__, "__frozen__": made, "__open__": _open(made)}
    lines = ("__self__ = __new__(__open__)", *(f"__self__.{name} = {name}" for name in names))
    body = "\n ".join((*lines, "__self__.__class__ = __frozen__", "return __self__"))
    exec(f"def make({', '.join(names)}):\n {body}", known)
    return cast("Callable[P, T]", known["make"])


def _completed(made: type[T], methods: dict[str, Callable[..., object]], written: type) -> type[T]:
    """Add to a class its constructor and the methods that it does not define."""
    late: dict[str, object] = {"__init__": _LateConstructor(made)}
    for name, method in (late | methods).items():
        said = written.__dict__.get(name)  # a class that says `__eq__` is given `__hash__ = None` by Python
        if said is None:
            setattr(made, name, method)
    return made


class _LateConstructor:
    """Makes the constructor of a class at its first use: most classes never have an object."""

    def __init__(self, cls: type) -> None:
        self.cls = cls

    def __get__(self, one: object, owner: type | None = None) -> Callable[..., None]:
        """Put the constructor in this place and return it, bound to an object where there is one."""
        known: dict[str, Any] = {"__missing__": MISSING}
        constructor = _method(self.cls, "__init__", _constructor(self.cls, known), known)
        annotations = {part.name: part.type for part in _parts(self.cls) if part.init}
        constructor.__annotations__ = {**annotations, "return": None}
        bound: Callable[..., None] = constructor.__get__(one, owner)
        return bound


def _method(cls: type, name: str, source: str, known: dict[str, Any]) -> Callable[..., Any]:
    """Compile a method of a class from its source, as dataclasses does it."""
    exec(source, known)
    made: Callable[..., Any] = known[name]
    made.__qualname__, made.__module__ = f"{cls.__qualname__}.{name}", cls.__module__
    setattr(cls, name, made)
    return made


def _constructor(cls: type, known: dict[str, Any]) -> str:
    """Return `__init__`: it sets the fields and calls `__post_init__` where there is one."""
    arguments, made, lines, plain = ["__self__"], [], [], []
    parts = sorted(_parts(cls), key=lambda one: bool(one.kw_only))
    for one in parts:
        name = one.name
        known[f"__set_{name}__"] = getattr(cls, name).__set__  # names that no field has
        value = name
        if one.init:
            if one.kw_only and "*" not in arguments:
                arguments.append("*")
            arguments.append(name + _default(one, known))
        elif one.default is not MISSING:
            known[f"__default_{name}__"] = one.default
            value = f"__default_{name}__"
        if one.default_factory is not MISSING:
            known[f"__make_{name}__"] = one.default_factory
            given = f"{name} if {name} is not __missing__ else " if one.init else ""
            made.append(f"{name} = {given}__make_{name}__()")
        if one.init or one.default is not MISSING or one.default_factory is not MISSING:
            lines.append(f"__set_{name}__(__self__, {value})")
            plain.append(f"__self__.{name} = {value}")
    if len(lines) >= _MANY:
        known |= {"__type__": type, "__frozen__": cls, "__become__": _become, "__open__": _open(cls)}
        opened = ["__become__(__self__, __open__)", *plain, "__self__.__class__ = __frozen__"]
        lines = ["if __type__(__self__) is __frozen__:", *_indented(opened), "else:", *_indented(lines)]
    after = ["__self__.__post_init__()"] if hasattr(cls, "__post_init__") else []
    return "\n ".join((f"def __init__({', '.join(arguments)}):", *made, *lines, *after, "pass"))


def _open(cls: type) -> type:
    """Return a class with the same fields that can be assigned, which Python does in a tenth of the time.

    An object of many fields is one of it while they are set.
    """
    free = {"__slots__": (), "__setattr__": object.__setattr__, "__delattr__": object.__delattr__}
    return type(cls.__name__, (cls,), free)


def _indented(lines: list[str]) -> list[str]:
    return [" " + line for line in lines]


def _default(one: "Field[Any]", known: dict[str, Any]) -> str:
    if one.default is not MISSING:
        known[f"__default_{one.name}__"] = one.default
        return f"=__default_{one.name}__"
    return "=__missing__" if one.default_factory is not MISSING else ""


def _equal(self: object, other: object) -> bool:
    """Compare two objects of a class for the first time: few classes ever come to it."""
    cls = _made_here(self, "__eq__", _equal)
    names = [one.name for one in _parts(cls) if one.compare]
    test = f"{_content(names, 'self')} == {_content(names, 'other')}"
    source = (
        f"def __eq__(self, other):\n return {test} if other.__class__ is self.__class__ else NotImplemented"
    )
    found: bool = _method(cls, "__eq__", source, {})(self, other)
    return found


def _hash(self: object) -> int:
    """Return the hash of an object, the first of its class that is hashed."""
    cls = _made_here(self, "__hash__", _hash)
    names = [one.name for one in _parts(cls) if (one.compare if one.hash is None else one.hash)]
    source = f"def __hash__(self):\n return hash({_content(names, 'self')})"
    found: int = _method(cls, "__hash__", source, {})(self)
    return found


def _made_here(self: object, name: str, method: Callable[..., object]) -> type:
    """Return the class for which a method is still to be made: of the object, or one that it comes from."""
    return next(cls for cls in type(self).__mro__ if cls.__dict__.get(name) is method)


def _parts(cls: type) -> "tuple[Field[Any], ...]":
    return fields(cls)


def _content(names: list[str], who: str) -> str:
    return f"({''.join(f'{who}.{name}, ' for name in names)})"


@recursive_repr()
def _shown(self: object) -> str:
    parts = (f"{one.name}={getattr(self, one.name)!r}" for one in _parts(type(self)) if one.repr)
    return f"{type(self).__qualname__}({', '.join(parts)})"


def _refuse(_self: object, name: str, _value: object = None) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _refuse_to_delete(_self: object, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: object) -> list[object]:
    return [getattr(self, one.name) for one in _parts(type(self))]


def _restore(self: object, state: list[object]) -> None:
    for one, value in zip(_parts(type(self)), state, strict=True):
        object.__setattr__(self, one.name, value)


_METHODS: dict[str, Callable[..., object]] = {
    "__repr__": _shown,
    "__setattr__": _refuse,
    "__delattr__": _refuse_to_delete,
    "__getstate__": _state,
    "__setstate__": _restore,
}
_EQUALITY: dict[str, Callable[..., object]] = {"__eq__": _equal, "__hash__": _hash}
