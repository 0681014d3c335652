"""Names that an expression can use: values by name, and services of the file that contains it."""

from typing import Protocol

from ropsim.exchange.xacro.formulas.values import Value


class FileOfNames(Protocol):
    """Services of the file that is expanded for its expressions."""

    def loaded(self, path: str) -> Value:
        """Return the value of a parameter file.

        Raises:
            XacroError: it cannot be read.
        """
        ...

    def argument(self, name: str) -> str:
        """Return an argument of the file.

        Raises:
            XacroError: it has no value.
        """
        ...

    def directory(self) -> str:
        """Return the folder of the file that is read."""
        ...

    def report(self, text: str) -> None:
        """Note a message of the file itself."""
        ...

    def spend(self, characters: int) -> None:
        """Count characters that are read or made.

        Raises:
            XacroError: there are too many.
        """
        ...


class Names(Protocol):
    """Values by name, and the file of the expression."""

    @property
    def file(self) -> FileOfNames:
        """Return the file of the expression."""
        ...

    def value(self, name: str) -> Value:
        """Return the value of a name.

        Raises:
            XacroError: it is undefined.
        """
        ...
