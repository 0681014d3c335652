"""The finding about contacts that are too stiff for the control rate, S775."""

from ropsim.core import Severity, define

STIFF_CONTACT = define(
    "S775",
    "contact-too-stiff",
    Severity.WARNING,
    "a meant contact is too stiff for the control rate",
    """
The force of a contact is held over a control tick T, as the output of the joint controller is. It is that of
the pose half a tick ahead, so that stiffness k and damping c act on a mass m as a damper of c + k·T/2. Such a
held damper brings the mass to rest while c + k·T/2 < 2·m/T, and throws it back harder than it came beyond.

The mass is what the tool centre point resists to a force in its lightest direction, with rotors and gears, at
the start and in the rest position. Lower `stiffness` or `damping` of the contact, or raise `control_hz`.
""",
)
