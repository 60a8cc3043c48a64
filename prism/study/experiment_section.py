"""The section of the report on the running converter."""

from study.comparing import Comparison, failures
from study.markdown import table
from study.points import BATCHES, MEASURED, MODES, POINTS, Mode
from study.predictions import QUANTITIES, TAIL

_TAIL_TIMES_S = (1, 2, 4, 6, 8)


def experiment(comparisons: list[Comparison], events: dict[Mode, int]) -> str:
    if not comparisons:
        return """## 8. The converter that runs

Not measured yet; `./evoloop study --experiment` does."""
    by_place = {(one.mode, one.point.name, one.quantity, one.time_s): one for one in comparisons}
    rows, disturbed, tails = [], [], []
    for mode, point in MEASURED:
        of_point = [one for key, one in by_place.items() if key[:2] == (mode, point.name)]
        cells = {one.quantity: _cell(one) for one in of_point}
        if point.disturbed:
            disturbed.append((point.name, of_point[0].seed, *(cells.get(quantity, "") for quantity in QUANTITIES)))
        else:
            usual = (cells.get(quantity, "") for quantity in _usual(QUANTITIES))
            rows.append((point.name, mode.name, of_point[0].seed, *usual))
        longer = {one.time_s: _cell(one) for one in of_point if one.quantity == TAIL}
        if longer:
            tails.append((point.name, mode.name, *(longer.get(t, "") for t in _TAIL_TIMES_S)))
    lengths = [
        (mode.name, mode.short_runs, f"{BATCHES * mode.batch_s / 3600:.0f} hours", f"at least {events[mode]:,}")
        for mode in MODES
    ]
    return f"""## 8. The converter that runs

The framework's converter under a simulated clock, step by step on one thread and with a thread for each component (monitor,
queue, analyze, plan, execute and knowledge are the real ones) against a simulated device: Poisson arrivals, exponential
action times, and conversion times that are exponential or of phases. For each point there are many runs of at least 100 s from the empty system and a long one of {BATCHES}
batches:

{table(("mode", "short runs", "the long run", "events of a point"), lengths)}

Nothing is taken from the converter's own counters: the bench keeps a book of
the events that it lets arrive, and what never reaches the device is lost. With the same seed both modes give the same run
(`BenchTest`), so each has seeds of its own. Measured, 99 % confidence interval, and in brackets the model's value:

{table(("point", "mode", "seed", *_usual(QUANTITIES).values()), rows)}

The disturbed converter, step by step. A crash ends the process where it is; the next one begins with a copy of the journal as it was
at that moment. Left out is what the model has otherwise: without a journal, losses until 100 s (a crash loses what came before it, so
the bench's book has them earlier), and what becomes of an event that was decided before somebody operated the device.
{_parameters()}

{table(("point", "seed", *QUANTITIES.values()), disturbed)}

How long events wait tells how the queue is ordered, which means do not: one that serves the last event first has the same mean.
The share of events that wait longer than a time, where the model has one event's way (all whole seconds up to 10 are compared;
here are some):

{table(("point", "mode", *(f"longer than {t} s" for t in _TAIL_TIMES_S)), tails)}

What is too rare for an interval to mean much is left out: fewer than 100 losses, or fewer than 1,000 of the waits, to be
expected.

{_verdict(comparisons)}

![Models and measurements](experiment.png)"""


def _usual(quantities: dict[str, str]) -> dict[str, str]:
    """The quantities that undisturbed points have."""
    return {name: text for name, text in quantities.items() if name not in ("handed", "differs")}


def _parameters() -> str:
    told = (
        f"*{point.name}*: " + ", ".join(f"{name}={value:g}" for name, value in point.constants.items())
        for point in POINTS
        if point.disturbed
    )
    return "; ".join(told) + "."


def _verdict(comparisons: list[Comparison]) -> str:
    missed = [one for one in comparisons if not one.holds()]
    failed = failures(comparisons)
    text = f"""**The rule.** {len(comparisons) - len(missed)} of {len(comparisons)} intervals hold the model's value{"; those in bold do not" if missed else ""}. Of intervals at 99 % one
in a hundred misses by chance, so a single miss is no failure. `./evoloop study --experiment` fails if a value lies outside an
interval so much wider that all {len(comparisons)} together miss one by chance in 1 % of all runs at most, however they depend on each other
(Bonferroni: each at {100 * (1 - 0.01 / len(comparisons)):.3f} %, four standard errors instead of 2.6). {_number(len(failed))}."""
    return text + (" Beyond chance: " + "; ".join(str(one) for one in failed) + "." if failed else "")


def _number(failed: int) -> str:
    return f"**{failed}** lie outside" if failed else "None lies outside"


def _cell(one: Comparison) -> str:
    model = "never" if one.model == float("inf") else f"{one.model:.4g}"
    text = f"{one.measured} ({model})"
    return text if one.holds() else f"**{text}**"
