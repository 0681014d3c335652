"""A plane plot with equal scales on both axes: grid, ticks, and drawings in metres."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array
from ropsim.views.markup.markup import coordinate, points, text
from ropsim.views.markup.ticks import nice_ticks, padded, tick_text

WIDTH, HEIGHT = 500.0, 440.0
LEFT, RIGHT, TOP, BOTTOM = 62.0, 486.0, 14.0, 396.0


@frozen_dataclass
class Plane:
    """Where coordinates [m] lie in a drawing.

    Attributes:
        x0: coordinate in the middle of the drawing [m].
        y0: the same upwards [m].
        scale: of the drawing [1/m].
    """

    x0: float
    y0: float
    scale: float

    @classmethod
    def around(cls, x: Array, y: Array) -> "Plane":
        """Return the plane that holds all of these coordinates [m]."""
        x_low, x_high = padded(float(x.min()), float(x.max()))
        y_low, y_high = padded(float(y.min()), float(y.max()))
        scale = min((RIGHT - LEFT) / (x_high - x_low), (BOTTOM - TOP) / (y_high - y_low))
        return cls((x_low + x_high) / 2.0, (y_low + y_high) / 2.0, scale)

    def x(self, value: float) -> float:
        """Return where a coordinate to the right is drawn."""
        return (LEFT + RIGHT) / 2.0 + (value - self.x0) * self.scale

    def y(self, value: float) -> float:
        """Return where a coordinate upwards is drawn."""
        return (TOP + BOTTOM) / 2.0 - (value - self.y0) * self.scale

    def area(self, lines: Iterable[Array], kind: str) -> str:
        """Return an area between closed lines, each (k, 2)."""
        path = "".join(f"M{points(map(self.x, line[:, 0]), map(self.y, line[:, 1]))}Z" for line in lines)
        return f'<path class="{kind}" fill-rule="evenodd" d="{path}"/>' if path else ""

    def square(self, centre: tuple[float, float], size: float, kind: str, share: float) -> str:
        """Return a square around a place, its opacity a share."""
        side = size * self.scale
        x, y = coordinate(self.x(centre[0]) - side / 2.0), coordinate(self.y(centre[1]) - side / 2.0)
        end = coordinate(side + 0.1)
        return (
            f'<rect class="{kind}" x="{x}" y="{y}" width="{end}" height="{end}" fill-opacity="{share:.2f}"/>'
        )

    def line(self, places: Array, kind: str) -> str:
        """Return a line through places (k, 2)."""
        way = points(map(self.x, places[:, 0]), map(self.y, places[:, 1]))
        return f'<g class="{kind}"><polyline points="{way}"/></g>'

    def circle(self, centre: tuple[float, float], radius: float, kind: str) -> str:
        """Return a circle of a radius [m]."""
        x, y = coordinate(self.x(centre[0])), coordinate(self.y(centre[1]))
        return f'<circle class="{kind}" cx="{x}" cy="{y}" r="{coordinate(radius * self.scale)}"/>'

    def ring(self, place: tuple[float, float], name: str) -> str:
        """Return the mark of a point that is reached, with its name."""
        x, y = coordinate(self.x(place[0])), coordinate(self.y(place[1]))
        return f'<circle class="spot" cx="{x}" cy="{y}" r="4"><title>{text(name)}</title></circle>'

    def cross(self, place: tuple[float, float], name: str) -> str:
        """Return the mark of a point that is missed, with its name."""
        x, y = self.x(place[0]), self.y(place[1])
        title = f"<title>{text(name)}</title>"
        a, b, c, d = (coordinate(one) for one in (x - 4.0, x + 4.0, y - 4.0, y + 4.0))
        return f'<path class="missed" d="M{a},{c}L{b},{d}M{a},{d}L{b},{c}">{title}</path>'

    def drawing(self, ident: str, words: tuple[str, str], axes: tuple[str, str], parts: Iterable[str]) -> str:
        """Return the drawing as an SVG element with grid and ticks.

        Args:
            ident: unique name inside the page.
            words: title and a sentence about the picture.
            axes: names of the axes, with units.
            parts: drawings, made by the other functions.
        """
        middle = f'x="{(LEFT + RIGHT) / 2:g}" y="{HEIGHT - 6:g}"'
        turned = f'transform="translate(14 {(TOP + BOTTOM) / 2:g}) rotate(-90)"'
        clip = f'<clipPath id="{ident}-c"><rect x="{LEFT:g}" y="{TOP:g}" width="{RIGHT - LEFT:g}"'
        return (
            f'<svg class="plane" viewBox="0 0 {WIDTH:g} {HEIGHT:g}" role="img"'
            f' aria-labelledby="{ident}-t {ident}-d">\n'
            f'<title id="{ident}-t">{text(words[0])}</title><desc id="{ident}-d">{text(words[1])}</desc>\n'
            f'{clip} height="{BOTTOM - TOP:g}"/></clipPath>{self._grid()}'
            f'<g clip-path="url(#{ident}-c)">{"".join(parts)}</g>'
            f'<text class="middle tick" {middle}>{text(axes[0])}</text>'
            f'<text class="middle tick" {turned}>{text(axes[1])}</text></svg>\n'
        )

    def _grid(self) -> str:
        half_x, half_y = (RIGHT - LEFT) / 2.0 / self.scale, (BOTTOM - TOP) / 2.0 / self.scale
        xs = nice_ticks(1e3 * (self.x0 - half_x), 1e3 * (self.x0 + half_x), 5)
        ys = nice_ticks(1e3 * (self.y0 - half_y), 1e3 * (self.y0 + half_y), 5)
        size = f'width="{RIGHT - LEFT:g}" height="{BOTTOM - TOP:g}"'
        made = [f'<rect class="plot" x="{LEFT:g}" y="{TOP:g}" {size}/>']
        for tick in xs:
            x = coordinate(self.x(tick / 1e3))
            made.append(f'<line class="grid" x1="{x}" x2="{x}" y1="{TOP:g}" y2="{BOTTOM:g}"/>')
            label = tick_text(tick + 0.0, xs)
            made.append(f'<text class="middle tick" x="{x}" y="{BOTTOM + 16:g}">{label}</text>')
        for tick in ys:
            y = self.y(tick / 1e3)
            at = f'y1="{coordinate(y)}" y2="{coordinate(y)}"'
            made.append(f'<line class="grid" x1="{LEFT:g}" x2="{RIGHT:g}" {at}/>')
            label = tick_text(tick + 0.0, ys)
            made.append(f'<text class="end tick" x="{LEFT - 6:g}" y="{coordinate(y + 3.5)}">{label}</text>')
        return "".join(made)
