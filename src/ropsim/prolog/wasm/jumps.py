"""Long jumps: how a program of C leaves many calls at once, as emscripten compiles it.

A call that may be left so goes through an import `invoke_…`; jumping is an exception of WebAssembly, and the
import that catches it restores the stack and notifies the program, which then checks whether it is the
target. These imports are a separate module of WebAssembly: Prolog makes 1700 of these calls when it starts,
each of which would cost a tenth of a millisecond by way of Python.

The program is given the imports before it is there. So they call its functions through a table of their own,
into which a second module copies the functions of the program once it exists.
"""

from collections.abc import Iterable

from ropsim.prolog.program import CrashError

ASKED = "emscripten_asm_const_int"
"""The import by which the program calls its host: a jump goes on behind it where `LEFT` is answered."""
LEFT = -(1 << 31)
"""Answer of the host if the program has left the call of the host by a jump."""
THROWN = "thrown Wasm exception"
"""Message of a trap after a jump to a call that is not below."""

_MODULE = f"""\
(module
  (import "host" "asked" (func $asked (param i32 i32 i32) (result i32)))
  (tag $jump)
  (table $functions (export "functions") 0 funcref)
  (table $stack (export "stack") 3 funcref)
  (func (export "_emscripten_throw_longjmp") (throw $jump))
  (func (export "{ASKED}") (param i32 i32 i32) (result i32)
    (local $answer i32)
    (local.set $answer (call $asked (local.get 0) (local.get 1) (local.get 2)))
    (if (i32.eq (local.get $answer) (i32.const {LEFT})) (then (throw $jump)))
    (local.get $answer))
"""

_INVOKE = """\
  (func (export "{name}") (param i32 {takes}) {gives}
    (local $before i32)
    (local.set $before (call_indirect $stack (result i32) (i32.const 0)))
    (block $left
      (try_table (catch $jump $left)
        (return (call_indirect $functions (param {takes}) {gives} {values} (local.get 0)))))
    (call_indirect $stack (param i32) (local.get $before) (i32.const 1))
    (call_indirect $stack (param i32 i32) (i32.const 1) (i32.const 0) (i32.const 2))
    {failed})
"""

BRIDGE = """\
(module
  (import "program" "functions" (table $from 1 funcref))
  (import "jumps" "functions" (table $to 0 funcref))
  (import "jumps" "stack" (table $stack 3 funcref))
  (import "program" "emscripten_stack_get_current" (func $get (result i32)))
  (import "program" "_emscripten_stack_restore" (func $restore (param i32)))
  (import "program" "setThrew" (func $tell (param i32 i32)))
  (elem declare func $get $restore $tell)
  (func $join
    (drop (table.grow $to (ref.null func) (table.size $from)))
    (table.copy $to $from (i32.const 0) (i32.const 0) (table.size $from))
    (table.set $stack (i32.const 0) (ref.func $get))
    (table.set $stack (i32.const 1) (ref.func $restore))
    (table.set $stack (i32.const 2) (ref.func $tell)))
  (start $join))
"""
"""Lets the imports find the functions of the program, and the functions that restore its stack."""
BRIDGED = ("emscripten_stack_get_current", "_emscripten_stack_restore", "setThrew")
"""The functions of the program by their names in C that the bridge takes."""


class LongJumpError(Exception):
    """The program leaves the call of its host, and goes on at a call below it."""


def jumps(names: Iterable[str]) -> str:
    """Return the text of the module of imports such as `invoke_viii`, of jumping and of the call of the host.

    Args:
        names: of imports; a `v` behind the underline says that it has no result, each `i` is a number.

    Raises:
        CrashError: an import has other parameters or results.
    """
    return _MODULE + "".join(map(_invoke, names)) + ")\n"


def _invoke(name: str) -> str:
    gives, takes = name.removeprefix("invoke_")[:1], name.removeprefix("invoke_")[1:]
    if not gives or set(gives) - set("vi") or set(takes) - set("i"):
        raise CrashError(f"the program wants `{name}`, which nobody answers")
    return _INVOKE.format(
        name=name,
        takes=" ".join("i32" for _ in takes),
        gives="(result i32)" if gives == "i" else "",
        values=" ".join(f"(local.get {number})" for number in range(1, len(takes) + 1)),
        failed="(i32.const 0)" if gives == "i" else "",
    )
