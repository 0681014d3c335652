"""Python functions as source functions of generated modules."""

import ast
from collections.abc import Callable
from inspect import getsource

from ropsim.codegen.formulas.emit import SourceFunction


def source_function(function: Callable[..., object], returns: str = "void", **types: str) -> SourceFunction:
    """Return a function with its source text.

    Args:
        function: of a module, that uses no other global names than `math`, `np` and functions before it.
        returns: type of what it returns, as numba writes it.
        types: of its arguments; one without a type is a vector.
    """
    module = ast.parse(getsource(function))
    (definition,) = module.body
    assert isinstance(definition, ast.FunctionDef)
    definition.returns = None
    for argument in definition.args.args:
        argument.annotation = None
    names = [argument.arg for argument in definition.args.args]
    words = ", ".join(types.get(name, "f8[::1]") for name in names)
    return SourceFunction(function.__name__, f"{returns}({words})", ast.unparse(module))
