"""Texts of an expanded file: their values, the files that they name, limits of their cost."""

from collections.abc import Iterator
from contextlib import contextmanager

from ropsim.core import near
from ropsim.exchange.files.folder import ReadOptions
from ropsim.exchange.files.xml_tree import MOST_ELEMENTS, Element
from ropsim.exchange.losses.diagnostics import XACRO_MESSAGE
from ropsim.exchange.losses.gathered import listed, shown
from ropsim.exchange.losses.notes import Notes
from ropsim.exchange.xacro.formulas.values import Value, XacroError
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.substitution import text_of, value_of_text
from ropsim.exchange.xacro.yaml_values import yaml_value

MOST_CALLS = 40
"""Macros and included files in each other."""
MOST_DEPTH = 100
"""Elements in each other, including the macros that they call."""
MOST_CHARACTERS = 1_000_000
"""Characters of all texts that are read or made."""
MOST_STEPS = 5 * MOST_ELEMENTS
"""Elements that are expanded, repeatedly as macros are called."""


class Texts:
    """Texts of one expansion, with its arguments and the folder of the file that is read now."""

    def __init__(self, options: ReadOptions, notes: Notes) -> None:
        self._folder = options.folder
        self._notes = notes
        self._given = tuple(options.arguments)
        self._arguments: dict[str, str] = dict(options.arguments)
        self._asked: set[str] = set()
        self._files: dict[tuple[str, str], Value] = {}
        self._beside = [options.folder.beside]
        self._messages: dict[str, None] = {}
        self._element: Element | None = None
        self._steps = self._made = self._characters = self._calls = 0

    def evaluated(self, text: str, scope: Scope) -> Value:
        """Return the value of a text with substitutions in it.

        Raises:
            XacroError: something in it cannot be evaluated.
        """
        self.spend(len(text))
        return value_of_text(text, scope)

    def argument(self, name: str) -> str:
        """Return an argument of the file.

        Raises:
            XacroError: it has no value.
        """
        self._asked.add(name)
        if name not in self._arguments:
            hint = f"give it: `--arg {name[:60]}=VALUE`"
            raise XacroError(f"the argument `{name[:60]}` has no value", hint)
        return self._arguments[name]

    def has_argument(self, name: str) -> bool:
        """Return whether an argument has a value."""
        return name in self._arguments

    def loaded(self, path: str) -> Value:
        """Return the value of a parameter file.

        Raises:
            XacroError: it cannot be read.
        """
        key = (path, self._beside[-1])
        if key not in self._files:
            self._files[key] = yaml_value(self._text_of_file(path)[1])
        return self._files[key]

    def directory(self) -> str:
        """Return the folder of the file that is read now."""
        root, beside = self._folder.root, self._beside[-1]
        if root is None:
            return beside or "."
        return (root.absolute() / beside).as_posix()

    def report(self, text: str) -> None:
        """Note a message of the file itself, once."""
        if text not in self._messages:
            self._messages[text] = None
            span = self._element.span if self._element else None
            self._notes.add(XACRO_MESSAGE, span, f"the file says: {text}", "see the file for what it wants")

    def spend(self, characters: int) -> None:
        """Count characters that are read or made.

        Raises:
            XacroError: there are too many.
        """
        self._characters += characters
        if self._characters > MOST_CHARACTERS:
            raise XacroError("the file becomes too much", "look for a macro that calls itself")

    def _step(self, depth: int, one: Element) -> None:
        """Count an expanded element."""
        self._element = one
        self._steps += 1
        if self._steps > MOST_STEPS or depth > MOST_DEPTH:
            raise XacroError("the file becomes too much, or too deep", "look for a macro that calls itself")

    def _make(self) -> None:
        """Count an element that is made."""
        self._made += 1
        if self._made > MOST_ELEMENTS:
            raise XacroError(f"the file becomes more than {MOST_ELEMENTS} elements", "cut it down")

    @contextmanager
    def _deeper(self) -> Iterator[None]:
        """Go into a macro or an included file."""
        self._calls += 1
        if self._calls > MOST_CALLS:
            raise XacroError(
                f"macros and files are more than {MOST_CALLS} in each other", "look for a circle"
            )
        yield
        self._calls -= 1

    def _text(self, text: str, scope: Scope) -> str:
        self.spend(len(text))
        return text_of(text, scope)

    def _need(self, one: Element, key: str, scope: Scope) -> str:
        if key not in one.attributes:
            raise XacroError(f"`{one.name}` has no `{key}`", f"write {key}=... into it")
        return self._text(one.attributes[key], scope)

    def _absent(self, name: str, path: str | None) -> XacroError:
        """Return the error of a file that is not there: its package is not, or an argument made its name."""
        if path is None:
            why, hint = self._folder.absence(name)
            return XacroError(f"the file `{shown(name)}` is {why}", hint)
        for one in self._given:  # others may be arguments of the rest of the file
            close = near(one, self._asked, limit=1) if one not in self._asked else ()
            if close:
                hint = f"the file has no argument `{shown(one)}`, did you mean `{close[0]}`?"
                return XacroError(f"the file `{shown(name)}` is not there", hint)
        values = listed(f"{one}={value}" for one, value in self._arguments.items())
        hint = f"does an argument need another value? They are {values}: `--arg NAME=VALUE`" if values else ""
        return XacroError(f"the file `{shown(name)}` is not there", hint or "look at its name")

    def _text_of_file(self, name: str) -> tuple[str, str]:
        """Return path and text of a file that is named in the one that is expanded."""
        path = self._folder.path(name, self._beside[-1])
        text = self._folder.text(path) if path else None
        if path is None or text is None:
            raise self._absent(name, path)
        self.spend(len(text) // 10)
        return path, text
