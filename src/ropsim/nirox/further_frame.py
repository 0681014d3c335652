"""Frames of a file that are not the mechanical interface: of tools, tasks, cameras."""

from ropsim.spatial import Pose, record


@record
class FurtherFrame:
    """A frame on a link.

    Attributes:
        name: of the frame.
        role: what it is for, an item of the enumeration `frame_role` in small letters.
        link: number of the link that carries it, from 0; -1 for the base.
        X_LF: its pose in the frame of the joint that moves that link.
    """

    name: str
    role: str
    link: int
    X_LF: Pose
