"""The sections of the report, for readers who have the paper."""

from study.closed_forms import unbuffered_lost_per_s
from study.curves import Curves
from study.devices import CAPACITY, PATHS
from study.markdown import table
from study.measured import CAPACITY as HELD, ROWS
from study.paper import CAPACITIES, CONVERSIONS_S, HORIZON_S
from study.tables import Cell, Table


def head(checker: str) -> str:
    return f"""# Performance and robustness

The results of `./evoloop study`, computed with {checker}. "The paper" is arXiv:2205.13375; the study is based on its Exp. 2:
a task of 19 actions (from state 1 to state 20), one event every 2 s, actions of 1 s, all times exponential. The models and
properties are in `prism/models`; every figure here comes from them and can be reproduced with one command. In short:

- The paper's figures can be reproduced from its listing.
- The listing counts less than half of the events that are lost in the device. Counted exactly, a converter that holds a
  single event and does not wait for the device loses more events than the device alone, at every conversion time.
- With a short queue and back-pressure, which Evoloop has, the paper's claim holds, and the task also ends earlier.
- This requires that the device reports when it is ready. A Roomba does not; its converter's 200 ms would be far too
  short for actions of 1 s, and nearly as many events would be lost as without a converter (section 4).
- When a process crashes, a journal saves the waiting events and the record of the device; a broken link costs time; changing to other
  models costs almost nothing (section 5).
- The running converter agrees with its model, with one thread and with several: losses, completion and waiting times; with one
  thread also under crashes, broken links and changes of models."""


def paper(curves: Curves) -> str:
    rows = [_paper_row("baseline (a)", curves, "baseline", {})]
    for conversion in CONVERSIONS_S:
        rows.append(_paper_row(f"listing (b), {conversion:g} s", curves, "listing", {"conversion": conversion}))
    largest = max(
        curves.probability("baseline", t) - curves.probability("listing", t, conversion=0.25) for t in range(0, 101, 5)
    )
    return f"""## 1. The paper's figures

![Probability that the task is done, and events lost](paper.svg)

{table(("model", "done at 60 s", "at 80 s", "at 100 s", "mean completion in s", "lost until 100 s"), rows)}

The paper shows model (a) only as a picture; `baseline.sm` is our reading of it. At 0.25 s the paper finds a performance
similar to the baseline's, and so do we: the task takes {_percent(curves, 0.25)} longer, and the curves differ by at
most {largest:.3f}. At 1 s it takes {_percent(curves, 1.0)} longer."""


def _percent(curves: Curves, conversion: float) -> str:
    ratio = curves.completion_s("listing", conversion=conversion) / curves.completion_s("baseline")
    return f"{100 * (ratio - 1):.1f} %"


def _paper_row(label: str, curves: Curves, model: str, constants: dict[str, float]) -> tuple[object, ...]:
    done = (f"{curves.probability(model, t, **constants):.4f}" for t in (60, 80, HORIZON_S))
    lost = f"{curves.lost(model, HORIZON_S, **constants):.4f}"
    return (label, *done, f"{curves.completion_s(model, **constants):.2f}", lost)


