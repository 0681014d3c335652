"""Exceptions for wrong use of the ICR functions."""

from ropsim.core import Diagnostic, RopsimError


class AssemblyError(RopsimError):
    """A text is no ICR program; `diagnostics` says why, in the order of the text."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics[0])
        self.diagnostics = diagnostics


class UnverifiedError(RopsimError):
    """A program that the verifier refuses was to be run; `diagnostics` says why."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics[0])
        self.diagnostics = diagnostics
