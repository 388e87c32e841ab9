"""Figures by matplotlib: those that the command draws, in its colours and dashes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from ._numbers import Array

if TYPE_CHECKING:
    from ._impact import Impact
    from ._sweep import Sweep


# Okabe & Ito (2008) without their yellow; dashes have another period, so that 28 lines differ.
_COLOURS = ("#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
_DASHES = ("-", (0, (6, 2)), (0, (1.5, 1.5)), (0, (6, 1.5, 1.5, 1.5)))


def _axes(ax: Any) -> Any:
    """These, or those of a new figure."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt  # type: ignore[import]

    return plt.subplots(layout="constrained")[1]


def _line(place: int) -> Dict[str, Any]:
    """How the line of this number is drawn."""
    return {"color": _COLOURS[place % len(_COLOURS)], "linestyle": _DASHES[place % len(_DASHES)]}


def _labelled(name: str, unit: str, symbol: str = "") -> str:
    """What stands beside an axis: name, symbol and unit."""
    return name + (f"  {symbol}" if symbol else "") + (f" [{unit}]" if unit not in ("", "1") else "")


def _unit_of(longest: float, unit: str) -> Tuple[float, str]:
    """A factor and a unit with prefix in which a length of time or a force has few digits."""
    for factor, prefix in ((1.0, ""), (1e3, "m"), (1e6, "µ"), (1e9, "n")):
        if longest * factor >= 1:
            return factor, prefix + unit
    return 1e12, "p" + unit


class ImpactPlot:
    """Figures of a run. Each takes axes to draw into, or makes a figure, and returns the axes."""

    def __init__(self, impact: "Impact") -> None:
        self._impact = impact

    def forces(self, ax: Optional[Any] = None) -> Any:
        """Forces of contacts or tips over time, phases apart by a line at each event."""
        samples = self._impact.trajectory.steps()
        return self._curves(samples.time, samples.force, samples.force, "contact force f", "N", "contact", ax)

    def velocities(self, ax: Optional[Any] = None) -> Any:
        """Velocities over time."""
        samples = self._impact.trajectory.steps()
        velocity = samples.velocity.reshape(len(samples.time), -1)
        return self._curves(samples.time, velocity, samples.force, "velocity v", "m/s", "ball", ax)

    def energy(self, ax: Optional[Any] = None) -> Any:
        """Kinetic, stored and lost energy of a chain over time."""
        time, *energies = self._impact._run.energy_course()
        ax = _axes(ax)
        factor, unit = _unit_of(time[-1], "s")
        scale, energy_unit = _unit_of(max(float(one.max(initial=0)) for one in energies), "J")
        for place, (energy, name) in enumerate(zip(energies, ("kinetic", "stored", "lost"))):
            if energy.size:
                ax.plot(factor * time, scale * energy, label=name, **_line(place))
        return self._finish(ax, f"time t [{unit}]", f"energy [{energy_unit}]")

    def waves(self, ax: Optional[Any] = None, *, rows: int = 500, until: Optional[float] = None) -> Any:
        """Velocity over ball and time as an image, for long chains; `until` a time [s]."""
        end = self._impact.time if until is None else until
        velocity = self._impact.trajectory.velocity(np.linspace(0, end, rows))
        ax = _axes(ax)
        factor, unit = _unit_of(end, "s")
        image = ax.imshow(velocity, aspect="auto", origin="lower",
                          extent=(-0.5, velocity.shape[1] - 0.5, 0, factor * end))
        ax.figure.colorbar(image, label="velocity v [m/s]")
        return self._finish(ax, "ball i", f"time t [{unit}]", legend=False)

    def _curves(self, time: Array, values: Array, force: Array, name: str, unit: str, of: str, ax: Any) -> Any:
        ax = _axes(ax)
        factor, time_unit = _unit_of(time[-1], "s")
        scale, value_unit = _unit_of(float(np.abs(values).max(initial=0)), unit) if unit == "N" else (1.0, unit)
        for place in range(values.shape[1]):
            ax.plot(factor * time, scale * values[:, place], label=f"{of} {place}", **_line(place))
        for event in self._impact.events:
            ax.axvline(factor * event.time, color="0.85", linewidth=0.8, zorder=0)
        start, end = _window(time, force)
        ax.set_xlim(factor * start, factor * end)
        return self._finish(ax, f"time t [{time_unit}]", f"{name} [{value_unit}]", legend=values.shape[1] <= 12)

    def _finish(self, ax: Any, x: str, y: str, *, legend: bool = True) -> Any:
        ax.set(xlabel=x, ylabel=y, title=self._impact.scene.title)
        if legend:
            ax.legend()
        return ax


