"""Parameters of the supported methods; names as in the protocol, unknown members are ignored."""

import msgspec

#: Numbers of the protocol are `uinteger`.
LARGEST = 2**31 - 1


class Position(msgspec.Struct, frozen=True):
    """A place in a text: line and unit on it, both from 0."""

    line: int
    character: int

    def __post_init__(self) -> None:
        if not (0 <= self.line <= LARGEST and 0 <= self.character <= LARGEST):
            raise ValueError("line and character must be from 0 to 2147483647")


class Range(msgspec.Struct, frozen=True):
    """A range of a text; `end` is exclusive."""

    start: Position
    end: Position


class TextDocumentItem(msgspec.Struct, frozen=True, rename="camel"):
    """A document at its opening."""

    uri: str
    text: str
    version: int = 0
    language_id: str = ""


class VersionedDocument(msgspec.Struct, frozen=True):
    """A document in a change or request."""

    uri: str
    version: int | None = None


class ContentChange(msgspec.Struct, frozen=True):
    """New text of a range, or of the whole document."""

    text: str
    range: Range | None = None


class DidOpen(msgspec.Struct, frozen=True, rename="camel"):
    """`textDocument/didOpen`."""

    text_document: TextDocumentItem


class DidChange(msgspec.Struct, frozen=True, rename="camel"):
    """`textDocument/didChange`."""

    text_document: VersionedDocument
    content_changes: list[ContentChange]


class OfDocument(msgspec.Struct, frozen=True, rename="camel"):
    """Methods about a whole document."""

    text_document: VersionedDocument


class AtPosition(msgspec.Struct, frozen=True, rename="camel"):
    """Methods about a place."""

    text_document: VersionedDocument
    position: Position


class CompletionContext(msgspec.Struct, frozen=True, rename="camel"):
    """Reason of a completion request."""

    trigger_character: str | None = None


class CompletionAt(AtPosition, frozen=True, rename="camel"):
    """A place at which something can be completed."""

    context: CompletionContext | None = None


class InRange(msgspec.Struct, frozen=True, rename="camel"):
    """Methods about a range of lines."""

    text_document: VersionedDocument
    range: Range


class ReferenceContext(msgspec.Struct, frozen=True, rename="camel"):
    """Requested places in addition to the uses."""

    include_declaration: bool = True


class ReferencesAt(AtPosition, frozen=True, rename="camel"):
    """`textDocument/references`."""

    context: ReferenceContext | None = None


class RenameAt(AtPosition, frozen=True, rename="camel"):
    """`textDocument/rename`."""

    new_name: str


class SymbolQuery(msgspec.Struct, frozen=True):
    """`workspace/symbol`."""

    query: str = ""


class ActionContext(msgspec.Struct, frozen=True):
    """Requested kinds of actions; None for all."""

    only: list[str] | None = None


class ActionsIn(InRange, frozen=True, rename="camel"):
    """`textDocument/codeAction`."""

    context: ActionContext | None = None


class FindingsSince(OfDocument, frozen=True, rename="camel"):
    """`textDocument/diagnostic`."""

    previous_result_id: str | None = None


class TokensSince(OfDocument, frozen=True, rename="camel"):
    """`textDocument/semanticTokens/full/delta`."""

    previous_result_id: str


class Anything(msgspec.Struct, frozen=True):
    """Methods whose parameters do not matter."""
