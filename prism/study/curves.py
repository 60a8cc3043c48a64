"""The paper's two properties for every mechanism, and the most informative figures about each."""

from dataclasses import dataclass

from study.checking import Answers, Checker, combinations
from study.paper import ARRIVALS_PER_S, MECHANISMS, TIMES_S
from study.tables import Table


@dataclass(frozen=True)
class Curves:
    """Answers of paper.props and longrun.props by model."""

    by_time: dict[str, Answers]
    long_run: dict[str, Answers]

    def lost(self, model: str, time_s: float, **constants: float) -> float:
        return self.by_time[model].value("lost", T=time_s, **constants)

    def probability(self, model: str, time_s: float, **constants: float) -> float:
        return self.by_time[model].value("probability", T=time_s, **constants)

    def completion_s(self, model: str, **constants: float) -> float:
        return self.long_run[model].value("completion", **constants)

    def lost_per_s(self, model: str, **constants: float) -> float:
        return self.long_run[model].value("lost_rate", **constants)


def compute(checker: Checker) -> Curves:
    by_time, long_run = {}, {}
    for model, varied in MECHANISMS.items():
        constants = {"event_arrive": ARRIVALS_PER_S, **varied}
        by_time[model] = checker.check(model, "paper", {**constants, "T": TIMES_S})
        long_run[model] = checker.check(model, "longrun", constants)
    return Curves(by_time, long_run)


def curves_table(curves: Curves) -> Table:
    table = Table("curves", ("model", "conversion", "K", "T", "probability", "lost"))
    for model, varied in MECHANISMS.items():
        for constants in combinations(varied):
            for time_s in TIMES_S:
                table.add(
                    model,
                    constants.get("conversion"),
                    constants.get("K"),
                    time_s,
                    curves.probability(model, time_s, **constants),
                    curves.lost(model, time_s, **constants),
                )
    return table


def summary_table(curves: Curves) -> Table:
    table = Table("summary", ("model", "conversion", "K", "completion_s", "lost_per_s"))
    for model, varied in MECHANISMS.items():
        for constants in combinations(varied):
            table.add(
                model,
                constants.get("conversion"),
                constants.get("K"),
                curves.completion_s(model, **constants),
                curves.lost_per_s(model, **constants),
            )
    return table