def counting(curves: Curves, tables: dict[str, Table], flagged: float) -> str:
    alone = curves.lost("baseline", HORIZON_S)
    even = {(row[0], row[1]): row[2] for row in tables["break-even"].rows}
    rows = [
        (f"{conversion:g} s", f"{listed:.2f}", f"{exact:.2f}", f"{100 * (exact / alone - 1):+.1f} %", f"{100 * share:.1f} %")
        for conversion, listed, exact, share in tables["counting"].rows
    ]
    return f"""## 2. Counted exactly

![Lost events as listed, counted exactly, and with a queue](losses.svg)

{table(("conversion", "lost, as listed", "lost, each once", "against the baseline", "device's losses that the listing counts"), rows)}

The baseline loses {alone:.4f} events in 100 s. The listing counts the converter's losses correctly. It counts the device's losses
in two steps: `[control]` raises the flag `lost`, and `[emb_lost]` counts the flag. This misses two kinds of
losses. `[process]` lowers the flag without counting it, and since `[emb_lost]` has no rate (so its rate is 1, like that of
`[process]`), it often comes first; and a second loss while the flag is up changes nothing. The last column shows the share of
the device's losses that is counted in the long run. The mistake is easy to make, because nothing in the model looks wrong:
only a second count reveals it. Counted the same way, the baseline would show {flagged:.2f} instead of {alone:.2f}.

`exact.sm` counts each loss once, on the transition that loses the event. The probabilities do not change, so the paper's
statement on performance stands. Its statement on robustness does not: the mechanism as listed has a second place where
events are lost and none where they are stored. In the long run it loses {100 * unbuffered_lost_per_s(0.25):.2f} events in
100 s at 0.25 s, compared with {100 / 6:.2f} for the device alone, and more than the device alone at any conversion time: with
rates a of arrivals, s of actions and c of conversions it performs c(c+a+s) / ((c+a)(c+s)) of the device's actions, which is below 1.

Break-even, the conversion time at which as many events are lost until 100 s as without a converter: {even["listing", None]:.3f} s
as listed (the paper: "faster than the action time", so 1 s), {even["exact", None]:.4f} s counted exactly. The latter is not zero
only because the event that is in the converter at 100 s is not lost yet."""


def converter(curves: Curves, tables: dict[str, Table]) -> str:
    even = {(row[0], row[1]): row[2] for row in tables["break-even"].rows}
    waits = {row[:3]: row[3] for row in tables["waiting"].rows}
    longer = {row[:4]: row[4] for row in tables["waiting-longer"].rows}
    losses, completions, waiting = [], [], []
    for kind in ("serial", "pipelined"):
        model = f"fifo-{kind}"
        for conversion in CONVERSIONS_S:
            given = [{"conversion": conversion, "K": capacity} for capacity in CAPACITIES]
            label = f"{kind}, {conversion:g} s"
            losses.append((label, *(curves.lost(model, HORIZON_S, **one) for one in given)))
            completions.append((label, *(curves.completion_s(model, **one) for one in given)))
            waiting.append((label, *(waits[model, conversion, capacity] for capacity in CAPACITIES)))
        losses.append((f"{kind}, break-even in s", *(even[model, capacity] for capacity in CAPACITIES)))
    columns = ("converter", *(f"K={capacity}" for capacity in CAPACITIES))
    tails = [
        (f"longer than {t} s", *(longer["fifo-pipelined", 0.25, capacity, t] for capacity in CAPACITIES))
        for t in (1, 2, 5, 10)
    ]
    beliefs = [
        (f"unbuffered, {row[1]:g} s", row[3], *(f"{100 * cell:.4g} %" for cell in row[4:]))
        for row in tables["belief"].rows
        if row[0] == "exact"
    ]
    queued = [row for row in tables["belief"].rows if row[0] != "exact"]
    never = all(row[3] == float("inf") and not any(row[4:]) for row in queued)
    beliefs.append((f"queue with back-pressure, all {len(queued)}", "never" if never else "**some do**", *["0 %"] * 4))
    return f"""## 3. A queue with back-pressure

![Probability that the task is done](performance.svg)

K is the number of events that the converter can hold, including the one in conversion (Evoloop's default is 9). *Serial*: it
converts the next event when the device is ready. *Pipelined*, as in Evoloop: it converts while the device still acts, and hands
the event over as soon as the device is ready. Events lost until 100 s (baseline: {curves.lost("baseline", HORIZON_S):.2f}):

{table(columns, losses)}

Mean completion time in s (baseline: {curves.completion_s("baseline"):.2f}; with a stored event, the next action need not
wait for a new event):

{table(columns, completions)}

The price is that events wait, from their arrival until they are handed over. Mean waiting time in s, in the long run:

{table(columns, waiting)}

The probability of waiting, pipelined, conversion 0.25 s:

{table(("", *columns[1:]), tails)}

![Waiting times](waiting.svg)

**Belief.** A converter without back-pressure assumes that each event it sends is carried out. If the device was not
ready, the converter's model and the device diverge; the faster the converter, the sooner. In the models, belief and device
change by different actions, and the device does not wait for the converter; only the converter's waiting for the device
keeps them equal. With back-pressure they never diverge. Mean time to the first divergence in s, and the
probability of a divergence by various times:

{table(("converter", "mean", "5 s", "10 s", "20 s", "100 s"), beliefs)}"""


