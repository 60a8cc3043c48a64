"""The plots, as PNG and SVG, readable in grey."""

from collections.abc import Iterable
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from study import devices, sensitivity
from study.curves import Curves
from study.experiment import Measurements
from study.paper import CAPACITIES, CONVERSIONS_S, HORIZON_S, TIMES_S
from study.points import MODES, POINTS, Mode, Point
from study.predictions import TAIL, Predictions
from study.tables import Table
from study.waiting import LONGEST_S

_CONVERSION_S = 0.25
_BASELINE = {"color": "black", "linewidth": 2.2, "linestyle": "-"}
# Distinguishable by marker and dash without colour; the colours differ in brightness, too.
_STYLES = (
    {"color": "#08306b", "linestyle": "--", "marker": "o"},
    {"color": "#a63603", "linestyle": "-.", "marker": "s"},
    {"color": "#238b45", "linestyle": ":", "marker": "^"},
    {"color": "#8c6bb1", "linestyle": (0, (6, 1)), "marker": "D"},
    {"color": "#969696", "linestyle": (0, (1, 1)), "marker": "v"},
)
_TIME = "time T in s"
_DONE = "probability that the task is done"
_LOST = "events lost until T"


def draw(folder: Path, curves: Curves, tables: dict[str, Table]) -> None:
    """Draws everything that does not need the experiment."""
    _save(_paper(curves), folder, "paper")
    _save(_performance(curves), folder, "performance")
    _save(_losses(curves), folder, "losses")
    _save(_waiting(tables["waiting"], tables["waiting-longer"]), folder, "waiting")
    _save(_devices(tables["path"], tables["holdoff"]), folder, "devices")
    _save(_sensitivity(tables["sensitivity"]), folder, "sensitivity")


def draw_experiment(folder: Path, measurements: Measurements, predictions: Predictions) -> None:
    _save(_experiment(measurements, predictions), folder, "experiment")


def _save(figure: Figure, folder: Path, name: str) -> None:
    # Without these, the same results would give a different file each time.
    with pyplot.rc_context({"svg.hashsalt": "evoloop"}):
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
    pyplot.close(figure)


def _panels(number: int, share_y: bool = False) -> tuple[Figure, list[Axes]]:
    figure, axes = pyplot.subplots(
        1, number, figsize=(5.2 * number, 4.4), sharey=share_y, squeeze=False, layout="constrained"
    )
    return figure, list(axes[0])


def _finish(axes: Axes, title: str, x: str, y: str) -> None:
    axes.set_title(title)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(True, color="0.88", linewidth=0.6)
    axes.legend(fontsize="small")


def _line(axes: Axes, xs: Iterable[float], ys: Iterable[float], style: dict[str, object], label: str) -> None:
    axes.plot(list(xs), list(ys), markersize=4, markevery=2, label=label, **style)


def _by_conversion(axes: Axes, curves: Curves, model: str, quantity: str) -> None:
    value = getattr(curves, quantity)
    axes.plot(TIMES_S, [value("baseline", t) for t in TIMES_S], label="baseline", **_BASELINE)
    for conversion, style in zip(CONVERSIONS_S, _STYLES, strict=False):
        ys = [value(model, t, conversion=conversion) for t in TIMES_S]
        _line(axes, TIMES_S, ys, style, f"converter = {conversion:g} s")


def _by_capacity(axes: Axes, curves: Curves, quantity: str) -> None:
    value = getattr(curves, quantity)
    axes.plot(TIMES_S, [value("baseline", t) for t in TIMES_S], label="baseline", **_BASELINE)
    for capacity, style in zip(CAPACITIES, _STYLES, strict=True):
        ys = [value("fifo-pipelined", t, conversion=_CONVERSION_S, K=capacity) for t in TIMES_S]
        _line(axes, TIMES_S, ys, style, f"K = {capacity}")


def _paper(curves: Curves) -> Figure:
    figure, (left, right) = _panels(2)
    _by_conversion(left, curves, "listing", "probability")
    _finish(left, "The paper's performance figure", _TIME, _DONE)
    _by_conversion(right, curves, "listing", "lost")
    _finish(right, "The paper's figure of lost events (as listed)", _TIME, _LOST)
    return figure


def _performance(curves: Curves) -> Figure:
    figure, (left, right) = _panels(2, share_y=True)
    _by_conversion(left, curves, "listing", "probability")
    _finish(left, "The paper's mechanism", _TIME, _DONE)
    _by_capacity(right, curves, "probability")
    _finish(right, f"Evoloop's converter, conversion {_CONVERSION_S} s", _TIME, _DONE)
    return figure


def _losses(curves: Curves) -> Figure:
    figure, (left, middle, right) = _panels(3, share_y=True)
    _by_conversion(left, curves, "listing", "lost")
    _finish(left, "The paper's mechanism, as listed", _TIME, _LOST)
    _by_conversion(middle, curves, "exact", "lost")
    _finish(middle, "The paper's mechanism, each loss counted once", _TIME, _LOST)
    _by_capacity(right, curves, "lost")
    _finish(right, f"Evoloop's converter, conversion {_CONVERSION_S} s", _TIME, _LOST)
    return figure


