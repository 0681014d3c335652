"""The base frame of a robot: where poses of the world become those of its programs and its controller."""

from collections.abc import Mapping

from ropsim.spatial import Pose


def in_base(X_WB: Pose, poses: Mapping[str, Pose]) -> dict[str, Pose]:
    """Return X_BA = X_WB⁻¹ · X_WA of each pose by name; where B is W, the very same poses.

    Args:
        X_WB: base frame in the world frame.
        poses: X_WA by name.
    """
    X_BW = X_WB.inverse()
    return {name: X_BW @ X_WA for name, X_WA in poses.items()}
