"""The table of laws that a controller model can ask for: a new one is a file and an entry here."""

from collections.abc import Callable

from ropsim.controller.cascaded_p_pi import cascaded_p_pi
from ropsim.controller.computed_torque import computed_torque
from ropsim.controller.law import CompiledLaw
from ropsim.model import ControllerKind, ControllerModel, Mechanism

LAWS: dict[ControllerKind, Callable[[ControllerModel, Mechanism], CompiledLaw]] = {
    ControllerKind.CASCADED_P_PI: cascaded_p_pi,
    ControllerKind.COMPUTED_TORQUE: computed_torque,
}


def law_of(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the law that a controller model asks for.

    Raises:
        GainError: the gains do not fit the law or the arm.
        LawError: C602, the drives of the arm do not take what the law puts out.
    """
    return LAWS[model.kind](model, robot)
