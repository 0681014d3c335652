"""A first call of a user's law, in plain Python, before the real ones."""

from pathlib import Path
from traceback import extract_tb

import numpy as np

from ropsim.controller.law import CompiledLaw
from ropsim.controller.law_code import ARGUMENTS, in_python, law_arrays, law_code
from ropsim.controller.law_diagnostics import LAW_FAILS, LawError


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
        raise _fails(law, f"its source is no Python: {_description(error)}") from error
    arrays = law_arrays(law, n)
    try:
        with np.errstate(all="ignore"):
            function(arrays)
    except Exception as error:  # any exception of a user's source is reported
        raise _fails(law, f"at rest it stops with {_description(error)}") from error
    out = arrays["out"]
    if not np.isfinite(out).all():
        raise _fails(law, f"at rest it puts out `{out.tolist()}`; every number must be finite")


def failed(law: CompiledLaw, error: Exception) -> LawError:
    """Return the error of a law that stopped while it ran, or that cannot be compiled."""
    return _fails(law, _description(error))


def _fails(law: CompiledLaw, found: str) -> LawError:
    hint = "`law(par, state, ref, meas, load, aux, out)`, or some by name; see docs/how-to/own-controller.md"
    return LawError(LAW_FAILS.at(None, f"law `{law.name}` fails: {found}", hint=hint))


def _description(error: Exception) -> str:
    """Return the kind of an error, its first line with words, and where it was raised."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    description = f"{type(error).__name__}: {lines[0]}" if lines else type(error).__name__
    frames = extract_tb(error.__traceback__)
    return (
        f"{description} ({Path(frames[-1].filename).name}, line {frames[-1].lineno})"
        if frames
        else description
    )