def devices(curves: Curves, tables: dict[str, Table]) -> str:
    paths = []
    for device in PATHS:
        rows = [row for row in tables["path"].rows if row[0] == device]
        paths.append((device, *(row[4] for row in rows), rows[-2][5], rows[-2][7]))
    best = min(tables["holdoff"].rows, key=lambda row: row[4])
    shown = [row for row in tables["holdoff"].rows if row[0] in (0.2, 1.0, best[0], 3.0, 4.0)]
    holdoffs = [(f"{row[0]:g} s", row[2], 100 * row[4], 100 * row[5], row[3], row[6]) for row in shown]
    told = 100 * curves.lost_per_s("fifo-pipelined", conversion=0.25, K=CAPACITY)
    lost = tuple(f"lost, K={capacity}" for capacity in CAPACITIES)
    headings = ("hold-off", "lost until 100 s", "lost per 100 s", "of these in the device", "completion in s", "first difference after s")
    return f"""## 4. Devices that make it harder

![Two events for one decision, and readiness that is inferred](devices.svg)

**Two events for one decision.** Evoloop may have to send the device two events to reach the state that the new model requires;
the decided event leaves the converter with the last of them. Conversion 0.25 s, pipelined; events lost until 100 s,
and completion and mean waiting time at K=8:

{table(("device", *lost, "completion in s", "wait in s"), paths)}

If the two actions together take as long as the single one, the price is small: with a short queue slightly more events are lost,
because the event occupies its place until the end; from K=4 on fewer are lost, because two short actions vary less than one long
one. If each takes as long as the single one, the device is busy all the time at these arrivals and no queue can help; that is the
device's limit, not the converter's. Without back-pressure the second of two events would nearly always come too early.

**Readiness that is only inferred.** A Roomba does not report when it is ready for the next command; the converter waits for a
hold-off time after each. K={CAPACITY}, conversion 0.25 s; the hold-off is nearly constant (ten exponential phases):

{table(headings, holdoffs)}

Short hold-offs lose events in the device, long ones in the queue; the best of these is {best[0]:g} s, and it still loses
{100 * best[4]:.1f} events per 100 s, compared with {told:.2f} for a device that reports its readiness. Belief and device also diverge.
So query the device if possible; otherwise set a hold-off well above the mean action time. The Roomba converter waits 0.2 s: for a
device with the paper's actions of 1 s that would lose {100 * shown[0][4]:.1f} events in 100 s, nearly as many as without a converter. The
0.2 s cover the time in which a Roomba accepts a command, not the time in which it carries it out. Exponential action times, which have
no maximum, are the hard case: if no action takes longer than the hold-off, nothing is lost in the device."""


