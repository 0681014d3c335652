"""A first call of a user's law, in plain Python, before the real ones."""

import re
from collections.abc import Mapping
from pathlib import Path
from traceback import extract_tb

import numpy as np

from ropsim.controller.law import CompiledLaw, PythonLaw
from ropsim.controller.law_code import ARGUMENTS, in_python, law_arrays, law_code
from ropsim.controller.law_diagnostics import LAW_FAILS, LawError
from ropsim.spatial import Array

_COMPILING = "Failed in nopython mode"
"""What numba says first, whatever it is that it cannot compile."""


def rehearse(law: CompiledLaw, n: int) -> None:
    """Make sure that a law can be called: at rest, on its reference, without payload.

    Args:
        law: the law.
        n: joints of the arm.

    Raises:
        LawError: C601, it is no Python, has another name, raises, indexes beyond its arrays, or returns NaN.
    """
    code = law_code(law)
    if code.unknown:
        known = ", ".join(ARGUMENTS)
        raise _fails(law, f"`law` has an argument `{code.unknown[0]}`; allowed are {known}")
    if "out" not in code.arguments:
        raise _fails(law, "`law` has no argument `out`, which takes the input of the amplifiers")
    try:
        function = in_python(law)
    except KeyError:
        raise _fails(law, "its source defines no function `law`") from None
    except Exception as error:  # any exception of a user's source is reported
        raise _fails(law, f"its source is no Python: {_description(law.source, error)}") from error
    arrays = law_arrays(law, n)
    try:
        with np.errstate(all="ignore"):
            function(arrays)
    except Exception as error:  # any exception of a user's source is reported
        raise _fails(law, f"at rest it stops with {_description(law.source, error)}") from error
    out = arrays["out"]
    if not np.isfinite(out).all():
        raise _fails(law, f"at rest it puts out `{out.tolist()}`; every number must be finite")


def failed(law: CompiledLaw, error: Exception) -> LawError:
    """Return the error of a law that stopped while it ran, or that cannot be compiled."""
    return _fails(law, _description(law.source, error))


def stopped(law: CompiledLaw, error: Exception, arrays: Mapping[str, Array]) -> LawError:
    """Return the error of a compiled law that stopped, with the line at which it stops in plain Python.

    Args:
        law: the law.
        error: of the compiled code, which names no line.
        arrays: arguments of the law when it stopped; changed in place.
    """
    try:
        with np.errstate(all="ignore"):
            in_python(law)(arrays)
    except Exception as found:  # any exception of a user's source is reported
        return failed(law, found)
    return failed(law, error)


def step_failed(law: PythonLaw, error: Exception, time: float) -> LawError:
    """Return the error of a law in Python whose `step` raised an exception at a time [s]."""
    message = f"law `{type(law).__name__}` fails at t = {time:.6g} s: {_description('', error)}"
    hint = "`step(now, state)` returns an input for each amplifier; see docs/how-to/own-controller.md"
    return LawError(LAW_FAILS.at(None, message, hint=hint, data={"time_s": time}))


def _fails(law: CompiledLaw, found: str) -> LawError:
    hint = "`law(par, state, ref, meas, load, aux, out)`, or some by name; see docs/how-to/own-controller.md"
    return LawError(LAW_FAILS.at(None, f"law `{law.name}` fails: {found}", hint=hint))


def _description(text_of_law: str, error: Exception) -> str:
    """Return the kind of an error, what it says first, and the line of the law where it was raised."""
    text = str(error)
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    said = [line for line in lines if not line.startswith(_COMPILING)] or lines
    description = f"{type(error).__name__}: {said[0]}" if said else type(error).__name__
    line = _line_of(error, text)
    source = text_of_law.splitlines()
    if line is not None and 0 < line <= len(source):
        return f"{description} (line {line}, `{source[line - 1].strip()}`)"
    frames = extract_tb(error.__traceback__)
    if not frames:
        return description
    return f"{description} ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"


def _line_of(error: Exception, text: str) -> int | None:
    """Return the line of the law at which an error was raised, or that a compiler names."""
    named = re.findall(r"<(?:generated law|law [^>]*)>(?: \(|\", line )(\d+)", text)
    if named:
        return int(named[-1])
    if isinstance(error, SyntaxError):
        return error.lineno
    lines = [one.lineno for one in extract_tb(error.__traceback__) if one.filename.startswith("<law ")]
    return lines[-1] if lines else None
