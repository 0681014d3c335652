"""Findings about ways through points and along lists of points (codes T3xx)."""

from ropsim.core import Severity, define

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

Give the zone that is meant, such as `blend 1 mm`, or set one before and write `fine`, which stops at the last
point only:

```task
set blend 1 mm
lin along seam fine
```

To stop at each point, reach each by a motion of its own:

```task
for each p in seam
  lin p
endf
```
""",
)
