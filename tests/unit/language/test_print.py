"""What `print` shows: quantities in the units of the text."""

import pytest

from ropsim import icr
from support.tasks import compiled


def said(text: str) -> str:
    result = compiled(text)
    assert result.icr is not None, result.diagnostics
    (message,) = icr.run(result.icr).messages
    return message


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("units mm\nh = 0.12 m\nprint h", "120 mm"),
        ("h = 120 mm\nprint h", "12 cm"),
        ("units inch\nprint 25.4 mm", "1 inch"),
        ("units m, rad\nprint 90 deg, 20 mm/s", "1.5708 rad 0.02 m/s"),
        ("units mm, deg\nprint 90 deg, 20 mm/s, 3 s, 5 N, 30 %", "90 deg 20 mm/s 3 s 5 N 30 %"),
        ("units mm\nx = 3\nlin (x, 3, 3)\nprint x", "3 mm"),
        ('print 3, 3.5, true, "a"', "3 3.5 true a"),
        ("units mm\nprint dist(infeed, infeed above 30), infeed.x", "30 mm 400 mm"),
        ("units mm, deg\nprint infeed", "(400, 300, 100) mm (180, 0, 0) deg"),
        ("units mm, deg\nset frame pallet\nprint (1, 2, 3; rpy 0 0 30)", "(1, 2, 3) mm (0, 0, 30) deg"),
        ("a = 2 m\nprint a * a", "40000 cm2"),
        ("units mm\nprint 3 mm * 4 mm, 6 mm / 2 s, 1 / 2 s", "12 mm2 3 mm/s 0.5 1/s"),
        ("units mm, ms\nprint 5 N * 3 s, 3 mm / 2 s / 2 s / 1 s", "15 kg·mm/ms 7.5e-10 mm/ms3"),
        ("units m\nprint 2 Nm / 4 mA, 2 kg * 3 m, 50 % * 3 m", "500 kg·m2/(s2·A) 6 kg·m 150 m·%"),
        ("units inch\nprint 1 inch / 2 inch", "0.5"),
    ],
)
def test_quantities_are_shown_in_the_units_of_the_text(text: str, shown: str) -> None:
    assert said(text) == shown
