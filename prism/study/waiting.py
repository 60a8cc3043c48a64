"""How long an event waits in our converter, from its arrival until it is passed to the device."""

from study.checking import Answers, Checker
from study.paper import ARRIVALS_PER_S, CAPACITIES, CONVERSIONS_S
from study.tables import Table

LONGEST_S = 10
STAGES = {"serial": (0, 1), "pipelined": (0, 1, 2)}
"""What an event can find besides the events before it, the values of the models' formula stage."""


def mean_wait_s(answers: Answers, **constants: float) -> float:
    """The mean wait by Little's law, from the answers of waiting.props."""
    return answers.value("held", **constants) / answers.value("taken_rate", **constants)


def waiting_table(checker: Checker) -> Table:
    table = Table("waiting", ("model", "conversion", "K", "mean_s"))
    constants = {"event_arrive": ARRIVALS_PER_S, "conversion": CONVERSIONS_S, "K": CAPACITIES}
    for kind in STAGES:
        model = f"fifo-{kind}"
        answers = checker.check(model, "waiting", constants)
        for conversion in CONVERSIONS_S:
            for capacity in CAPACITIES:
                table.add(model, conversion, capacity, mean_wait_s(answers, conversion=conversion, K=capacity))
    return table


def longer_table(checker: Checker) -> Table:
    """The probability that an event waits longer than t."""
    table = Table("waiting-longer", ("model", "conversion", "K", "t", "probability"))
    times = tuple(range(LONGEST_S + 1))
    for kind, stages in STAGES.items():
        # One event's wait does not depend on how many others could still have queued behind it.
        ways = checker.check(
            f"wait-{kind}",
            "wait",
            {"conversion": CONVERSIONS_S, "ahead": tuple(range(max(CAPACITIES))), "stage": stages, "t": times},
        )
        for capacity in CAPACITIES:
            found = checker.check(
                f"fifo-{kind}",
                "found",
                {
                    "event_arrive": ARRIVALS_PER_S,
                    "K": capacity,
                    "conversion": CONVERSIONS_S,
                    "found_waiting": tuple(range(capacity + 1)),
                    "found_stage": stages,
                },
            )
            for conversion in CONVERSIONS_S:
                for time_s in times:
                    longer = _longer(found, ways, capacity, stages, conversion, time_s)
                    table.add(f"fifo-{kind}", conversion, capacity, time_s, longer)
    return table


def _longer(
    found: Answers, ways: Answers, capacity: int, stages: tuple[int, ...], conversion: float, time_s: int
) -> float:
    """Weighted over all queue lengths that an accepted event can find."""
    taken = longer = 0.0
    for ahead in range(capacity):
        for stage in stages:
            share = found.value("found", conversion=conversion, found_waiting=ahead, found_stage=stage)
            over = ways.value("handed_over", conversion=conversion, ahead=ahead, stage=stage, t=time_s)
            taken += share
            longer += share * (1 - over)
    return longer / taken
