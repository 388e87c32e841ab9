"""Curves of what has a direction: friction and spins of bodies."""

from __future__ import annotations

from typing import List, Optional, Sequence

import numpy as np

from ._curves import Curves
from ._numbers import Array

_AXES = ("x", "y", "z")
_SEEN = 2e-3  # of the largest; what is less looks like zero


def component_curves(quantity: str, unit: str, at_peak: bool, time: Array, vectors: Array, owners: Sequence[str],
                     most_curves: int, numbers: Optional[List[int]] = None, axes: Sequence[str] = _AXES) -> Curves:
    """A curve per component that does not look like zero; the magnitudes, if these were too many.

    `vectors` has the shape (T, k, 3), `owners` k names; `axes` are what stands behind them.
    """
    least = _SEEN * np.linalg.norm(vectors, axis=2).max(initial=0)
    shown = [(i, k) for i in range(len(owners)) for k in range(3) if np.abs(vectors[:, i, k]).max(initial=0) > least]
    if len(shown) > most_curves:
        magnitudes = np.linalg.norm(vectors, axis=2)
        return Curves(f"magnitude of {quantity}", unit, list(owners), at_peak, time, magnitudes, numbers)
    names = [f"{owners[i]} {axes[k]}".rstrip() for i, k in shown]
    values = np.stack([vectors[:, i, k] for i, k in shown], axis=1) if shown else np.zeros((len(time), 0))
    return Curves(quantity, unit, names, at_peak, time, values)
