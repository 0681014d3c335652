"""The base of all exceptions that ropsim raises for wrong use of its Python API."""

from ropsim.core.diagnostic import Diagnostic


class RopsimError(Exception):
    """Wrong use of the API; carries the diagnostic that says what was wrong.

    Mistakes in programs, cells and models are diagnostics (values), not exceptions.
    """

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(str(diagnostic) + (f" ({diagnostic.hint})" if diagnostic.hint else ""))
        self.diagnostic = diagnostic
