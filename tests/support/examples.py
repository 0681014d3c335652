"""How many examples a law is tried on: as its test says, or ten times as many (`make test-all`)."""

from hypothesis import HealthCheck, settings

USUAL = 100
"""Examples of a law that names no number."""
MORE = 10
"""Times as many in the long profile."""


def register_profiles() -> None:
    """Register the profiles `suite`, which is loaded, and `long`, without deadlines: cores are shared."""
    for name, count in (("suite", USUAL), ("long", MORE * USUAL)):
        settings.register_profile(
            name, deadline=None, suppress_health_check=[HealthCheck.too_slow], max_examples=count
        )
    settings.load_profile("suite")


def examples(count: int) -> int:
    """Return how many examples the loaded profile has where the usual one has `count`."""
    return count * settings().max_examples // USUAL
