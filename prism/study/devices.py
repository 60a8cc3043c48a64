"""More difficult devices: two events for one decision, and readiness that is only inferred."""

from study.checking import Checker
from study.paper import ARRIVALS_PER_S, CAPACITIES, HORIZON_S
from study.tables import Table
from study.waiting import mean_wait_s

CONVERSION_S = 0.25
CAPACITY = 8
HOLDOFFS_S = tuple(round(0.2 * step, 1) for step in range(1, 21))
PATHS = {"one event of 1 s": (1, 1.0), "two events of 0.5 s": (2, 0.5), "two events of 1 s": (2, 1.0)}
"""Events for each decision and mean action time for each of them."""


def path_table(checker: Checker) -> Table:
    table = Table("path", ("device", "steps", "action", "K", "lost", "completion_s", "lost_per_s", "mean_wait_s"))
    for device, (steps, action) in PATHS.items():
        constants = {
            "event_arrive": ARRIVALS_PER_S,
            "conversion": CONVERSION_S,
            "steps": steps,
            "action": action,
            "K": CAPACITIES,
        }
        by_time = checker.check("path", "paper", {**constants, "T": HORIZON_S})
        long_run = checker.check("path", "longrun", constants)
        waiting = checker.check("path", "waiting", constants)
        for capacity in CAPACITIES:
            table.add(
                device,
                steps,
                action,
                capacity,
                by_time.value("lost", K=capacity),
                long_run.value("completion", K=capacity),
                long_run.value("lost_rate", K=capacity),
                mean_wait_s(waiting, K=capacity),
            )
    return table


def holdoff_table(checker: Checker) -> Table:
    header = ("holdoff", "K", "lost", "completion_s", "lost_per_s", "lost_in_device_per_s", "divergence_s")
    table = Table("holdoff", header)
    constants = {
        "event_arrive": ARRIVALS_PER_S,
        "conversion": CONVERSION_S,
        "K": CAPACITY,
        "holdoff": HOLDOFFS_S,
    }
    by_time = checker.check("holdoff", "paper", {**constants, "T": HORIZON_S})
    long_run = checker.check("holdoff", "longrun", constants)
    in_device = checker.check("holdoff", "holdoff", constants)
    belief = checker.check("holdoff", "belief", {**constants, "T": HORIZON_S})
    for holdoff in HOLDOFFS_S:
        table.add(
            holdoff,
            CAPACITY,
            by_time.value("lost", holdoff=holdoff),
            long_run.value("completion", holdoff=holdoff),
            long_run.value("lost_rate", holdoff=holdoff),
            in_device.value("lost_in_device_rate", holdoff=holdoff),
            belief.value("divergence", holdoff=holdoff),
        )
    return table
