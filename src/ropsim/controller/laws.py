"""The table of laws for controller models: a new one is a file and an entry here."""

from collections.abc import Callable

from ropsim.controller.cascaded_p_pi import cascaded_p_pi
from ropsim.controller.computed_torque import computed_torque
from ropsim.controller.diagrams.law_files import law_of_file
from ropsim.controller.hydraulics.flow_law import flow_load_damping
from ropsim.controller.hydraulics.parallel_pi import parallel_pi
from ropsim.controller.law import CompiledLaw, PythonLaw
from ropsim.controller.law_diagnostics import GAINS_OF_ANOTHER_LAW, GainError
from ropsim.model import ControllerKind, ControllerModel, Mechanism

LAWS: dict[ControllerKind, Callable[[ControllerModel, Mechanism], CompiledLaw]] = {
    ControllerKind.CASCADED_P_PI: cascaded_p_pi,
    ControllerKind.COMPUTED_TORQUE: computed_torque,
    ControllerKind.FLOW_LOAD_DAMPING: flow_load_damping,
    ControllerKind.PARALLEL_PI: parallel_pi,
}
"""Without the ideal one, which no drive follows, and the law of a file."""


def law_of(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the built-in law of a controller model.

    Raises:
        GainError: the gains do not fit the law or the arm, or it has no built-in law.
        LawError: C602, the drives of the arm do not take the output of the law.
    """
    if model.kind not in LAWS:
        message = f"law `{model.kind.value}` has no gains, so it drives no motors"
        hint = "give the robot drives and a controller that is made for them"
        raise GainError(GAINS_OF_ANOTHER_LAW.at(None, message, hint=hint))
    return LAWS[model.kind](model, robot)


def joint_law(model: ControllerModel, robot: Mechanism) -> CompiledLaw | PythonLaw:
    """Return the law of a controller model: a built-in one, or that of a file of the project.

    Raises:
        GainError: as `law_of`.
        LawError: C602, the law does not fit.
        ModuleError: C628, C629: a module of the project is not trusted or fails.
        DiagramError: C621 to C626, a block diagram is wrong or does not fit.
    """
    return law_of_file(model, robot) if model.kind is ControllerKind.FILE else law_of(model, robot)
