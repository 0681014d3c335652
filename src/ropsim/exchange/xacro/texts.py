"""Texts of an expanded file: their values, the files that they name, limits of their cost."""

from ropsim.exchange.files.folder import ReadOptions
from ropsim.exchange.files.xml_tree import MOST_ELEMENTS, Element
from ropsim.exchange.losses.notes import shown
from ropsim.exchange.xacro.scope import Scope
from ropsim.exchange.xacro.substitution import text_of, value_of_text
from ropsim.exchange.xacro.values import Value, XacroError
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

    def __init__(self, options: ReadOptions) -> None:
        self._folder = options.folder
        self._given = options.arguments
        self._arguments: dict[str, str] = dict(options.arguments)
        self._files: dict[str, Value] = {}
        self._beside = [options.folder.beside]
        self._steps = self._made = self._characters = self._calls = 0

    def _step(self, depth: int) -> None:
        """Count an expanded element."""
        self._steps += 1
        if self._steps > MOST_STEPS or depth > MOST_DEPTH:
            raise XacroError("the file becomes too much, or too deep", "look for a macro that calls itself")

    def _spend(self, characters: int) -> None:
        """Count characters that are read or made."""
        self._characters += characters
        if self._characters > MOST_CHARACTERS:
            raise XacroError("the file becomes too much", "look for a macro that calls itself")

    def _make(self) -> None:
        """Count an element that is made."""
        self._made += 1
        if self._made > MOST_ELEMENTS:
            raise XacroError(f"the file becomes more than {MOST_ELEMENTS} elements", "cut it down")

    def _deeper(self) -> None:
        self._calls += 1
        if self._calls > MOST_CALLS:
            raise XacroError(
                f"macros and files are more than {MOST_CALLS} in each other", "look for a circle"
            )

    def _value(self, text: str, scope: Scope) -> Value:
        self._spend(len(text))
        return value_of_text(text, scope, self._arguments)

    def _text(self, text: str, scope: Scope) -> str:
        self._spend(len(text))
        return text_of(text, scope, self._arguments)

    def _need(self, one: Element, key: str, scope: Scope) -> str:
        if key not in one.attributes:
            raise XacroError(f"`{one.name}` has no `{key}`", f"write {key}=... into it")
        return self._text(one.attributes[key], scope)

    def _loaded(self, name: str) -> Value:
        if name not in self._files:
            self._files[name] = yaml_value(self._text_of_file(name)[1])
        return self._files[name]

    def _text_of_file(self, name: str) -> tuple[str, str]:
        """Return path and text of a file that is named in the one that is expanded."""
        path = self._folder.path(name, self._beside[-1])
        text = self._folder.text(path) if path else None
        if path is None or text is None:
            words = f"the file `{shown(name)}` is not there, or not inside of the given folders"
            raise XacroError(words, "give the folder of its package")
        self._spend(len(text) // 10)
        return path, text
