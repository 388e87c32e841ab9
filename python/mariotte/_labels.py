"""Words of a figure over time: what happens at events, and what curves are called."""

from __future__ import annotations

import re
from typing import Any, List, Sequence, Tuple

import numpy as np

from . import _core
from ._curves import INVISIBLE, Curves, Window, line_style, within
from ._events import Event
from ._style import text_size

_SMALL = 0.8  # words of events beside other text
_LINE = 0.072  # height of a name, as part of that of a panel
_LEADER = "#9aa5b1"  # grey, unlike data


def write_words(ax: Any, window: Window, events: Sequence[Event]) -> None:
    """What happens, in two rows above the panel, where there is room."""
    texts = [_words(event) for event in events]
    size = text_size(_SMALL)
    widths = [_width(ax, len(text) + 3, size) for text in texts]  # names of curves may make panels narrower
    at = [min((event.time - window[0]) / (window[1] - window[0]), 1.05 - 0.5 * width)
          for event, width in zip(events, widths)]
    rows = _core.rows_of_words(at, widths, 2)
    for text, x, row in zip(texts, at, rows):
        if row >= 0:
            ax.annotate(text, (x, 1), xycoords="axes fraction", xytext=(0, 2 + 1.3 * size * row),
                        textcoords="offset points", size=size, color="#3b4550", ha="center", annotation_clip=False)
    if max(rows, default=-1) >= 0 and ax.get_title():
        ax.set_title(ax.get_title(), pad=5 + 1.3 * size * (1 + max(rows)))


def _words(event: Event) -> str:
    """As "1–2 close", or "3 closes, 1 opens"."""
    verbs = ((event.close, "close"), (event.open, "open"), (event.yields, "yield"), (event.unload, "unload"))
    return ", ".join(f"{_ranges(places)} {verb}{'' if len(places) > 1 else 's'}" for places, verb in verbs if places)


def _ranges(places: Sequence[int]) -> str:
    """As "1–4, 6" of places from 0."""
    runs: List[List[int]] = []
    for number in (place + 1 for place in places):
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return ", ".join(f"{run[0]}–{run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)


def _width(ax: Any, letters: int, size: float) -> float:
    """Of a text, as part of the width of a panel, before the figure is laid out."""
    place = ax.get_subplotspec()
    shares = place.get_gridspec().get_width_ratios() if place else [1.0]
    own = float(shares[place.colspan.start] / sum(shares)) if place else 1.0
    return 0.55 * size * letters / (0.8 * 72 * float(ax.figure.get_figwidth()) * own)


def name_curves(axes: Sequence[Any], windows: Sequence[Window], curves: Curves, groups: List[List[int]],
                span: Tuple[float, float]) -> None:
    """Names above the peaks, or beside the right ends of curves that have none."""
    height = span[1] - span[0]
    flat = [place for place, group in enumerate(groups)
            if not curves.at_peak or np.abs(curves.values[:, group[0]]).max(initial=0) < INVISIBLE * height]
    _name_ends(axes[-1], windows[-1][1], curves, [(place, groups[place]) for place in flat], span)
    for ax, window in zip(axes, windows):
        named = [(place, group) for place, group in enumerate(groups) if place not in flat]
        _name_peaks(ax, window, windows, curves, named, span)


def _names(curves: Curves, group: List[int]) -> List[str]:
    names = [curves.names[k] for k in group]
    return names if len(names) <= 3 else [*names[:2], f"and {len(names) - 2} more"]


def _name_ends(ax: Any, end: float, curves: Curves, named: List[Tuple[int, List[int]]],
               span: Tuple[float, float]) -> None:
    wanted = [(float(np.interp(end, curves.time, curves.values[:, group[0]])) - span[0]) / (span[1] - span[0])
              for _, group in named]
    places = _core.spread(wanted, [_LINE * len(_names(curves, group)) for _, group in named])
    for (place, group), at, beside in zip(named, wanted, places):
        ax.annotate("\n".join(_names(curves, group)), xy=(1, at), xytext=(1.05, beside), xycoords="axes fraction",
                    color=line_style(place)["color"], va="center", annotation_clip=False,
                    arrowprops={"arrowstyle": "-", "color": _LEADER, "linewidth": 0.7, "shrinkA": 1, "shrinkB": 0,
                                "relpos": (0, 0.5)})


def _name_peaks(ax: Any, window: Window, windows: Sequence[Window], curves: Curves,
                named: List[Tuple[int, List[int]]], span: Tuple[float, float]) -> None:
    """In the first panel, and in the one that has the highest peak."""
    shown, seen = within(curves, [window]), within(curves, windows)
    taken: List[Tuple[float, float, float, float]] = []
    for place, group in named:
        sizes = np.abs(curves.values[:, group[0]])
        here = int(np.argmax(np.where(shown, sizes, -1)))
        if sizes[here] < INVISIBLE * (span[1] - span[0]) or not shown[here]:
            continue
        if window != windows[0] and here != int(np.argmax(np.where(seen, sizes, -1))):
            continue
        text = ", ".join(_names(curves, group))
        width = _width(ax, len(re.sub(r"[$_{}]", "", text)) + 1, text_size())
        x = (curves.time[here] - window[0]) / (window[1] - window[0])
        y = (curves.values[here, group[0]] - span[0]) / (span[1] - span[0])
        left = min(max(x - 0.5 * width, 0.0), max(0.0, 1 - width))
        taken.append(_core.free_place((left, y + (-1.2 * _LINE if curves.values[here, group[0]] < 0 else 0.02), width,
                                       _LINE), taken))
        ax.text(left + 0.5 * width, taken[-1][1] + 0.5 * _LINE, text, transform=ax.transAxes, ha="center", va="center",
                color=line_style(place)["color"])
