"""The law of a file of the project: a block diagram, or a module in Python."""

from functools import lru_cache
from typing import cast

import numpy as np

from ropsim.blockdiagram import DOES_NOT_FIT, DiagramError, read_diagram
from ropsim.controller.diagrams.diagram_law import diagram_law
from ropsim.controller.law import CompiledLaw, PythonLaw
from ropsim.controller.law_diagnostics import (
    GAINS_OF_ANOTHER_LAW,
    GainError,
)
from ropsim.controller.own_modules.module_diagnostics import JOINT_CONTROLLER, MODULE_FAILS, ModuleError
from ropsim.controller.own_modules.own_module import made_by_module, syntax_finding
from ropsim.core import Diagnostic, RopsimError, SourceText
from ropsim.model import ControllerFile, ControllerModel, Mechanism

_ROUNDING = 1e-9
"""Difference of two periods over one of them that does not count."""


def law_of_file(model: ControllerModel, robot: Mechanism) -> CompiledLaw | PythonLaw:
    """Return the law that the file of a controller holds.

    Raises:
        GainError: C604, the controller names no file.
        DiagramError: C621 to C626, the block diagram is wrong or does not fit.
        LawError: C602, the block that is to hold the arm has no influence on an axis.
        ModuleError: C628, C629: its module is not trusted or fails.
    """
    file = model.gains
    if not isinstance(file, ControllerFile):
        message = f"law `{model.kind.value}` takes the file of a law"
        raise GainError(GAINS_OF_ANOTHER_LAW.at(None, message, hint="give the gains as ControllerFile"))
    if not file.is_code:
        return _diagram_law(file, model.rates.control_period, robot)
    made = made_by_module(file, JOINT_CONTROLLER, robot, model)
    if isinstance(made, CompiledLaw):
        return made
    if not (hasattr(made, "traits") and callable(getattr(made, "step", None))):
        message = f"`{JOINT_CONTROLLER}` of `{file.path}` returns {type(made).__name__}"
        hint = "allowed are a CompiledLaw, and an object with `traits` and `step`"
        raise ModuleError(MODULE_FAILS.at(None, message, hint=hint))
    return cast("PythonLaw", made)


def law_file_findings(
    file: ControllerFile, text: SourceText, model: ControllerModel, robot: Mechanism
) -> tuple[Diagnostic, ...]:
    """Return the findings in the file of a law; a module is read and not run.

    Args:
        file: as the controller has it.
        text: of the file, under the name that findings use.
        model: the controller.
        robot: its arm, with drives.
    """
    if file.is_code:
        found = syntax_finding(text)
        return () if found is None else (found,)
    read = read_diagram(text)
    if read.diagram is None:
        return read.findings
    try:
        _diagram_law(file, model.rates.control_period, robot)
    except RopsimError as error:
        return (*read.findings, error.diagnostic)
    return read.findings


@lru_cache(maxsize=16)
def _diagram_law(file: ControllerFile, period: float, robot: Mechanism) -> CompiledLaw:
    read = read_diagram(SourceText(file.path, file.text))
    if read.diagram is None:
        raise DiagramError(next(one for one in read.findings if one.is_error))
    if not np.isclose(read.diagram.period, period, rtol=_ROUNDING, atol=0.0):
        found, needed = 1.0 / read.diagram.period, 1.0 / period
        message = f"controller `{read.diagram.name[:60]}` runs at {found:.6g} Hz, the cell at {needed:.6g} Hz"
        hint = "give both the same rate: `control_hz` in `[controller]`, the period in the file"
        raise DiagramError(DOES_NOT_FIT.at(None, message, hint=hint))
    return diagram_law(read.diagram, robot)
