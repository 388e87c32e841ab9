"""Many balls or contacts over time as an image, where curves would cover each other."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np

from . import _core
from ._curves import Curves, Window, within
from ._events import Event
from ._figure import inside, label_axes, tick_events
from ._numbers import Array

_CELLS = 250  # along the time, about a pixel of the screen
_DECADES = 1e-4
_TICKS = 16


def draw_image(axes: Sequence[Any], windows: Sequence[Window], curves: Curves, along: str, events: Sequence[Event],
               logarithmic: bool) -> None:
    """Colours of even lightness, a row per ball or contact, from 1."""
    least, most = _range(curves, windows)
    factor, unit = _core.display([least, most], curves.unit)
    scale, time_unit = _core.display([windows[-1][1]], "s")
    norm = _norm(factor * least, factor * most, logarithmic)
    for ax, (start, end) in zip(axes, windows):
        cells = factor * _pooled(curves, start, end)
        count = cells.shape[1]
        image = ax.imshow((np.abs(cells) if logarithmic else cells).T, aspect="auto", origin="lower", norm=norm,
                          extent=(scale * start, scale * end, 0.5, count + 0.5), interpolation="nearest")
        _number_lines(ax, curves.numbers)
        tick_events(ax, inside((start, end), events), scale)
    bar = f"|{curves.quantity}|" if logarithmic else curves.quantity
    beside = axes[-1].figure.colorbar(image, ax=axes[-1], label=f"{bar} [{unit}]")
    if not logarithmic:
        beside.formatter.set_useOffset(False)
    label_axes(axes, f"time t [{time_unit}]", along)


def _number_lines(ax: Any, numbers: Optional[Sequence[int]]) -> None:
    if numbers is None:
        ax.yaxis.get_major_locator().set_params(integer=True)
        return
    step = -(-len(numbers) // _TICKS)
    ax.set_yticks(range(1, len(numbers) + 1, step), [str(number) for number in numbers[::step]])


def _range(curves: Curves, windows: Sequence[Window]) -> Window:
    """Of what is shown, from zero unless all is far from it."""
    values = curves.values[within(curves, windows)]
    least, most = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    height = most - least
    return (0.0 if 0 < least < height else least), (0.0 if 0 < -most < height else most)


def _norm(least: float, most: float, logarithmic: bool) -> Any:
    from matplotlib.colors import LogNorm, Normalize  # type: ignore[import]

    largest = max(-least, most)
    if logarithmic:
        return LogNorm(_DECADES * largest, largest, clip=True)
    return Normalize(least, most if most > least else least + 1)


def _pooled(curves: Curves, start: float, end: float) -> Array:
    """Of all values within a cell the one of the greatest magnitude, so that no thin pulse falls between cells."""
    edges = np.linspace(start, end, _CELLS + 1)
    middle = 0.5 * (edges[1:] + edges[:-1])
    cells = np.stack([np.interp(middle, curves.time, one) for one in curves.values.T], axis=1)
    shown = (curves.time >= start) & (curves.time < end)
    place = np.searchsorted(edges, curves.time[shown], side="right") - 1
    highest, lowest = cells.copy(), cells.copy()
    np.maximum.at(highest, place, curves.values[shown])
    np.minimum.at(lowest, place, curves.values[shown])
    return np.where(highest > -lowest, highest, lowest)
