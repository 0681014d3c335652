"""The gains of a controller model as rows of parameters of its law."""

from ropsim.controller.law_diagnostics import GAIN_COUNT, GAINS_OF_ANOTHER_LAW, GainError
from ropsim.model import ControllerModel, Gains, gain_names
from ropsim.spatial import Array


def gain_rows(model: ControllerModel, kind: type[Gains], n: int) -> list[Array]:
    """Return the gains of a law, each of shape (n,).

    Args:
        model: the controller.
        kind: record of the gains that the law takes.
        n: number of axes.

    Raises:
        GainError: C600, C604: the gains belong to another law, or do not have a number per axis.
    """
    if not isinstance(model.gains, kind):
        names = ", ".join(f"`{name}`" for name in gain_names(model.gains))
        message = f"law `{model.kind.value}` takes {kind.__name__}, given are {names}"
        raise GainError(GAINS_OF_ANOTHER_LAW.at(None, message, hint=f"give the gains as {kind.__name__}"))
    rows: list[Array] = []
    for name in gain_names(model.gains):
        values = getattr(model.gains, name)
        if values.shape != (n,):
            message = f"gain `{name}` has shape `{values.shape}`; allowed is `({n},)`, one number per joint"
            raise GainError(GAIN_COUNT.at(None, message, hint="give one number per joint"))
        rows.append(values)
    return rows
