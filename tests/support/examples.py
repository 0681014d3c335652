"""How many examples a law is tried on: a share of what its test names, ten times as many in long runs."""

from hypothesis import HealthCheck, settings

SHARES = {"suite": 0.4, "long": 10.0}
"""Of the number that a test names, by profile: most examples are the same in each run."""
NAMED = 100
"""Examples of a law whose test names no number."""
LEAST = 5


def register_profiles() -> None:
    """Register the profiles, without deadlines, for cores are shared, and load that of the suite."""
    for name, share in SHARES.items():
        settings.register_profile(
            name,
            deadline=None,
            suppress_health_check=[HealthCheck.too_slow],
            max_examples=round(share * NAMED),
        )
    settings.load_profile("suite")


def examples(count: int) -> int:
    """Return on how many examples a law is tried in the loaded profile.

    Args:
        count: named by its test.
    """
    return max(min(count, LEAST), count * settings().max_examples // NAMED)
