"""`ropsim explain`: the page of a diagnostic code."""

import argparse

from ropsim.cli.catalogue import all_kinds
from ropsim.cli.retired import RETIRED
from ropsim.cli.terminal.output import Output
from ropsim.core import Category, RopsimError, Severity, define, did_you_mean

NO_SUCH_CODE = define(
    "U900",
    "no-such-code",
    Severity.ERROR,
    "a diagnostic code that does not exist",
    "`ropsim explain` without a code lists all codes.",
    Category.USAGE,
)


class UnknownCodeError(RopsimError):
    """The requested code is not in the catalogue."""


def explain(options: argparse.Namespace, output: Output) -> int:
    """Print one page, or the list of all codes."""
    kinds = all_kinds()
    if options.code is None:
        width = max(len(kind.slug) for kind in kinds.values())
        rows = (
            f"{kind.code}  {kind.severity.value:7} {kind.slug:{width}}  {kind.summary}"
            for kind in kinds.values()
        )
        output.text("\n".join(rows))
        output.document({"codes": {code: kind.summary for code, kind in kinds.items()}})
        return 0
    code = options.code.upper()
    if code in RETIRED:
        return _retired(code, output)
    kind = kinds.get(code)
    if kind is None:
        hint = did_you_mean(options.code, kinds) or "`ropsim explain` lists all codes"
        raise UnknownCodeError(NO_SUCH_CODE.at(None, f"there is no diagnostic `{options.code}`", hint=hint))
    output.text(f"{kind.severity.value}[{kind.code}] {kind.slug}: {kind.summary}\n\n{kind.explanation}")
    output.document(
        {
            "code": kind.code,
            "slug": kind.slug,
            "severity": kind.severity.value,
            "summary": kind.summary,
            "explanation": kind.explanation,
        }
    )
    return 0


def _retired(code: str, output: Output) -> int:
    """Print what a code of earlier versions meant."""
    one = RETIRED[code]
    explanation = f"No finding has this code any more, and it is never used again. {one.now}"
    output.text(f"retired[{code}] {one.slug}: {one.meaning}\n\n{explanation}")
    output.document(
        {
            "code": code,
            "slug": one.slug,
            "severity": "retired",
            "summary": one.meaning,
            "explanation": explanation,
        }
    )
    return 0
