import numpy as np

from ropsim.model import Payload, box, combine

#: Rounding of sums of a few products.
ROUNDING = 1e-15


def test_two_half_boxes_are_one_box() -> None:
    whole = box(2.0, np.array([0.4, 0.2, 0.1]), np.zeros(3), np.eye(3))
    half = np.array([0.2, 0.2, 0.1])
    left = box(1.0, half, np.array([-0.1, 0.0, 0.0]), np.eye(3))
    right = box(1.0, half, np.array([0.1, 0.0, 0.0]), np.eye(3))
    both = combine((left, right))
    assert both.mass == 2.0
    np.testing.assert_allclose(both.com, whole.com, atol=ROUNDING)
    np.testing.assert_allclose(both.inertia, whole.inertia, atol=ROUNDING)


def test_nothing_weighs_nothing() -> None:
    assert combine(()).mass == 0.0
    assert combine((Payload(), Payload())).mass == 0.0


def test_a_turned_box_has_turned_inertia() -> None:
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    plain = box(1.0, np.array([0.4, 0.2, 0.1]), np.zeros(3), np.eye(3)).inertia
    turned = box(1.0, np.array([0.4, 0.2, 0.1]), np.zeros(3), turn).inertia
    np.testing.assert_allclose(np.diag(turned), np.diag(plain)[[1, 0, 2]], atol=ROUNDING)
