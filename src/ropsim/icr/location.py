"""POSE values as locations: a pose in seven numbers, and behind them values of external axes."""

from ropsim.spatial import PoseTuple, quaternion

Location = tuple[float, ...]
"""(x, y, z, qw, qx, qy, qz) [m, 1], then 0 to `MAX_EXTERNAL` values of external axes [rad | m]."""


def pose_part(location: Location) -> PoseTuple:
    """Return the pose of a location."""
    x, y, z, qw, qx, qy, qz = location[:7]
    return (x, y, z, qw, qx, qy, qz)


def external_part(location: Location) -> tuple[float, ...]:
    """Return the values of external axes that a location carries [rad | m]; empty where it has none."""
    return location[7:]


def composed(left: Location, right: Location) -> Location:
    """Return X_AC of X_AB and X_BC.

    It carries the values of external axes of `left`, where that has none those of `right`: a location keeps
    its own whether it is moved in its tool frame (it is `left`) or brought into another frame (`right`).
    """
    if len(left) == len(right) == 7:
        return quaternion.compose(left, right)
    pose = quaternion.compose(pose_part(left), pose_part(right))
    return (*pose, *(external_part(left) or external_part(right)))
