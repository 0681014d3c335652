"""Findings of a document for an editor that requests them."""

from collections.abc import Mapping
from hashlib import sha256

import msgspec

from ropsim.lsp.analysis.workshop import Workshop
from ropsim.lsp.changes import findings
from ropsim.lsp.protocol.document import Document
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import FindingsSince


def findings_of(document: Document, documents: Mapping[str, Document], workshop: Workshop) -> list[Json]:
    """Return the findings of a document in the protocol's form."""
    return [findings.diagnostic(one, document) for one in workshop.findings(document, documents)]


def pulled(
    document: Document, params: FindingsSince, documents: Mapping[str, Document], workshop: Workshop
) -> Json:
    """Return the findings with a name that depends on them alone, or that name where the editor has them."""
    items = findings_of(document, documents, workshop)
    name = sha256(msgspec.json.encode(items)).hexdigest()[:16]
    if name == params.previous_result_id:
        return {"kind": "unchanged", "resultId": name}
    return {"kind": "full", "resultId": name, "items": items}
