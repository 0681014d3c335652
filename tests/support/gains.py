"""The gains of a controller in tests, as those of the law that they mean."""

from ropsim.model import CascadedGains, ControllerModel


def cascaded(controller: ControllerModel) -> CascadedGains:
    """Return the gains of a cascaded controller."""
    assert isinstance(controller.gains, CascadedGains)
    return controller.gains
