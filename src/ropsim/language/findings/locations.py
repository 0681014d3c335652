"""Diagnostics of locations, points of lists and the ways through them, T342 to T345."""

from ropsim.core import Severity, define

POINTS_UP = define(
    "T342",
    "tool-points-up",
    Severity.WARNING,
    "a location whose turn about z stands alone",
    """
`(x, y, z)` points the tool down. With orientation terms it points where they say, and a turn about z alone
leaves it up, along the z of the frame. Who wants the tool down and turned writes `down` first:

```
lin (450, 0, 300; down, rz 30)
lin (450, 0, 300; rpy 0 0 30)       # up and turned, if that is meant
```

Steps of `rel` and frames are turned by `rz` as they stand, and nothing is said of them, nor of locations in
frames whose z does not point up in the world, as that of the base of an arm on the ceiling.
""",
)
NOT_OF_UNIT_LENGTH = define(
    "T343",
    "quaternion-not-of-unit-length",
    Severity.WARNING,
    "a quaternion whose length is not 1",
    """
`quat w x y z` takes four numbers whose squares add up to 1. Others are brought to that length; often a number
is missing a digit then, or stands in another place than it was meant for.

```
lin (450, 0, 300; quat 0 1 1 0)                  # of length 1.41421
lin (450, 0, 300; quat 0 0.7071068 0.7071068 0)
```
""",
)
POINTS_AT_ONE_PLACE = define(
    "T344",
    "points-at-one-place",
    Severity.WARNING,
    "points of a list that follow each other at one place",
    """
A motion along a list goes from each point to the next. Where two that follow each other are the same place
with the same orientation, within 0.001 mm, there is no way between them and the arm stops there, whatever
the zone. Lists that are cut from a drawing often have such points where two of its lines meet.

Leave one of the two out of the list. For a `spline` such points are an error (T393).
""",
)

NO_ZONE_ON_THE_WAY = define(
    "T345",
    "no-zone-on-the-way",
    Severity.HINT,
    "`blend 0` on a way through points does not stop at them",
    """
Points on the way of `lin via`, `mov via`, `lin along` and `mov along` are passed by: with the zone in force
(`set blend 2 mm`) or, without one, with that which the cell has for via points. So `blend 0` stops at the
last point only, as `fine` does.

Give the zone that is meant, such as `blend 1 mm`. To stop at each point, reach each by a motion of its own:

```task
for each p in seam
  lin p
endf
```
""",
)
