"""A file for expressions of xacro that stand in none: it has two arguments and keeps messages."""

from ropsim.exchange.testing import Scope, Value, XacroError, value_of_text

MOST = 1_000_000
ARGUMENTS = {"side": "left", "count": "3"}


class LooseFile:
    """Services for expressions, with what they spent and reported."""

    def __init__(self) -> None:
        self.spent = 0
        self.messages: list[str] = []

    def evaluated(self, text: str, scope: Scope) -> Value:
        return value_of_text(text, scope)

    def loaded(self, path: str) -> Value:
        raise XacroError(f"`{path}` is not there")

    def argument(self, name: str) -> str:
        if name not in ARGUMENTS:
            raise XacroError(f"the argument `{name}` has no value")
        return ARGUMENTS[name]

    def has_argument(self, name: str) -> bool:
        return name in ARGUMENTS

    def directory(self) -> str:
        return "urdf"

    def report(self, text: str) -> None:
        self.messages.append(text)

    def spend(self, characters: int) -> None:
        self.spent += characters
        if self.spent > MOST:
            raise XacroError("the file becomes too much")
