"""Losses compared with those of the device alone, for arrival rates and conversion times other than the paper's."""

from study.checking import Checker, Number
from study.paper import HORIZON_S
from study.tables import Table

ARRIVALS_PER_S = tuple(round(0.1 * step, 1) for step in range(1, 21))
CONVERSIONS_S = tuple(round(0.1 * step, 1) for step in range(1, 21))
MECHANISMS: dict[str, dict[str, Number]] = {"exact": {}, "fifo-serial": {"K": 8}, "fifo-pipelined": {"K": 8}}


def sensitivity_table(checker: Checker) -> Table:
    """Events lost until 100 s, and their ratio to what the device alone loses."""
    table = Table("sensitivity", ("model", "K", "arrivals_per_s", "conversion", "lost", "of_baseline"))
    alone = checker.check("baseline", "paper", {"event_arrive": ARRIVALS_PER_S, "T": HORIZON_S})
    for model, constants in MECHANISMS.items():
        varied = {**constants, "event_arrive": ARRIVALS_PER_S, "conversion": CONVERSIONS_S, "T": HORIZON_S}
        answers = checker.check(model, "paper", varied)
        for arrivals in ARRIVALS_PER_S:
            for conversion in CONVERSIONS_S:
                lost = answers.value("lost", event_arrive=arrivals, conversion=conversion)
                ratio = lost / alone.value("lost", event_arrive=arrivals)
                table.add(model, constants.get("K"), arrivals, conversion, lost, ratio)
    return table
