"""The kind of mistake in meant contacts, X928."""

from ropsim.core import Severity, define

CONTACT_CANNOT_ACT = define(
    "X928",
    "contact-cannot-act",
    Severity.ERROR,
    "a meant contact has bodies between which no force can act",
    """
`[contacts.NAME]` names a tool or part (`of`) and what it is pressed on (`with`). Forces are computed from the
shapes of both. A body cannot be pressed on itself; a body without shapes, or drawn by a mesh, has no inside
that is known, so nothing could push back. Draw it by `shapes`: boxes, cylinders, spheres, prisms and
bodies of revolution; a hole is the gap between several of them.

```toml
[contacts.insertion]
of = "peg"
with = ["block"]
stiffness = 200   # N/mm
```
""",
)
