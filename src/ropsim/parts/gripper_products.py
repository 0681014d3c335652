"""Grippers that are sold: published figures with their sources, and estimated edges of their housings."""

from ropsim.model import OriginKind
from ropsim.parts.part_kind import TCP, Fact, Product

_DH = (
    "TrossenRobotics/dobot_cr_cobots_docs docs/end_effectors/dh_robotics/{}.rst "
    "(figures of DH-Robotics, second hand); "
    "its one time holds for opening and for closing"
)
_FRANKA = "frankaemika/franka_description b299b39 end_effectors/"
_ROWS = (
    # name, model, page, stroke [m], mass [kg], time [s], least and greatest force [N], mass of a part [kg],
    # then length, width and depth of the housing [m] by eye
    ("dh_pge_5", "PGE-5", "pge5", 0.014, 0.4, 0.2, (0.8, 5.0), 0.1, (0.095, 0.055, 0.026)),
    ("dh_pge_8", "PGE-8", "pge8", 0.014, 0.4, 0.2, (2.0, 8.0), 0.1, (0.095, 0.055, 0.026)),
    ("dh_pge_15", "PGE-15", "pge15", 0.026, 0.4, 0.5, (6.0, 15.0), 0.25, (0.097, 0.062, 0.031)),
    ("dh_pge_50", "PGE-50", "pge50", 0.026, 0.4, 0.5, (15.0, 50.0), 1.0, (0.097, 0.062, 0.031)),
    ("dh_pgc_50", "PGC-50", "pgc50", 0.035, 0.5, 0.7, (15.0, 50.0), 1.0, (0.1, 0.063, 0.063)),
    ("dh_pgc_140", "PGC-140", "pgc140", 0.05, 0.5, 0.7, (40.0, 140.0), 1.0, (0.11, 0.075, 0.075)),
    ("dh_pgc_300", "PGC-300", "pgc300", 0.06, 1.5, 0.8, (40.0, 300.0), 6.0, (0.145, 0.094, 0.09)),
    ("dh_ag_95", "AG-95 (adaptive)", "ag95", 0.095, 1.0, 0.7, (45.0, 160.0), 3.0, (0.1, 0.1, 0.065)),
    ("dh_ag_145", "AG-145 (adaptive)", "ag145", 0.145, 1.3, 0.7, (35.0, 105.0), 2.0, (0.1, 0.12, 0.065)),
    ("dh_rgi_14", "RGI-14 (turns)", "rgi14", 0.014, 0.4, 0.3, (10.0, 35.0), 0.0, (0.125, 0.053, 0.034)),
    ("dh_rgi_30", "RGI-30 (turns)", "rgi30", 0.03, 1.2, 0.3, (10.0, 35.0), 0.0, (0.13, 0.068, 0.05)),
)
_TURNING = (Fact("torque of turning", (0.25,), "N·m"), Fact("speed of turning", (26.18,), "rad/s"))


def _dh_robotics() -> tuple[Product, ...]:
    """Return the grippers of DH-Robotics; turning ones have no published mass of a part."""
    return tuple(
        Product(
            name,
            f"DH-Robotics {model}",
            {"stroke": stroke, "mass": mass, "open_time": time, "close_time": time},
            OriginKind.PUBLISHED,
            _DH.format(page),
            dict(zip(("body_length", "body_width", "body_depth"), body, strict=True)),
            (
                Fact("grip force", force, "N"),
                *((Fact("mass of a part at most", (part_mass,), "kg"),) if part_mass else _TURNING),
            ),
        )
        for name, model, page, stroke, mass, time, force, part_mass, body in _ROWS
    )


TWO_FINGER_PRODUCTS = (
    Product(
        "franka_hand",
        "Franka hand",
        {"stroke": 0.08, "mass": 0.7126, TCP: 0.1034},
        OriginKind.PUBLISHED,
        f"{_FRANKA}franka_hand/inertials.yaml and franka_hand_arguments.xacro (tcp_xyz), "
        "end_effectors/common/franka_hand.xacro (0 to 0.04 m a finger)",
        {"body_width": 0.2, "finger_width": 0.02, "open_time": 0.2, "close_time": 0.2},
        (
            Fact("speed of a finger at most", (0.2,), "m/s"),
            Fact("mass of the hand", (0.6544,), "kg"),
            Fact("mass of a finger", (0.0291,), "kg"),
        ),
    ),
    Product(
        "robotiq_2f_85",
        "Robotiq 2F-85",
        {"stroke": 0.085, "mass": 0.9},
        OriginKind.PUBLISHED,
        "google-deepmind/mujoco_menagerie robotiq_2f85/2f85.xml; stroke by the type designation",
        {"body_length": 0.07, "body_width": 0.075, "body_depth": 0.06, "finger_width": 0.022},
        (Fact("mass of the base", (0.777441,), "kg"), Fact("edges of a pad", (0.022, 0.008, 0.0375), "m")),
    ),
    *_dh_robotics(),
)
"""Two-finger grippers; the fingers of adaptive ones are drawn as parallel ones."""

VACUUM_PRODUCTS = (
    Product(
        "franka_cobot_pump",
        "Franka cobot pump",
        {"mass": 1.01, "com": 0.063, TCP: 0.105},
        OriginKind.PUBLISHED,
        f"{_FRANKA}cobot_pump/inertials.yaml and cobot_pump_arguments.xacro (tcp_xyz); "
        "its tensor is a placeholder and not used",
        {"body_width": 0.11, "body_depth": 0.08},
    ),
)
"""Vacuum grippers."""
