"""Traced paths in plain loops that numba compiles: derivatives at the rows, polynomials between them."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1])")
def row_differences(rows: Array, inner: Array, sided: Array, out: Array) -> None:
    """Write the first and second derivative of every row, by the number of the row.

    Args:
        rows: at equidistant places, shape (k, n).
        inner: weights of the w rows around a row, shape (2, w), w odd.
        sided: weights of the first v rows at each of them, shape (2, v, v); the last v rows have them, too.
        out: where the derivatives go, shape (2, k, n).
    """
    _differences(rows, inner, sided, out)


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1])",
)
def rows_with_roughness(
    rows: Array,
    inner: Array,
    sided: Array,
    length: float,
    out: Array,
    coarse: Array,
    coarse_out: Array,
    rough: Array,
) -> None:
    """Write the derivatives of every row, and how far the path through every second row passes the others.

    Args:
        rows: at equidistant places, shape (2·m + 1, n).
        inner: weights as for `row_differences`.
        sided: likewise; v is no more than m + 1.
        length: of the way from the first row to the last.
        out: where the derivatives go, shape (2, 2·m + 1, n).
        coarse: where every second row goes, shape (m + 1, n).
        coarse_out: where its derivatives go, shape (2, m + 1, n).
        rough: where the greatest distance of a coordinate at each row between goes, shape (m,).
    """
    _differences(rows, inner, sided, out)
    for k in range(coarse.shape[0]):
        for j in range(rows.shape[1]):
            coarse[k, j] = rows[2 * k, j]
    _differences(coarse, inner, sided, coarse_out)
    step, per_unit = length / (rows.shape[0] - 1), (coarse.shape[0] - 1) / length
    for k in range(rough.shape[0]):
        place = (2.0 * k + 1.0) * step * per_unit
        row = min(max(int(place), 0), coarse.shape[0] - 2)
        t, most = place - row, 0.0
        for j in range(rows.shape[1]):
            start, v, a, c3, c4, c5 = _quintic(coarse, coarse_out, row, j)
            q = start + t * (v + t * (a + t * (c3 + t * (c4 + t * c5))))
            most = max(most, abs(q - rows[2 * k + 1, j]))
        rough[k] = most


@kernel("void(f8[:,::1], f8[:,:,::1], f8, f8[::1], f8[:,::1], f8[:,::1], f8[:,::1])")
def traced_points(
    rows: Array, derivatives: Array, per_unit: float, s: Array, q: Array, d1: Array, d2: Array
) -> None:
    """Write coordinates and derivatives by the place s between rows (quintic Hermite interpolation).

    Args:
        rows: at equidistant places from 0 on, shape (k, n).
        derivatives: first and second ones by the number of the row, shape (2, k, n).
        per_unit: rows in one unit of s.
        s: places, shape (m,).
        q: where the coordinates go, shape (m, n).
        d1: where first derivatives go, shape (m, n).
        d2: where second derivatives go, shape (m, n).
    """
    for k in range(s.shape[0]):
        place = s[k] * per_unit
        row = min(max(int(place), 0), rows.shape[0] - 2)
        t = place - row
        for j in range(rows.shape[1]):
            start, v, a, c3, c4, c5 = _quintic(rows, derivatives, row, j)
            q[k, j] = start + t * (v + t * (a + t * (c3 + t * (c4 + t * c5))))
            d1[k, j] = per_unit * (v + t * (2.0 * a + t * (3.0 * c3 + t * (4.0 * c4 + t * (5.0 * c5)))))
            d2[k, j] = per_unit * per_unit * (2.0 * a + t * (6.0 * c3 + t * (12.0 * c4 + t * (20.0 * c5))))


def _differences(rows: Array, inner: Array, sided: Array, out: Array) -> None:
    count, width, sides = rows.shape[0], inner.shape[1], sided.shape[1]
    half = width // 2
    for order in range(2):
        for k in range(count):
            inside = half <= k < count - half
            first = k - half if inside else 0 if k < half else count - sides
            for j in range(rows.shape[1]):
                total = 0.0
                for i in range(width if inside else sides):
                    weight = inner[order, i] if inside else sided[order, k - first, i]
                    total += weight * rows[first + i, j]
                out[order, k, j] = total


def _quintic(
    rows: Array, derivatives: Array, row: int, j: int
) -> tuple[float, float, float, float, float, float]:
    """Return the coefficients of t⁰ to t⁵ between a row and the next one, t from 0 to 1."""
    start, gap = rows[row, j], rows[row + 1, j] - rows[row, j]
    v, a = derivatives[0, row, j], 0.5 * derivatives[1, row, j]
    w, b = derivatives[0, row + 1, j], 0.5 * derivatives[1, row + 1, j]
    c3 = 10.0 * gap - 6.0 * v - 4.0 * w - 3.0 * a + b
    c4 = -15.0 * gap + 8.0 * v + 7.0 * w + 3.0 * a - 2.0 * b
    c5 = 6.0 * gap - 3.0 * (v + w) - a + b
    return start, v, a, c3, c4, c5
