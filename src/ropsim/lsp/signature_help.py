"""How the task is called whose arguments are being typed, and which of them it is."""

from collections.abc import Mapping

from ropsim.lsp import names
from ropsim.lsp.call_place import call_place
from ropsim.lsp.document import Document
from ropsim.lsp.messages import Json
from ropsim.lsp.programs import is_program
from ropsim.lsp.protocol import AtPosition
from ropsim.lsp.workshop import Workshop


def signature_help(
    document: Document, params: AtPosition, documents: Mapping[str, Document], workshop: Workshop
) -> Json | None:
    """Return how the task is called in whose arguments a place stands, None outside of calls."""
    if not is_program(document):
        return None
    lead = document.line(params.position.line)[: document.column(params.position)]
    place = call_place(lead, workshop.checked(document, documents).tasks)
    if place is None or not place.form.is_known:
        return None
    form = place.form
    signature: Json = {
        "label": str(form),
        "parameters": [{"label": str(one)} for one in form.parameters],
        "activeParameter": place.index,
    }
    notes = "\n".join(names.task_notes(workshop.outline(document), form.name))
    if notes:
        signature["documentation"] = {"kind": "plaintext", "value": notes}
    return {"signatures": [signature], "activeSignature": 0, "activeParameter": place.index}