def sensitivity(found: Table) -> str:
    rows = []
    for model, label in (("exact", "paper's mechanism"), ("fifo-serial", "serial, K=8"), ("fifo-pipelined", "pipelined, K=8")):
        rows.append((label, *(_limit(found, model, arrivals) for arrivals in (0.5, 0.8, 1.0, 1.5, 2.0))))
    return f"""## 6. Other arrivals and conversion times

![Losses against the baseline's](sensitivity.svg)

On the heavy line a converter loses as many events until 100 s as the device alone. To the right of it and above it the
mechanism should not be used: the converter itself is the bottleneck. The longest of the checked conversion times (0.1 to 2 s)
at which the mechanism loses fewer events:

{table(("arrivals per s", "0.5", "0.8", "1", "1.5", "2"), rows)}

As a rule, for a long queue in the long run, with arrival rate a per s, conversion time c and actions of 1 s: serial pays off while
c < 1/a, that is, while a conversion takes less time than passes between two events; pipelined while c²/(1+c) < 1/a. (In 100 s
the limit is slightly higher, because events that are still in the queue are not lost.) If events arrive faster than the device
can act, a queue delays the losses and keeps the device busy, but it is full most of the time: each event then waits
for K actions. A converter for such a device should drop old events instead; none of these models does."""


def _limit(found: Table, model: str, arrivals: float) -> str:
    pays = [row[3] for row in found.rows if row[0] == model and row[2] == arrivals and row[5] < 1]
    return f"{max(pays):g} s" if pays else "none"


def code() -> str:
    rows = [
        ("`Converter`, `[arrived]`", "`PushMonitor` and every other `Monitor`, `MapeLoop.offer`", "a monitor reports an event; `event_arrive` is the controller's"),
        ("`waiting`, `K`", "`Sequencer`'s queue and the event in the loop, `LoopConfig.queueCapacity`", "K = queueCapacity + 1: the event in the loop has left the queue. Default: 8 + 1"),
        ("`[conv_lost]`, reward `lost`", "`Sequencer.offer`, `QueueStatus.dropped`", "a full queue loses arriving events, and counts them"),
        ("`[hold]`, `[control]` at `conv_internal_process`", "`EventAnalyze`, `EventPlan`", "one event at a time is converted, also while the device acts"),
        ("`converted`, `[next]`", "`EventExecute.awaitReady`", "back-pressure: a converted event waits for the device, and so does the queue"),
        ("`hold` in `holdoff.sm`", "an `awaitReady` that waits for a fixed time, like the Roomba's", "readiness is inferred"),
        ("`steps`, `sent` in `path.sm`", "`Conversion`, `PathPlanner`", "the steps of one decision, one after the other"),
        ("`believed`, `parted`", "`StateKnowledge.getOriginalState`", "changes with each event that is sent; whether the device will be in another state"),
        ("`[crash]`, `journal` in `crash.sm`", "`Journal`, `SystemEventConverter.journal`", "the next process continues with the waiting events"),
        ("`[gone]`, `[found]` in `sight.sm`", "an `awaitReady` that waits for the link, `EventMonitor.foundIn`", "the record follows the device's reported state"),
        ("`Models` in `swap.sm`", "`SystemEventConverter.evolve`", "between two events; arriving events wait"),
        ("`EmbeddedSystem`, `actual`", "the device", "`emb_internal_process` is the device's"),
        ("`arrived` in `exact.sm`", "`queueCapacity` 0 and an `awaitReady` that returns at once", "the paper's mechanism, as the framework would run it"),
    ]
    return f"""## 7. Modules of the models and classes of the code

{table(("model", "code", "meaning"), rows)}"""


