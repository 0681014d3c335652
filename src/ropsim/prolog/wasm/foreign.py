"""The foreign interface of SWI-Prolog, as far as the engine needs it: predicates with texts in and out.

Source: the reference of the C interface in the manual of SWI-Prolog, section "Foreign Language Interface".
"""

from collections.abc import Generator, Iterator
from contextlib import contextmanager

from ropsim.prolog.program import MOST_BYTES, CrashError, TooLongError
from ropsim.prolog.wasm.instance import Instance

CATCH, STATUS = 0x08, 0x40
"""Of `PL_open_query`: errors are kept, and each answer says whether it is the last one."""
UTF8 = 0x100000
AS_TEXT = 0x3F | 0x200 | UTF8
"""Of `PL_get_nchars`: constants literally, other terms as `writeq/1` writes it."""
LAST = 2
"""The status of a solution behind which there is none."""


class Foreign:
    """Predicates, terms and texts of one instance."""

    def __init__(self, instance: Instance) -> None:
        self._instance = instance
        self._buffer = instance.call("malloc", 8)
        self._predicates: dict[tuple[str, int, str], int] = {}

    def initialise(self, arguments: tuple[str, ...]) -> None:
        """Start Prolog.

        Raises:
            CrashError: it does not start.
        """
        texts = [self._copied(text) for text in arguments]
        vector = self._instance.call("malloc", 4 * (len(texts) + 1))
        self._instance.memory.pack(vector, f"<{len(texts) + 1}I", *texts, 0)
        if not self._instance.call("PL_initialise", len(texts), vector):
            raise CrashError("SWI-Prolog does not start")

    def text(self, term: int) -> str:
        """Return the text of a term; of a string or an atom its characters.

        Raises:
            TooLongError: the text is longer than allowed.
        """
        if not self._instance.call("PL_get_nchars", term, self._buffer + 4, self._buffer, AS_TEXT):
            raise CrashError("a term has no text")
        address, length = self._instance.memory.unpack(self._buffer, "<II")
        if length > MOST_BYTES:
            raise TooLongError(f"a text of {length} bytes; at most {MOST_BYTES} are taken")
        return self._instance.memory.read(address, length).decode(errors="replace")

    def put(self, term: int, text: str) -> None:
        """Let a reference be the term of a canonical text."""
        copy = self._copied(text)
        done = self._instance.call("PL_put_term_from_chars", term, UTF8, -1, copy)
        self._instance.call("free", copy)
        if not done:
            raise CrashError("a text that it was given cannot be read")

    def unify(self, term: int, text: str) -> int:
        """Unify a term with that of a canonical text; return whether it went well."""
        made = self._instance.call("PL_new_term_refs", 1)
        self.put(made, text)
        return self._instance.call("PL_unify", term, made)

    def replies(self, name: str, module: str, request: str) -> Generator[tuple[str, bool]]:
        """Call `Module:Name(Request, Reply)`; yield the text of each reply, and whether it is the last.

        Closing the iterator cuts the query. Queries end in the reverse order in which they began.
        """
        call = self._instance.call
        with self._frame():
            terms = call("PL_new_term_refs", 2)
            self.put(terms, request)
            query = call("PL_open_query", 0, CATCH | STATUS, self._predicate(name, 2, module), terms)
            try:
                while (status := call("PL_next_solution", query)) > 0:
                    yield self.text(terms + 1), status == LAST
                    if status == LAST:
                        return
                if status < 0:
                    yield f"uncaught({self._ball(query)})", True
            finally:
                if not self._instance.has_ended:
                    call("PL_cut_query", query)

    def _ball(self, query: int) -> str:
        """Return the uncaught thrown term, as a string of a canonical text."""
        thrown = self.text(self._instance.call("PL_exception", query))[:500]
        return '"' + thrown.replace("\\", "\\\\").replace('"', '\\"') + '"'

    @contextmanager
    def _frame(self) -> Iterator[None]:
        """Release all references made inside the block; a program that has crashed has no references."""
        frame = self._instance.call("PL_open_foreign_frame")
        try:
            yield
        finally:
            if not self._instance.has_ended:
                self._instance.call("PL_discard_foreign_frame", frame)

    def _predicate(self, name: str, arity: int, module: str) -> int:
        key = (name, arity, module)
        if key not in self._predicates:
            texts = self._copied(name), self._copied(module)
            self._predicates[key] = self._instance.call("PL_predicate", texts[0], arity, texts[1])
        return self._predicates[key]

    def _copied(self, text: str) -> int:
        """Return the address of a copy of a text in the memory of the program."""
        content = text.encode(errors="replace") + b"\0"
        address = self._instance.call("malloc", len(content))
        if not address:
            raise CrashError("no memory for a text")
        self._instance.memory.write(address, content)
        return address
