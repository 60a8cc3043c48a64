"""How many of the lost events the listing counts, and from which conversion time on a mechanism loses more than the device alone."""

from collections.abc import Callable

from study.checking import Checker, Number
from study.paper import ARRIVALS_PER_S, CAPACITIES, CONVERSIONS_S, HORIZON_S
from study.tables import Table

_SHORTEST_S = 0.005
_LONGEST_S = 8.0
_TOLERANCE_S = 1e-4


def counting_table(checker: Checker) -> Table:
    """Losses of the paper's mechanism until 100 s, as listed and exactly, and the counted share of the device's losses."""
    constants = {"event_arrive": ARRIVALS_PER_S, "conversion": CONVERSIONS_S}
    listed = checker.check("listing", "paper", {**constants, "T": HORIZON_S})
    exact = checker.check("exact", "paper", {**constants, "T": HORIZON_S})
    listed_rate = checker.check("listing", "longrun", constants)
    exact_rate = checker.check("exact", "longrun", constants)
    held = checker.check("exact", "waiting", constants)
    table = Table("counting", ("conversion", "lost_listing", "lost_exact", "device_losses_counted"))
    for conversion in CONVERSIONS_S:
        # An event that arrives while one is in conversion is lost in the converter, which the listing counts correctly.
        in_converter = ARRIVALS_PER_S * held.value("held", conversion=conversion)
        counted = listed_rate.value("lost_rate", conversion=conversion) - in_converter
        real = exact_rate.value("lost_rate", conversion=conversion) - in_converter
        table.add(
            conversion,
            listed.value("lost", conversion=conversion),
            exact.value("lost", conversion=conversion),
            counted / real,
        )
    return table


def flagged_baseline(checker: Checker) -> float:
    """The losses of the device alone until 100 s, counted as in the listing."""
    constants = {"event_arrive": ARRIVALS_PER_S, "T": HORIZON_S}
    return checker.check("baseline-flag", "paper", constants).value("lost")


def break_even_table(checker: Checker) -> Table:
    """The conversion time at which a mechanism loses as many events until 100 s as the device alone."""
    alone = checker.check("baseline", "paper", {"event_arrive": ARRIVALS_PER_S, "T": HORIZON_S}).value("lost")
    table = Table("break-even", ("model", "K", "conversion_s"))
    mechanisms: list[tuple[str, dict[str, Number]]] = [("listing", {}), ("exact", {})]
    mechanisms += [(model, {"K": K}) for model in ("fifo-serial", "fifo-pipelined") for K in CAPACITIES]
    for model, constants in mechanisms:

        def excess(conversion_s: float, model: str = model, constants: dict[str, Number] = constants) -> float:
            given = {"event_arrive": ARRIVALS_PER_S, "T": HORIZON_S, "conversion": conversion_s, **constants}
            return checker.check(model, "paper", given).value("lost") - alone

        table.add(model, constants.get("K"), root(excess, _SHORTEST_S, _LONGEST_S, _TOLERANCE_S))
    return table


def root(function: Callable[[float], float], low: float, high: float, tolerance: float) -> float:
    """Where an increasing function is zero (regula falsi, Illinois variant)."""
    at_low, at_high = function(low), function(high)
    if at_low > 0 or at_high < 0:
        raise ValueError(f"no zero between {low} and {high}: {at_low} to {at_high}")
    previous, side = low, 0
    while True:
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        value = function(middle)
        if abs(middle - previous) < tolerance or value == 0:
            return middle
        previous = middle
        if value < 0:
            low, at_low = middle, value
            at_high = at_high / 2 if side < 0 else at_high
            side = -1
        else:
            high, at_high = middle, value
            at_low = at_low / 2 if side > 0 else at_low
            side = 1