def _waiting(means: Table, longer: Table) -> Figure:
    figure, (left, right) = _panels(2)
    for conversion, style in zip(CONVERSIONS_S, _STYLES, strict=False):
        ys = [row[3] for row in means.rows if row[:2] == ("fifo-pipelined", conversion)]
        left.plot(CAPACITIES, ys, markersize=5, label=f"conversion {conversion:g} s", **style)
    left.set_xscale("log", base=2)
    left.set_xticks(CAPACITIES, [str(capacity) for capacity in CAPACITIES])
    _finish(left, "Mean waiting time", "K, events the converter can hold", "mean wait in s")
    for capacity, style in zip(CAPACITIES, _STYLES, strict=True):
        rows = [row for row in longer.rows if row[:3] == ("fifo-pipelined", _CONVERSION_S, capacity)]
        right.plot([row[3] for row in rows], [row[4] for row in rows], markersize=4, label=f"K = {capacity}", **style)
    right.set_yscale("log")
    right.set_ylim(1e-4, 1.2)
    _finish(right, f"Conversion {_CONVERSION_S} s", "t in s", "probability of waiting longer than t")
    return figure


def _devices(path: Table, holdoff: Table) -> Figure:
    figure, (left, right) = _panels(2)
    for device, style in zip(devices.PATHS, _STYLES, strict=False):
        rows = [row for row in path.rows if row[0] == device]
        left.plot([row[3] for row in rows], [row[4] for row in rows], markersize=5, label=device, **style)
    left.set_xscale("log", base=2)
    left.set_xticks(CAPACITIES, [str(capacity) for capacity in CAPACITIES])
    title = "Two events for one decision"
    _finish(left, title, "K, events the converter can hold", f"events lost until {HORIZON_S} s")
    xs = [row[0] for row in holdoff.rows]
    in_device = [HORIZON_S * row[5] for row in holdoff.rows]
    in_all = [HORIZON_S * row[4] for row in holdoff.rows]
    _line(right, xs, in_all, _STYLES[0], "all")
    _line(right, xs, in_device, _STYLES[1], "in the device, which was not ready")
    _line(right, xs, [a - d for a, d in zip(in_all, in_device, strict=True)], _STYLES[2], "in the full converter")
    right.axhline(HORIZON_S / 6, label="baseline", **_BASELINE)
    right.set_ylim(bottom=0)
    title = f"Readiness inferred by a hold-off, K = {devices.CAPACITY}"
    _finish(right, title, "hold-off in s (mean action time: 1 s)", "events lost per 100 s, in the long run")
    return figure


_HEAT_TITLES = {
    "exact": "The paper's mechanism",
    "fifo-serial": "Queue of 8, serial",
    "fifo-pipelined": "Queue of 8, pipelined (Evoloop)",
}


def _sensitivity(table: Table) -> Figure:
    figure, panels = _panels(3, share_y=True)
    xs, ys = sensitivity.ARRIVALS_PER_S, sensitivity.CONVERSIONS_S
    image = None
    for axes, model in zip(panels, sensitivity.MECHANISMS, strict=True):
        ratio = {(row[2], row[3]): row[5] for row in table.rows if row[0] == model}
        grid = [[ratio[x, y] for x in xs] for y in ys]
        image = axes.pcolormesh(xs, ys, grid, cmap="Greys", vmin=0, vmax=2, shading="nearest")
        lines = axes.contour(xs, ys, grid, levels=[0.1, 0.5, 0.9, 1.0], colors=["0.35", "0.45", "0.55", "black"])
        lines.set_linewidth([1, 1, 1, 2.2])
        axes.clabel(lines, fmt="%g", fontsize="small")
        axes.plot([0.5] * len(CONVERSIONS_S), CONVERSIONS_S, "k+", markersize=8, label="the paper's parameters")
        _finish(axes, _HEAT_TITLES[model], "arrivals per s", "mean conversion time in s")
        axes.grid(False)
    figure.colorbar(image, ax=panels, label="events lost until 100 s, as a multiple of the baseline's")
    return figure


def _experiment(measurements: Measurements, predictions: Predictions) -> Figure:
    figure, (left, middle, right) = _panels(3)
    for point, style in zip(plain_points(), _STYLES, strict=True):
        waits = {t: share for t in range(LONGEST_S + 1) if (share := predictions.longer(point, t)) is not None}
        for axes, quantity, model in (
            (left, "lost", {t: predictions.lost(point, t) for t in TIMES_S}),
            (middle, "done", {t: predictions.done(point, t) for t in TIMES_S}),
            (right, TAIL, waits),
        ):
            axes.plot(model.keys(), model.values(), color=style["color"], linestyle=style["linestyle"], linewidth=1)
            for mode in MODES:
                _measured(axes, measurements, mode, point, quantity, list(model)[1:], style)
    right.set_yscale("log")
    right.set_ylim(1e-4, 1.2)
    _finish(left, "Losses", _TIME, _LOST)
    _finish(middle, "Completion", _TIME, _DONE)
    _finish(right, "Waiting, in the long run", "t in s", "probability of waiting longer than t")
    figure.suptitle(
        "The models (lines) and the running converter (marks, 99 % confidence intervals;"
        " full: step by step, empty: with threads)"
    )
    return figure


def plain_points() -> list[Point]:
    """The points that differ only in their queue."""
    return [point for point in POINTS if set(point.constants) <= {"conversion", "K"} and _is_plain(point)]


def _is_plain(point: Point) -> bool:
    return point.parameter("conversion", 0) == _CONVERSION_S and point.mechanism in ("unbuffered", "pipelined")


def _measured(
    axes: Axes,
    measurements: Measurements,
    mode: Mode,
    point: Point,
    quantity: str,
    times: list[int],
    style: dict[str, object],
) -> None:
    estimates = [measurements.estimate(mode, point, quantity, t) for t in times]
    in_threads = mode.name == "threads"
    axes.errorbar(
        times,
        [one.mean for one in estimates],
        yerr=[one.half_width() for one in estimates],
        color=style["color"],
        marker=style["marker"],
        markerfacecolor="none" if in_threads else style["color"],
        linestyle="none",
        markersize=6 if in_threads else 3,
        capsize=2,
        label=None if in_threads else point.name,
    )
