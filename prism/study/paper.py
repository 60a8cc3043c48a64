"""The parameters of the paper's experiment, and the mechanisms that are compared with it."""

ARRIVALS_PER_S = 0.5
CONVERSIONS_S = (0.25, 0.5, 0.75, 1.0)
CAPACITIES = (1, 2, 4, 8, 16)
TIMES_S = tuple(range(0, 101, 5))
HORIZON_S = 100

MECHANISMS: dict[str, dict[str, tuple[float | int, ...]]] = {
    "baseline": {},
    "listing": {"conversion": CONVERSIONS_S},
    "exact": {"conversion": CONVERSIONS_S},
    "fifo-serial": {"conversion": CONVERSIONS_S, "K": CAPACITIES},
    "fifo-pipelined": {"conversion": CONVERSIONS_S, "K": CAPACITIES},
}
"""Each model and the constants that are varied."""
