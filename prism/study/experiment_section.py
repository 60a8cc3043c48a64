"""The section of the report on the running converter."""

from study.comparing import Comparison, failures
from study.markdown import table
from study.points import BATCHES, MEASURED, MODES, POINTS, Mode
from study.predictions import QUANTITIES, TAIL

_TAIL_TIMES_S = (1, 2, 4, 6, 8)


def experiment(comparisons: list[Comparison], events: dict[Mode, int]) -> str:
    if not comparisons:
        return """## 8. The running converter

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
    return f"""## 8. The running converter

The framework's converter under a simulated clock, step by step on one thread and with a thread for each component (monitor,
queue, analyze, plan, execute and knowledge are the real ones), against a simulated device: Poisson arrivals, exponential
action times, and conversion times that are exponential or have phases. For each point there are many runs of at least 100 s
from the empty system and a long one of {BATCHES} batches:

{table(("mode", "short runs", "the long run", "events of a point"), lengths)}

The converter's own counters are not used: the bench records the events that it generates, and an event that
never reaches the device is lost. With the same seed both modes give the same run
(`BenchTest`), so each has its own seeds. Measured values with 99 % confidence intervals, and the model's value in brackets:

{table(("point", "mode", "seed", *_usual(QUANTITIES).values()), rows)}

The converter with disturbances, step by step. A crash ends the process at that point; the next one starts with a copy of the
journal as it was at that moment. Quantities that the model defines differently are left out: without a journal, losses until 100 s
(a crash loses events that arrived before it, so the bench records them earlier), and the outcome of an event that was decided before the
device was operated manually.
{_parameters()}

{table(("point", "seed", *QUANTITIES.values()), disturbed)}

The distribution of waiting times shows the order of the queue; the mean does not, since serving the last event first gives the same
mean. The share of events that wait longer than a given time, if the model follows single events (all whole seconds up to 10 are
compared; here are some):

{table(("point", "mode", *(f"longer than {t} s" for t in _TAIL_TIMES_S)), tails)}

Values that are too rare for a meaningful interval are left out: fewer than 100 expected losses, or fewer than 1,000 expected
waits.

{_verdict(comparisons)}

![Models and measurements](experiment.svg)"""


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
    text = f"""**The rule.** {len(comparisons) - len(missed)} of {len(comparisons)} intervals contain the model's value{"; those in bold do not" if missed else ""}. One in
a hundred 99 % intervals misses by chance, so a single miss is not a failure. `./evoloop study --experiment` fails if a value lies
outside a wider interval, chosen so that at most 1 % of all runs have a miss by chance among all {len(comparisons)}, however they
depend on each other (Bonferroni: each at {100 * (1 - 0.01 / len(comparisons)):.3f} %, four standard errors instead of 2.6). {_number(len(failed))}."""
    return text + (" Beyond chance: " + "; ".join(str(one) for one in failed) + "." if failed else "")


def _number(failed: int) -> str:
    return f"**{failed}** lie outside" if failed else "None lies outside"


def _cell(one: Comparison) -> str:
    model = "never" if one.model == float("inf") else f"{one.model:.4g}"
    text = f"{one.measured} ({model})"
    return text if one.holds() else f"**{text}**"
