"""How many parts are where they were to be when the run ended, in words."""

from ropsim.core import plural
from ropsim.flow import Destinations


def destinations_text(found: Destinations) -> str:
    """Return it as a line, such as `12 of 12 parts at their destination`."""
    whose = "its" if found.wanted == 1 else "their"
    return f"{found.reached} of {plural(found.wanted, 'part')} at {whose} destination"
