"""A section of a TOML file, read with care: every getter returns a usable value and notes errors."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import field

from ropsim.core import Diagnostic, Kind, Span, frozen_dataclass, near
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext.positions import Path, Positions
from ropsim.tomltext.quantity import Quantity
from ropsim.tomltext.question import UNKNOWN, Question, Sort
from ropsim.tomltext.words import cut, float_of, sort_of

_SPEAKABLE = re.compile(r"[^\W\d]\w*", re.ASCII)


@frozen_dataclass
class Findings:
    """The diagnostics found so far and the places that they can point to.

    Attributes:
        places: where keys and values stand.
        items: findings.
        questions: the keys that were read, present or not, by their paths.
        needed: paths of required keys.
    """

    places: Positions
    items: list[Diagnostic] = field(default_factory=list)
    questions: dict[Path, Question] = field(default_factory=dict)
    needed: set[Path] = field(default_factory=set)

    def add(self, kind: Kind, span: Span, message: str, hint: str = "", label: str = "") -> None:
        """Note one diagnostic."""
        self.items.append(kind.at(span, message, hint=hint, label=label))

    def ordered(self) -> tuple[Diagnostic, ...]:
        """Return the findings in the order of the text."""
        start = self.places.start
        return tuple(sorted(self.items, key=lambda found: (found.span or start, found.code)))


@frozen_dataclass
class TomlTable:
    """A section or inline table.

    Attributes:
        values: keys and values as `tomllib` read them.
        path: where it stands in the file.
        findings: where mistakes are noted.
        present: False for the stand-in of a table that is missing or of a wrong type.
        asked: keys that were read, in order.
        missing: required keys that are not there.
    """

    values: Mapping[str, object]
    path: Path
    findings: Findings
    present: bool = True
    asked: dict[str, None] = field(default_factory=dict)
    missing: list[str] = field(default_factory=list)

    def __contains__(self, key: str) -> bool:
        self.asked[key] = None
        self.findings.questions.setdefault((*self.path, key), UNKNOWN)
        return key in self.values

    def ask(self, key: str, question: Question) -> None:
        """Note the question for a key."""
        self.findings.questions[*self.path, key] = question

    def name_of(self, key: str) -> str:
        """Return the dotted name of a key, without the indices of lists."""
        return ".".join(part for part in (*self.path, key) if isinstance(part, str))

    def key_span(self, key: str) -> Span:
        """Return where a key stands."""
        return self.findings.places.key((*self.path, key))

    def value_span(self, *steps: str | int) -> Span:
        """Return where the value of a key, or an item of it, stands."""
        return self.findings.places.value((*self.path, *steps))

    def require(self, *keys: str) -> None:
        """Require keys; `finish` notes the missing ones."""
        self.missing.extend(key for key in keys if key not in self and self.present)
        self.findings.needed.update((*self.path, key) for key in keys)

    def finish(self) -> None:
        """Note every key that is missing and every unknown key."""
        unknown = [key for key in self.values if key not in self.asked]
        for key in self.missing:
            if near(key, unknown):
                continue  # most likely misspelt; the unknown key is noted below
            where = f"`{'.'.join(p for p in self.path if isinstance(p, str))}`" if self.path else "the file"
            span = self.findings.places.key(self.path)
            self.findings.add(kinds.MISSING_KEY, span, f"{where} needs `{key}`", f"add `{key}`")
        for key in unknown:
            close = near(key, self.missing, limit=1) or near(key, self.asked, limit=1)
            known = ", ".join(f"`{name}`" for name in sorted(self.asked))
            hint = f"did you mean `{close[0]}`?" if close else f"known here: {known}"
            message = f"`{cut(self.name_of(key))}` has no meaning"
            self.findings.add(kinds.UNKNOWN_KEY, self.key_span(key), message, hint)

    def number(self, key: str, quantity: Quantity, default: float) -> float:
        """Return a number in SI units."""
        self.ask(key, Question(Sort.NUMBER, quantity, default))
        return self.number_at((key,), self.values[key], quantity, default) if key in self else default

    def number_at(
        self, steps: tuple[str | int, ...], value: object, quantity: Quantity, default: float
    ) -> float:
        """Return the number `value` that stands at `steps` below this table, in SI units."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            self.wrong_type(steps, value, "a number")
            return default
        found = float_of(value)
        if isinstance(value, float) and not math.isfinite(found):
            message = f"{self._name(steps)} is `{found}`, needed is a number"
            self.findings.add(kinds.VALUE_NOT_FINITE, self.value_span(*steps), message)
            return default
        if not quantity.low <= found * quantity.scale <= quantity.high:
            message = f"{self._name(steps)} is {quantity.show(found)}, allowed is {quantity.allowed}"
            hint = "are the units in `[units]` the ones you mean?" if quantity.scale != 1.0 else ""
            self.findings.add(kinds.VALUE_OUT_OF_RANGE, self.value_span(*steps), message, hint)
            return default
        return found * quantity.scale

    def numbers(
        self, key: str, count: int | None, quantity: Quantity, default: tuple[float, ...]
    ) -> tuple[float, ...]:
        """Return a list of `count` numbers (None = any count) in SI units."""
        self.ask(key, Question(Sort.NUMBERS, quantity, default, count=count))
        if key not in self:
            return default
        return self.numbers_at((key,), self.values[key], count, quantity, default)

    def numbers_at(
        self,
        steps: tuple[str | int, ...],
        value: object,
        count: int | None,
        quantity: Quantity,
        default: tuple[float, ...],
    ) -> tuple[float, ...]:
        """Return the numbers of the list `value` that stands at `steps` below this table."""
        if not isinstance(value, list):
            self.wrong_type(steps, value, "a list of numbers")
            return default
        if count is not None and len(value) != count:
            self.wrong_count(steps, value, f"{count}")
            return default
        padded = (*default, *([0.0] * len(value)))
        return tuple(self.number_at((*steps, k), item, quantity, padded[k]) for k, item in enumerate(value))

    def wrong_count(self, steps: tuple[str | int, ...], value: Sequence[object], needed: str) -> None:
        """Note that the list `value` at `steps` is too short or too long; needed is "2", or "2: x, y"."""
        items = "1 item" if len(value) == 1 else f"{len(value)} items"
        verb = "is" if needed.partition(":")[0] == "1" else "are"
        message = f"{self._name(steps)} has {items}, needed {verb} {needed}"
        self.findings.add(kinds.WRONG_VALUE_COUNT, self.value_span(*steps), message)

    def integer(self, key: str, low: int, high: int, default: int) -> int:
        """Return a whole number from `low` to `high`."""
        self.ask(key, Question(Sort.WHOLE, Quantity("", 1.0, low, high), default))
        if key not in self:
            return default
        return self.integer_at((key,), self.values[key], low, high, default)

    def integer_at(
        self, steps: tuple[str | int, ...], value: object, low: int, high: int, default: int
    ) -> int:
        """Return the whole number `value` that stands at `steps` below this table."""
        if isinstance(value, bool) or not isinstance(value, int):
            self.wrong_type(steps, value, "a whole number")
            return default
        if not low <= value <= high:
            message = f"{self._name(steps)} is {float_of(value):.6g}, allowed is {low} to {high}"
            self.findings.add(kinds.VALUE_OUT_OF_RANGE, self.value_span(*steps), message)
            return default
        return value

    def text(self, key: str, default: str) -> str:
        """Return a text."""
        self.ask(key, Question(Sort.TEXT, default=default))
        if key not in self:
            return default
        value = self.values[key]
        if not isinstance(value, str):
            self.wrong_type((key,), value, "text in quotation marks")
            return default
        return value

    def flag(self, key: str, *, default: bool) -> bool:
        """Return true or false."""
        self.ask(key, Question(Sort.FLAG, default=default))
        if key not in self:
            return default
        value = self.values[key]
        if not isinstance(value, bool):
            self.wrong_type((key,), value, "`true` or `false`")
            return default
        return value

    def choice(self, key: str, allowed: Sequence[str], default: str, other: str = "") -> str:
        """Return one of the words `allowed`.

        Args:
            key: of the table.
            allowed: words.
            default: where the key is absent or wrong.
            other: hint where no allowed word is near.
        """
        value = self.text(key, default)
        self.ask(key, Question(Sort.TEXT, default=default, choices=tuple(allowed)))
        if value in allowed or not isinstance(self.values.get(key, value), str):
            return value
        words = ", ".join(f"`{word}`" for word in allowed)
        message = f"`{self.name_of(key)}` is `{cut(value)}`, allowed are {words}"
        close = near(value, allowed, limit=1)
        hint = f"did you mean `{close[0]}`?" if close else other
        self.findings.add(kinds.UNKNOWN_CHOICE, self.value_span(key), message, hint)
        return default

    def reference(self, key: str, known: Mapping[str, object], sort: str) -> str:
        """Return the name of a `sort` (such as `frame`) that must be a key of `known`; empty where absent."""
        name = self.text(key, "")
        self.ask(key, Question(Sort.TEXT, names=sort, likely=tuple(known)))
        if not name or name in known:
            return name
        close = near(name, known, limit=1)
        names = ", ".join(f"`{each}`" for each in sorted(known)[:12])
        hint = f"did you mean `{close[0]}`?" if close else f"{sort}s of this cell: {names or 'none'}"
        message = f"{sort} `{cut(name)}` is not defined in this cell"
        self.findings.add(kinds.UNKNOWN_CELL_NAME, self.value_span(key), message, hint)
        return ""

    def table(self, key: str) -> "TomlTable":
        """Return a section or inline table, or an empty stand-in."""
        self.ask(key, Question(Sort.SECTION))
        if key not in self:
            return TomlTable({}, (*self.path, key), self.findings, present=False)
        return self._table((key,), self.values[key], "a section")

    def tables(self, key: str) -> "tuple[TomlTable, ...]":
        """Return the tables of a `[[key]]` list."""
        self.ask(key, Question(Sort.SECTIONS))
        if key not in self:
            return ()
        value = self.values[key]
        if not isinstance(value, list):
            self.wrong_type((key,), value, f"a list of sections `[[{self.name_of(key)}]]`")
            return ()
        return tuple(self._table((key, k), item, "a section") for k, item in enumerate(value))

    def named(self, key: str) -> "Mapping[str, TomlTable]":
        """Return the tables `[key.<name>]` by names that programs can speak of."""
        table = self.table(key)
        self.ask(key, Question(Sort.NAMED))
        result = {}
        for name, value in table.values.items():
            table.asked[name] = None
            if _SPEAKABLE.fullmatch(name) is None:
                message = f"programs cannot speak of `{cut(name)}`"
                hint = "use letters, digits and `_`, a letter first"
                self.findings.add(kinds.UNSPEAKABLE_NAME, table.key_span(name), message, hint)
            result[name] = table._table((name,), value, f"a section `[{key}.{name}]`")
        return result

    def wrong_type(self, steps: tuple[str | int, ...], value: object, needed: str) -> None:
        """Note that the value at `steps` is of the wrong sort."""
        message = f"{self._name(steps)} is {sort_of(value)}, needed is {needed}"
        self.findings.add(kinds.WRONG_VALUE_TYPE, self.value_span(*steps), message)

    def _table(self, steps: tuple[str | int, ...], value: object, needed: str) -> "TomlTable":
        path = (*self.path, *steps)
        if isinstance(value, dict):
            return TomlTable(value, path, self.findings)
        self.wrong_type(steps, value, needed)
        return TomlTable({}, path, self.findings, present=False)

    def _name(self, steps: tuple[str | int, ...]) -> str:
        name = ".".join(part for part in (*self.path, *steps) if isinstance(part, str))
        indices = [step + 1 for step in steps if isinstance(step, int)]
        return "".join(f"item {index} of " for index in reversed(indices)) + f"`{cut(name)}`"
