"""When the converter's recorded state differs from the device's for the first time."""

from study.checking import Checker, combinations
from study.paper import ARRIVALS_PER_S, MECHANISMS
from study.tables import Table

TIMES_S = (5, 10, 20, 100)


def belief_table(checker: Checker) -> Table:
    """Mean time to the first difference, and the probability of one by certain times."""
    differed = tuple(f"differed_{time_s}_s" for time_s in TIMES_S)
    table = Table("belief", ("model", "conversion", "K", "mean_s", *differed))
    for model in ("exact", "fifo-serial", "fifo-pipelined"):
        varied = MECHANISMS[model]
        answers = checker.check(model, "belief", {"event_arrive": ARRIVALS_PER_S, **varied, "T": TIMES_S})
        for constants in combinations(varied):
            table.add(
                model,
                constants["conversion"],
                constants.get("K"),
                answers.value("divergence", **constants),
                *(answers.value("differed", T=time_s, **constants) for time_s in TIMES_S),
            )
    return table
