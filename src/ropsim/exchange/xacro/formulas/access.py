"""Parts of values: members, elements, slices, and results of methods."""

from collections.abc import Mapping

from ropsim.exchange.xacro.formulas.meanings import Arguments, Meaning
from ropsim.exchange.xacro.formulas.methods import method_of
from ropsim.exchange.xacro.formulas.names import Names
from ropsim.exchange.xacro.formulas.operators import applied
from ropsim.exchange.xacro.formulas.values import Key, NameSpace, Value, XacroError, key_of, words


def method_called(of: Meaning, name: str, arguments: Arguments) -> Meaning:
    """Return the result of a method of a value; it costs as many characters as its owner has tens."""
    places, keywords = arguments

    def found(names: Names) -> Value:
        owner = of(names)
        method = method_of(owner, name)
        names.file.spend(len(owner) // 10 if isinstance(owner, str | list | tuple | dict) else 0)
        values = [owner, *(part(names) for part in places)]
        return applied(name, method, values, {key: part(names) for key, part in keywords.items()})

    return found


def member(of: Meaning, name: str) -> Meaning:
    """Return the value with a name in a dictionary or name space."""

    def found(names: Names) -> Value:
        holder = of(names)
        if isinstance(holder, Mapping):
            if name in holder:
                return holder[name]
            raise XacroError(f"a dictionary has no key `{name[:40]}`", _keys(holder))
        if isinstance(holder, NameSpace):
            return holder.value(name)
        raise XacroError(
            f"`.{name[:40]}` is not carried out on `{words(holder)[:40]}`", "allowed on dictionaries"
        )

    return found


def indexed(of: Meaning, index: Meaning) -> Meaning:
    """Return the value at an index of a list or text, or at a key of a dictionary."""

    def found(names: Names) -> Value:
        holder, key = of(names), index(names)
        if isinstance(holder, Mapping):
            if key_of(key) in holder:
                return holder[key_of(key)]
            raise XacroError(f"a dictionary has no key `{str(key)[:40]}`", _keys(holder))
        if (
            isinstance(holder, list | tuple | str)
            and isinstance(key, int)
            and -len(holder) <= key < len(holder)
        ):
            return holder[key]
        raise XacroError(f"there is nothing at `{str(key)[:40]}`", "look at the list or dictionary")

    return found


def sliced(of: Meaning, ends: list[Meaning]) -> Meaning:
    """Return a part of a list or text, by start, stop and step."""

    def found(names: Names) -> Value:
        holder = of(names)
        if not isinstance(holder, list | tuple | str):
            raise XacroError(f"`{words(holder)[:40]}` has no slices", "allowed on lists and texts")
        start, stop, step = [*(_end(end(names)) for end in ends), None][:3]
        return applied("slice", lambda: holder[start:stop:step], ())

    return found


def _end(value: Value) -> int | None:
    if value is None or isinstance(value, int):
        return value
    raise XacroError(f"a slice ends at `{words(value)[:40]}`", "write whole numbers")


def _keys(holder: Mapping[Key, Value]) -> str:
    return f"keys are {', '.join(str(key)[:30] for key in list(holder)[:8])}" if holder else "it is empty"
