"""Whether a changed text has the same behaviour: the same code, or the same instructions in a dry run."""

from dataclasses import fields, replace

from ropsim import icr, language
from ropsim.flow import Instruction, Origin
from ropsim.lsp.analysis.workshop import Surroundings, Workshop
from ropsim.lsp.protocol.document import Document
from ropsim.query import is_same
from ropsim.workbench import program_arm

#: ICR instructions after which the comparison of two dry runs ends.
BUDGET = 100_000


def has_same_code(document: Document, after: str, around: Surroundings, workshop: Workshop) -> bool:
    """Return whether a document and another text compile to the same code; line numbers may differ."""
    old, new = _codes(document, after, around, workshop)
    return old is not None and new is not None and old == new and is_same(_steps(old), _steps(new))


def does_the_same(document: Document, after: str, around: Surroundings, workshop: Workshop) -> bool:
    """Return whether dry runs of both return the same instructions."""
    old, new = _codes(document, after, around, workshop)
    if old is None or new is None:
        return False
    return _handed_out(old, around, workshop) == _handed_out(new, around, workshop)


def _codes(
    document: Document, after: str, around: Surroundings, workshop: Workshop
) -> tuple[icr.Program | None, icr.Program | None]:
    """Return the code of both, of which most is known: the document last, to which its next edit is near."""
    new, old = (
        language.compile(text, around.environment, document.name, workshop.lines).icr
        for text in (after, document.text)
    )
    return old, new


def _steps(code: icr.Program) -> tuple[tuple[icr.Step, ...], ...]:
    return tuple(one.code for one in code.procedures)


def _handed_out(code: icr.Program, around: Surroundings, workshop: Workshop) -> list[Instruction]:
    arm = program_arm(code, around.cell, around.station)
    run = icr.run_verified(code, workshop.attention.world(arm=arm), BUDGET)
    return [_without_origin(one) for one in run.instructions]


def _without_origin(one: Instruction) -> Instruction:
    return replace(one, origin=Origin()) if any(part.name == "origin" for part in fields(one)) else one
