"""Values that break readers."""

NUMBERS = (
    "0", "-0", "1", "-1", "2", "3", "7", "8", "9", "255", "256", "65535", "65536", "2147483647",
    "2147483648", "-2147483648", "4294967295", "4294967296", "9223372036854775808", "18446744073709551616",
    "1e308", "-1e308", "1e309", "1e-308", "5e-324", "nan", "inf", "-inf", "NaN", "Infinity", "1_000", "0x7f",
    "1e", ".", "-", "1.5", "9" * 400,
)  # fmt: skip
"""Numbers as texts write them, and what looks like one."""

INTEGERS = (0, 1, 2, 3, 7, 127, 128, 255, 256, 32767, 65535, 2**31 - 1, 2**31, 2**32 - 1, 2**53, 2**63 - 1)
"""Numbers as bytes hold them."""

DOUBLES = (0.0, -0.0, 1.0, -1.0, 1e308, -1e308, 5e-324, 1e-300, float("inf"), float("-inf"), float("nan"))

TEXTS = (
    "", " ", "\n", "\t", "\0", "a" * 3000, "../../../etc/passwd", "/etc/passwd", "http://localhost/x", "file:///x",
    "data:;base64,AAAA", "C:\\x", "%s%n", "{}", "\N{ROBOT FACE}", "\u202e", "\ufeff", "e\u0301", "__proto__",
    "$number", "NaN", "é", "'", '"', "\\", "#", "[", "]", "(", ")", "=", ",",
)  # fmt: skip

VALUES: tuple[object, ...] = (
    *(None, True, False, [], {}, [[]], [None], {"": 0}, [1, 2, 3], {"$number": "NaN"}, {"$number": 1}),
    *(0, 1, -1, 2, 3, 255, 2**31, 2**32, -(2**31), 2**53, 2**63, 2**64, 10**30, 10**400),
    *(0.5, -0.5, 1e308, -1e308, 5e-324),
    *TEXTS[:20],
)
"""Values as JSON holds them."""

DEPTHS = (3, 30, 300, 3000, 60_000)
"""Levels of nesting."""