def _window(time: Array, force: Array) -> Tuple[float, float]:
    """From soon before the first force above a thousandth of the largest until soon after the last."""
    active = np.abs(force).max(axis=1)
    pushing = time[active > 1e-3 * active.max()] if active.max() > 0 else time
    margin = 0.05 * (pushing[-1] - pushing[0])
    return max(float(time[0]), float(pushing[0] - margin)), min(float(time[-1]), float(pushing[-1] + margin))


class SweepPlot:
    """Figures of a sweep: ``grid.plot("icr[0]")``."""

    def __init__(self, sweep: "Sweep") -> None:
        self._sweep = sweep

    def __call__(self, column: str, ax: Optional[Any] = None) -> Any:
        """Curves along one axis, or a map of a single number over two; returns the axes."""
        values = self._sweep[column]
        axes = list(self._sweep.axes.items())
        if len(self._sweep.shape) == 1:
            return self._curves(column, values, axes[0], ax)
        if values.ndim == 2:
            return self._map(column, values, axes, ax)
        raise ValueError(f"{column} has the shape {values.shape}: a figure shows one axis, or one number over two")

    def _curves(self, column: str, values: Array, axis: Tuple[str, Array], ax: Any) -> Any:
        ax = _axes(ax)
        names = self._sweep.keys_of(column)
        for place, (name, curve) in enumerate(zip(names, values.reshape(len(values), -1).T)):
            ax.plot(axis[1], curve, label=name, **_line(place))
        if len(names) > 1:
            ax.legend()
        if _is_logarithmic(axis[1]):
            ax.set_xscale("log")
        ax.set(xlabel=self._label(axis[0]), ylabel=self._label(names[0], column if len(names) > 1 else ""), title=self._sweep.scene.title)
        return ax

    def _label(self, key: str, name: str = "") -> str:
        """Of an axis; `name` stands for several keys with one unit and no common symbol."""
        symbol = self._sweep.symbols.get(key, "") if name in ("", key) else ""
        return _labelled(name or key, self._sweep.units[key], symbol)

    def _map(self, column: str, values: Array, axes: Any, ax: Any) -> Any:
        ax = _axes(ax)
        rows, columns = (self._along(axis) for axis in (0, 1))
        image = ax.pcolormesh(columns[1], rows[1], values, shading="nearest")
        ax.figure.colorbar(image, label=self._label(self._sweep.keys_of(column)[0]))
        for name, (_, along) in (("y", rows), ("x", columns)):
            if _is_logarithmic(along):
                getattr(ax, f"set_{name}scale")("log")
        ax.set(xlabel=self._label(columns[0]), ylabel=self._label(rows[0]), title=self._sweep.scene.title)
        return ax

    def _along(self, axis: int) -> Tuple[str, Array]:
        """The first key that moves along an axis, and its values."""
        key = next(key for key, place in self._sweep.axis_of.items() if place == axis)
        return key, self._sweep.axes[key]


def _is_logarithmic(values: Array) -> bool:
    """Whether ratios are even, and not distances."""
    if len(values) < 3 or values.min() <= 0:
        return False
    return bool(np.ptp(np.diff(np.log(values))) < 1e-6 and np.ptp(np.diff(values)) > 1e-6 * np.ptp(values))
