"""Diagnostics of shapes (X886, X887)."""

from ropsim.core import Severity, define

UNFIT_COLOUR = define(
    "X886",
    "unfit-colour",
    Severity.ERROR,
    "a colour is not written as `#rrggbb`",
    """
Colours are two hexadecimal digits each for red, green and blue after a `#`, such as `"#d99a3d"`.

```toml
colour = "orange"      # wrong
colour = "#e07b28"     # right
```
""",
)

UNFIT_SHAPE = define(
    "X887",
    "unfit-shape",
    Severity.ERROR,
    "a shape cannot be drawn as it is described",
    """
A shape is one graphic element: `box`, `cylinder`, `capsule`, `sphere`, `revolve`, `prism`, `line`, `mesh`
and so on. A prism needs an outline of at least three points that encloses an area and does not cross
itself; a revolved profile and a line need at least two points, and the radii of a profile cannot be
negative.

```toml
shapes = [
  { box = [800, 600, 20], position = [0, 0, 10] },
  { cylinder = { radius = 40, length = 300 }, colour = "#3c434a" },
]
```
""",
)
