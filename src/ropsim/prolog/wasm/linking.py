"""The program of SWI-Prolog with its imports: imports that Python answers, and imports for jumps."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from ropsim.prolog.program import CrashError
from ropsim.prolog.wasm.artefact import Artefact
from ropsim.prolog.wasm.configuration import SETTINGS
from ropsim.prolog.wasm.jumps import ASKED, BRIDGE, BRIDGED, jumps
from ropsim.prolog.wasm.module_cache import compiled

if TYPE_CHECKING:
    from wasmtime import Engine, Store

Answer = Callable[..., float | int | None]
"""A function of the host that the program imports."""


def linked(
    engine: "Engine", store: "Store", artefact: Artefact, answers: Mapping[str, Answer]
) -> Mapping[str, object]:
    """Return the exports of a program, by its short names, ready to be started.

    Args:
        engine: compiles and runs it, with exceptions of WebAssembly.
        store: the state of the program.
        artefact: its code and names.
        answers: functions by the names of their imports.

    Raises:
        CrashError: it requires an unknown import.
    """
    from wasmtime import FuncType, Linker, Module, Table, ValType

    module, linker, i32 = compiled(engine, SETTINGS, artefact.code), Linker(engine), ValType.i32()
    invoked = [name for name in artefact.imports.values() if name.startswith("invoke_")]
    linker.define_func("host", "asked", FuncType([i32, i32, i32], [i32]), answers[ASKED])
    caught = linker.instantiate(store, Module(engine, jumps(invoked))).exports(store)
    for one in module.imports:
        short = one.name or ""
        name = artefact.imports[short]
        if name in caught:
            linker.define(store, one.module, short, caught[name])
        elif name in answers and isinstance(one.type, FuncType):
            linker.define_func(one.module, short, one.type, answers[name])
        else:
            raise CrashError(f"the program wants `{name}`, which nobody answers")
    exports = linker.instantiate(store, module).exports(store)
    functions = next(one for one in exports.values() if isinstance(one, Table))
    linker.define(store, "program", "functions", functions)
    for name in BRIDGED:
        linker.define(store, "program", name, exports[artefact.exports[name]])
    for name in ("functions", "stack"):
        linker.define(store, "jumps", name, caught[name])
    linker.instantiate(store, Module(engine, BRIDGE))
    return exports
