"""The program of SWI-Prolog as it runs: imports answered, functions called by their names in C."""

from collections.abc import Callable
from typing import TYPE_CHECKING, cast

from ropsim.core import frozen_without_equality
from ropsim.prolog.program import CrashError, StoppedError
from ropsim.prolog.wasm.artefact import Artefact
from ropsim.prolog.wasm.clock_calls import ClockCalls
from ropsim.prolog.wasm.configuration import configuration
from ropsim.prolog.wasm.file_calls import FileCalls
from ropsim.prolog.wasm.files import MemoryFiles
from ropsim.prolog.wasm.image import Image
from ropsim.prolog.wasm.jumps import ASKED, LEFT, THROWN, LongJumpError
from ropsim.prolog.wasm.linking import linked
from ropsim.prolog.wasm.memory import PAGE, LinearMemory, NoAddressError, memory_needed
from ropsim.prolog.wasm.stream_calls import StreamCalls

if TYPE_CHECKING:
    from wasmtime import Func

ENVIRONMENT = ("HOME=/kb", "PATH=/", "LANG=C.UTF-8", "USER=ropsim", "SWI_HOME_DIR=swipl")
FOREVER = 1 << 40
"""Number of epochs that no call reaches."""
FEWEST_BYTES = 64 << 20
"""Below this Prolog does not start."""


@frozen_without_equality
class Host:
    """Services for a program.

    Attributes:
        memory_bytes: the most memory that it may have.
        on_call: answers `'$js_call'(Request, Reply)`: it is given two references to terms and returns whether
            the reply was unified.
    """

    memory_bytes: int
    on_call: Callable[[int, int], int]


class Instance:
    """One program with memory and files of its own; it belongs to one thread, except for `stop`."""

    def __init__(self, artefact: Artefact, host: Host) -> None:
        from wasmtime import Engine, Memory, Store

        self._artefact = artefact
        self._host = host
        self.has_ended = False
        self.files = MemoryFiles(artefact.library)
        self._streams = StreamCalls(self.files)
        self._file_calls = file_calls = FileCalls(self._streams)
        self._clock = clock_calls = ClockCalls()
        self._held: frozenset[int] = frozenset()
        # An engine of its own: its epoch stops this program and no other.
        self._engine: Engine = Engine(configuration())
        self._store = Store(self._engine)
        self._store.set_limits(memory_size=max(host.memory_bytes, FEWEST_BYTES))
        self._store.set_epoch_deadline(FOREVER)
        tables = (self._streams.table(), file_calls.table(), clock_calls.table(), self._table())
        answers = dict(item for table in tables for item in table.items())
        with memory_needed():
            exports = linked(self._engine, self._store, artefact, answers)
        self._exports = {name: cast("Func", exports[short]) for name, short in artefact.exports.items()}
        memory = next(one for one in exports.values() if isinstance(one, Memory))
        self.memory = LinearMemory(memory, self._store)
        self._streams.memory = file_calls.memory = clock_calls.memory = self.memory
        cast("Func", exports[artefact.start])(self._store)

    def call(self, name: str, *arguments: int) -> int:
        """Call a function of C.

        Raises:
            StoppedError: it was stopped.
            LongJumpError: it jumps to a call that is below that of the host.
            CrashError: the program has ended, by a trap or by exit.
        """
        from wasmtime import Trap, TrapCode, WasmtimeError

        if self.has_ended:
            raise CrashError("the program has ended")
        try:
            return cast("int", self._exports[name](self._store, *arguments))
        except LongJumpError:
            raise
        except Trap as trap:
            if trap.message.rstrip().endswith(THROWN):
                raise LongJumpError from None
            self.has_ended = True
            if trap.trap_code is TrapCode.INTERRUPT:
                raise StoppedError("stopped") from trap
            raise CrashError(trap.message.splitlines()[-1]) from trap
        except (WasmtimeError, NoAddressError) as error:
            self.has_ended = True
            raise CrashError(str(error)) from error
        except BaseException:  # it was left in the middle
            self.has_ended = True
            raise

    def limit(self) -> None:
        """Let the next `stop` end anything that runs from now on."""
        self._store.set_epoch_deadline(1)

    def stop(self) -> None:
        """End the present work of the program; any thread may call this."""
        self._engine.increment_epoch()

    def printed(self) -> str:
        """Return the output of the program since the last call."""
        text = self._streams.printed.decode(errors="replace")
        self._streams.printed.clear()
        return text

    def hold(self) -> None:
        """Remember which pages hold something before the first call: an image describes all of them."""
        self._held = frozenset(self.memory.used_pages())

    def image(self) -> Image:
        """Return the image of the program between two calls; `hold` was called before the first of them."""
        numbers = self._held | frozenset(self.memory.used_pages())
        pages = {number: self.memory.read(PAGE * number, PAGE) for number in numbers}
        elapsed_ns, folder, opened = self._clock.elapsed_ns, self._file_calls.folder, self._streams.state()
        return Image(self.memory.size, pages, elapsed_ns, folder, opened)

    def go_on_from(self, image: Image) -> bool:
        """Go on from an image instead of the beginning; return whether there is room for its memory."""
        if not self.memory.grow(image.size):
            return False
        for number, content in image.pages.items():
            self.memory.write(PAGE * number, content)
        self._clock.elapsed_ns = image.elapsed_ns
        self._file_calls.folder = image.folder
        self._streams.go_on_from(image.opened)
        self._held = frozenset(image.pages)
        return True

    def _table(self) -> dict[str, Callable[..., int | None]]:
        """Return the functions about the program itself by the names of their imports."""
        return {
            ASKED: self._constant,
            "emscripten_asm_const_ptr": lambda *_: 0,
            "emscripten_get_heap_max": lambda: self._host.memory_bytes,
            "emscripten_resize_heap": lambda size: int(self.memory.grow(size & 0xFFFFFFFF)),
            "emscripten_run_script": lambda _script: None,
            "_munmap_js": lambda *_: 0,
            "_abort_js": lambda: _ended("abort"),
            "exit": lambda code: _ended(f"exit with {code}"),
            "environ_sizes_get": self._environment_sizes,
            "environ_get": self._environment,
        }

    def _constant(self, code: int, _signature: int, arguments: int) -> int:
        """Answer a piece of script in the program; the call of the host is the only one that matters here."""
        if code != self._artefact.call_code:
            return 0
        request, reply = self.memory.unpack(arguments, "<II")
        try:
            return self._host.on_call(request, reply)
        except LongJumpError:
            return LEFT

    def _environment_sizes(self, count: int, size: int) -> int:
        self.memory.pack(count, "<I", len(ENVIRONMENT))
        self.memory.pack(size, "<I", sum(len(one) + 1 for one in ENVIRONMENT))
        return 0

    def _environment(self, addresses: int, texts: int) -> int:
        for one in ENVIRONMENT:
            self.memory.pack(addresses, "<I", texts)
            self.memory.write(texts, one.encode() + b"\0")
            addresses, texts = addresses + 4, texts + len(one) + 1
        return 0


def _ended(how: str) -> None:
    raise CrashError(f"the program has ended itself: {how}")
