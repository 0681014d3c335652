"""Triangles into a depth buffer: the nearest surface at each point of a picture (Catmull 1974)."""

import numpy as np

from ropsim.spatial import Array


class DepthBuffer:
    """A picture while it is drawn; x goes to the right, y down, and depth towards the eye.

    Attributes:
        depth: of the visible surface, shape (height, width); -inf if there is none.
        seen: number of the triangle that is seen there, shape (height, width); -1 for none.
    """

    def __init__(self, width: int, height: int) -> None:
        self.depth = np.full((height, width), -np.inf)
        self.seen = np.full((height, width), -1)

    def draw(self, triangles: Array) -> None:
        """Draw triangles, numbered from 0.

        Args:
            triangles: corners in points of the picture, and their depths, shape (k, 3, 3).
        """
        for number, corners in enumerate(triangles):
            self._draw(number, corners)

    def _draw(self, number: int, corners: Array) -> None:
        height, width = self.depth.shape
        (x0, y0, _), (x1, y1, _) = corners.min(axis=0), corners.max(axis=0)
        left, right = max(int(np.ceil(x0)), 0), min(int(x1), width - 1)
        upper, lower = max(int(np.ceil(y0)), 0), min(int(y1), height - 1)
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners.tolist()
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if left > right or upper > lower or abs(area) < 1e-9:
            return
        x, y = np.arange(left, right + 1)[None, :], np.arange(upper, lower + 1)[:, None]
        u = ((cx - bx) * (y - by) - (cy - by) * (x - bx)) / area
        v = ((ax - cx) * (y - cy) - (ay - cy) * (x - cx)) / area
        w = 1.0 - u - v
        depth = u * az + v * bz + w * cz
        place = slice(upper, lower + 1), slice(left, right + 1)
        nearer = (u >= 0.0) & (v >= 0.0) & (w >= 0.0) & (depth > self.depth[place])
        self.depth[place][nearer] = depth[nearer]
        self.seen[place][nearer] = number
