"""Curves over time: how they look, how far they reach, and which of them lie on each other."""

from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._numbers import Array

Window = Tuple[float, float]

# Okabe & Ito (2008) without their yellow; dashes have another period, so that 28 lines differ.
_COLOURS = ("#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_DASHES = ("-", (0, (6, 2)), (0, (1.5, 1.5)), (0, (6, 1.5, 1.5, 1.5)))
INVISIBLE = 0.004  # of the height of a figure


class Curves(NamedTuple):
    """What a figure over time shows."""

    quantity: str
    unit: str
    names: List[str]
    at_peak: bool  #: names stand above the peaks, else beside the right ends
    time: Array  #: of shape (T,) [s]
    values: Array  #: of shape (T, k) [SI]
    numbers: Optional[List[int]] = None  #: of the lines of an image; None: from 1


def chosen(curves: Curves, numbers: Sequence[int], width: int = 1) -> Curves:
    """The curves of these balls or contacts alone, `width` each; all where there are none of them."""
    known = curves.numbers or range(1, len(curves.names) // width + 1)
    place_of = {number: place for place, number in enumerate(known)}
    kept = [number for number in numbers if number in place_of]
    columns = [width * place_of[number] + k for number in kept for k in range(width)]
    if not columns:
        return curves
    return curves._replace(names=[curves.names[k] for k in columns], values=curves.values[:, columns], numbers=kept)


def line_style(place: int) -> Dict[str, Any]:
    """How the line of this number is drawn."""
    return {"color": _COLOURS[place % len(_COLOURS)], "linestyle": _DASHES[place % len(_DASHES)]}


def within(curves: Curves, windows: Sequence[Window]) -> Array:
    """Which times the windows show, of shape (T,)."""
    shown = np.zeros(len(curves.time), dtype=bool)
    for start, end in windows:
        shown |= (curves.time >= start) & (curves.time <= end)
    return shown


def value_range(curves: Curves, windows: Sequence[Window]) -> Tuple[float, float]:
    """Ends of the vertical axis [SI], with room for names."""
    seen = curves.values[within(curves, windows)]
    least, most = float(seen.min(initial=0)), float(seen.max(initial=0))
    if least == most:
        return least - 1, most + 1
    room = (0.12 if curves.at_peak else 0.04) * (most - least)
    below = room if least < -INVISIBLE * (most - least) else 0.012 * (most - least)
    return least - below, most + room


def coincident(values: Array) -> List[List[int]]:
    """Curves that cannot be told apart, in groups."""
    height = float(np.ptp(np.append(values, 0)))
    groups: List[List[int]] = []
    for k in range(values.shape[1]):
        for group in groups:
            if np.abs(values[:, k] - values[:, group[0]]).max(initial=0) <= INVISIBLE * height:
                group.append(k)
                break
        else:
            groups.append([k])
    return groups