def measured(curves: Curves, tables: dict[str, Table]) -> str:
    found, spread = tables.get("measured"), tables.get("measured-phases")
    if found is None or spread is None:
        return """## 9. Today's converter

Not measured yet; `./evoloop study --measured` takes the conversion times from `benchmarks/results`."""
    run, times = found.rows[0][1], {row[0]: row[2] for row in found.rows}
    labels = {"exact": "paper's mechanism", "fifo-serial": "serial", "fifo-pipelined": "pipelined (Evoloop)"}
    rows = [
        (f"{1e6 * row[2]:.1f} µs", f"{labels[row[3]]}{f', K={row[4]}' if row[4] else ''}", row[5], 100 * row[6], row[7])
        for row in found.rows
    ]
    ours = found.rows[-1]
    measurements = "\n".join(f"- {1e6 * time:.1f} µs: {row}; {ROWS[row]}" for row, time in times.items())
    return f"""## 9. Today's converter

The conversion time measured by the benchmarks ({run}) replaces the paper's 0.25 s:

{measurements}

{table(("conversion", "converter", "completion in s", "lost per 100 s, in the long run", "mean wait in s"), rows)}

The paper asks whether event conversion is sufficiently faster than the action time of the embedded system. It is, by a
factor of {1 / max(times.values()):,.0f} at least. Conversion has no noticeable cost: with the paper's mechanism the task takes as
long and as many events are lost as without a converter. The queue makes the difference: the converter with its
default settings loses {100 * ours[6]:.2g} events in 100 s, in the long run, instead of {100 * curves.lost_per_s("baseline"):.2f}
and finishes the task after {ours[5]:.1f} s instead of {curves.completion_s("baseline"):.0f}, if the device reports when it is ready.

{_spread(spread)}"""


def _spread(found: Table) -> str:
    shapes, rows = {}, []
    by_key = {(row[0], row[8], row[9]): row for row in found.rows}
    for (label, mean, distribution), row in by_key.items():
        shapes.setdefault(label, (label, f"{1e6 * row[1]:.1f} µs", f"{1e6 * row[2]:.1f} µs", _shape(row), row[7]))
        if distribution == "phases":
            exponential = by_key[label, mean, "exponential"]
            rows.append((
                label,
                f"{1e6 * mean:.1f} µs" if mean < 0.01 else f"{mean:g} s",
                *(f"{row[column]:.5g} ({_change(row[column], exponential[column])})" for column in (10, 11, 12)),
            ))
    return f"""**Variation.** Measured times are not exponential. `phases.sm` has conversions of several exponential phases (a Coxian
distribution), fitted to the median and the 99th percentile from the benchmarks: if times vary less than exponential ones,
phases of equal length; if they vary more, one conversion in ten has another, longer phase. Variation is variance divided by squared
mean; it is 1 for exponential times and 0 for constant ones.

{table(("measured", "median", "99th percentile", "phases", "variation"), shapes.values())}

In the long run, K={HELD}, with the difference from exponential times of the same mean in brackets; also for slower converters whose
times vary in the same way:

{table(("spread of", "mean", "completion in s", "lost per s", "mean wait in s"), rows)}

At today's times their variation makes no difference. In a converter that is as slow as the device it does: rare long conversions fill
the queue."""


def _change(value: float, from_value: float) -> str:
    percent = 100 * (value / from_value - 1)
    return f"{percent:+.1f} %" if abs(percent) >= 0.1 else "under 0.1 %"


def _shape(row: tuple[Cell, ...]) -> str:
    _, _, _, phases, first, more, last, *_ = row
    return f"{phases} of {1e6 * first:.1f} µs; one more for {100 * more:.0f} %, of {1e6 * last:.1f} µs"


def files() -> str:
    rows = [
        ("`curves.csv`", "both of the paper's properties for every model and time"),
        ("`summary.csv`", "mean completion time and losses per s in the long run"),
        ("`counting.csv`, `break-even.csv`", "section 2 and the break-even conversion times"),
        ("`waiting.csv`, `waiting-longer.csv`, `belief.csv`", "section 3"),
        ("`path.csv`, `holdoff.csv`", "section 4"),
        ("`sensitivity.csv`", "section 6"),
        ("`crash.csv`, `sight.csv`, `swap.csv`", "section 5"),
        ("`experiment-measured.csv`, `experiment.csv`", "section 8: the measurements, alone and compared with the models"),
        ("`measured.csv`, `measured-phases.csv`", "section 9"),
        ("`proof.csv`, `proof-mutants.csv`, `proof-paper.csv`, `proof-conformance.csv`, `proof/*.svg`", "section 10"),
    ]
    return f"""## Files

{table(("file", "content"), rows)}

Each plot is available as PNG and as SVG."""
