"""Figures over time as the command draws them: panels without long flights, shaded phases, named curves."""

from __future__ import annotations

from typing import Any, List, Sequence, Tuple

from . import _core
from ._curves import Curves, Window, coincident, line_style, value_range
from ._events import Event
from ._labels import name_curves, write_words

_SHADES = ("#f1f4f8", "#e6ecf3", "#dce4ee")  # of one, two, three and more contacts
_MOST_EVENTS = 24  # more would hide the curves
_FAR = 400  # lengths of a panel between it and the start of the run
_LONG_NUMBERS = 20  # the same, from where on numbers along its axis have so many digits that only some have room


def make_panels(ax: Any, windows: Sequence[Window], title: str) -> Tuple[List[Any], List[Window]]:
    """Axes of a new figure, one per window; or those given, which show all of them."""
    if ax is not None:
        ax.set_title(title)
        return [ax], [(windows[0][0], windows[-1][1])]
    import matplotlib.pyplot as plt  # type: ignore[import]

    lengths = [end - start for start, end in windows]
    shares = [max(length, 0.6 * max(lengths)) or 1.0 for length in lengths]
    figure, axes = plt.subplots(1, len(windows), sharey=True, squeeze=False, layout="constrained",
                                gridspec_kw={"width_ratios": shares})
    figure.suptitle(title) if len(windows) > 1 else axes[0, 0].set_title(title)
    for one in axes[0, 1:]:
        one.spines["left"].set_visible(False)
        one.tick_params(left=False)
    for one in axes[0]:
        one.spines[["top", "right"]].set_visible(False)
        one.locator_params(axis="x", nbins=_most_numbers(windows))
        one.tick_params(axis="x", labelsize="medium" if len(windows) == 1 else "x-small")
    return list(axes[0]), list(windows)


def _most_numbers(windows: Sequence[Window]) -> int:
    """Along the axis of each panel."""
    if len(windows) > 1:
        return 3
    (start, end), = windows
    return 4 if end > _LONG_NUMBERS * (end - start) else 9


def draw_curves(axes: Sequence[Any], windows: Sequence[Window], curves: Curves, events: Sequence[Event],
                note: str = "") -> None:
    """All curves in every panel, with marks of events, and a name for each group that lies on one line. The note stands
    behind the name of the time axis."""
    least, most = value_range(curves, windows)
    factor, unit = _core.display([least, most], curves.unit)
    scale, time_unit = _core.display([windows[-1][1]], "s")
    groups = coincident(curves.values)
    for ax, window in zip(axes, windows):
        for place, group in enumerate(groups):
            for k in group:
                ax.plot(scale * curves.time, factor * curves.values[:, k], label=curves.names[k], **line_style(place))
        ax.set_xlim(scale * window[0], scale * window[1])
        ax.set_ylim(factor * least, factor * most)
        _mark_events(ax, window, events, scale)
    name_curves(axes, windows, curves, groups, (least, most))
    if len(axes) > 1 and _are_far(windows):
        _count_from_events(axes, windows, events, scale, note)
        axes[0].set_ylabel(f"{curves.quantity} [{unit}]")
    else:
        label_axes(axes, f"time t [{time_unit}]{note}", f"{curves.quantity} [{unit}]")


def _are_far(windows: Sequence[Window]) -> bool:
    """Whether a panel is so short that all digits of its times would be the same but for the last."""
    return any(end > _FAR * (end - start) for start, end in windows)


def _count_from_events(axes: Sequence[Any], windows: Sequence[Window], events: Sequence[Event], scale: float,
                       note: str) -> None:
    """Numbers of each panel count from the first event that it shows, whose time stands below them."""
    from matplotlib import ticker  # type: ignore[attr-defined]

    factor, unit = _core.display([max(end - start for start, end in windows)], "s")
    for ax, (start, end) in zip(axes, windows):
        origin = next((event.time for event in inside((start, end), events)), start)
        low, high = factor * (start - origin), factor * (end - origin)
        steps = [step for step in ticker.MaxNLocator(3).tick_values(low, high) if low <= step <= high]
        ax.set_xticks([scale * (origin + step / factor) for step in steps], [f"{step:g}" for step in steps])
        own, own_unit = _core.display([origin], "s")
        ax.set_xlabel(f"$t_0$ = {own * origin:.6g} {own_unit}", fontsize="x-small")
    axes[0].figure.supxlabel(f"time $t - t_0$ [{unit}]{note}", fontsize="medium")


def label_axes(axes: Sequence[Any], x: str, y: str) -> None:
    """Names beside the first vertical axis and below the panel in the middle."""
    axes[0].set_ylabel(y)
    axes[len(axes) // 2].set_xlabel(x)


def tick_events(ax: Any, events: Sequence[Event], scale: float) -> None:
    """Ticks above the panel."""
    ax.vlines([scale * event.time for event in events], 1, 1.025, transform=ax.get_xaxis_transform(),
              color="#9aa5b1", linewidth=0.8, clip_on=False)
    ax.set_title(ax.get_title(), pad=10)


def inside(window: Window, events: Sequence[Event]) -> List[Event]:
    """Those that a panel shows."""
    return [event for event in events if window[0] <= event.time <= window[1]]


def _mark_events(ax: Any, window: Window, events: Sequence[Event], scale: float) -> None:
    """Shades where contacts are closed, a line and words at each event; ticks alone if there are many."""
    shown = inside(window, events)
    if len(shown) > _MOST_EVENTS:
        return tick_events(ax, shown, scale)
    closed = 0
    for event, end in zip(events, [*(one.time for one in events[1:]), window[1]]):
        closed += len(event.close) - len(event.open)
        if closed > 0 and event.time < window[1] and end > window[0]:
            ax.axvspan(scale * max(event.time, window[0]), scale * min(end, window[1]), linewidth=0, zorder=-1,
                       color=_SHADES[min(closed, len(_SHADES)) - 1])
    for event in shown:
        ax.axvline(scale * event.time, color="#9aa5b1", linewidth=0.8, linestyle=(0, (3, 3)), zorder=0)
    write_words(ax, window, shown)
