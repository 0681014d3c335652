"""Classes of arms: how the mass of an arm is spread over its links, and how strong its wrist is."""

from enum import Enum


class ArmClass(Enum):
    """What an arm is built as; rules of estimates differ by it.

    Cobots have joints of one kind all along the arm. Their axes look like those of industrial arms, so a
    file of such an arm says its class.
    """

    INDUSTRIAL = "industrial"
    COBOT = "cobot"
    SEVEN_AXIS = "seven-axis"
    SCARA = "scara"
    PALLETIZER = "palletizer"
