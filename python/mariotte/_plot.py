"""Figures by matplotlib: those that the command draws, in its colours and dashes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Sequence, Tuple

import numpy as np

from . import _core
from ._bodies import BodiesImpact
from ._columns import key_of_result
from ._components import component_curves
from ._curves import Curves, Window, chosen, line_style
from ._figure import draw_curves, make_panels
from ._image import draw_image
from ._numbers import Array, Numbers, numbers
from ._scene import Body, Bodies, Chain, Scene
from ._style import beside_axis, labelled, make_logarithmic, mathtext, style_of, text_size, wrapped

if TYPE_CHECKING:
    from ._events import Event
    from ._impact import Impact
    from ._studies import Fit
    from ._sweep import Sweep

_MOST_CURVES = 12  # more are an image
_MOST_OF_A_FAMILY = 7  # values of a sweep that have a curve each; of more there is a map
_AXES = "xyz"


def _axes(ax: Any) -> Any:
    """These, or those of a new figure."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt  # type: ignore[import]

    return plt.subplots(layout="constrained")[1]


class ImpactPlot:
    """Figures of a run. Each takes axes to draw into, or makes a figure, and returns the axes.

    Long flights between impacts are left out: then a figure of its own has several panels. What is returned are the
    first axes, and ``ax.figure.axes`` has all. Balls, contacts and tips count from 1 in figures, as in tables.
    """

    def __init__(self, impact: "Impact") -> None:
        self._impact = impact

    def forces(self, ax: Optional[Any] = None, *, contacts: Optional[Sequence[int]] = None) -> Any:
        """Forces of contacts or tips over time, or of some `contacts`, from 0; an image of more than twelve."""
        samples = self._impact.trajectory.steps()
        friction, windows, of_forces, note, logarithmic, _, _, _, own = _core.picture(self._impact._run)
        values, quantity = samples.force, "contact force f"
        names = names_of_contacts(self._impact, values.shape[1])
        closed = _closed(self._impact)
        if closed is not None:
            values, names = values[:, closed], [names[j] for j in closed]
        if isinstance(self._impact.scene, Body):
            values, names = _with_friction(values, friction)
            quantity = "force on a tip F"
        curves = Curves(quantity, "N", names, True, samples.time, values, closed and [j + 1 for j in closed])
        if not isinstance(self._impact.scene, Body):
            curves = chosen(curves, _asked(contacts, curves.numbers or range(1, len(names) + 1)) or own)
        if ax is not None or curves.values.shape[1] > _MOST_CURVES:
            return self._draw(curves, windows, "contact j", logarithmic, ax)
        return self._draw(curves, of_forces, "contact j", logarithmic, ax, note)

    def velocities(self, ax: Optional[Any] = None, *, balls: Optional[Sequence[int]] = None) -> Any:
        """Velocities over time, or of some `balls`, from 0; an image of more than twelve, of speeds in the plane and
        in space."""
        samples = self._impact.trajectory.steps()
        _, windows, _, _, logarithmic, moving, unit, own, _ = _core.picture(self._impact._run)
        wanted = _asked(balls, range(1, len(self._impact.velocity) + 1)) or own
        if isinstance(self._impact.scene, Body):
            wanted = []
        values = samples.velocity.reshape(len(samples.time), -1)
        dimension = dimension_of(self._impact.scene)
        names, quantity = names_of_velocities(self._impact.scene, moving, values.shape[1]), "velocity v"
        if isinstance(self._impact.scene, Body):
            quantity = "velocity of centre v"
        elif dimension > 1 and (dimension * len(wanted) or values.shape[1]) > _MOST_CURVES:
            values, quantity = np.linalg.norm(values.reshape(len(values), -1, dimension), axis=2), "speed v"
            names, dimension = [f"{moving} {i + 1}" for i in range(values.shape[1])], 1
        curves = chosen(Curves(quantity, unit, names, False, samples.time, values), wanted, dimension)
        return self._draw(curves, windows, "ball i", logarithmic, ax)

    def friction(self, ax: Optional[Any] = None) -> Any:
        """Friction of bodies over time, by its components along the axes, or by magnitudes if these are more than
        twelve. Raises InvalidParameter for other scenes, and ValueError where there is none."""
        time, _, forces = _core.turning(self._impact._run)
        closed = _closed(self._impact) or []
        names = [name.replace("f_{", "f_{t,") for name in names_of_contacts(self._impact, forces.shape[1])]
        curves = component_curves("friction $f_t$", "N", True, time, forces[:, closed], [names[j] for j in closed],
                                  _MOST_CURVES, [j + 1 for j in closed])
        return self._draw_components(curves, "contact j", ax)

    def spins(self, ax: Optional[Any] = None) -> Any:
        """Spins of bodies over time, by their components along the axes, or by magnitudes if these are more than
        twelve. Raises InvalidParameter for other scenes, and ValueError where nothing spins."""
        time, spins, _ = _core.turning(self._impact._run)
        axes = ("", "", "") if dimension_of(self._impact.scene) == 2 else _AXES
        curves = component_curves("spin ω", "rad/s", False, time, spins, names_of_bodies(self._impact.scene),
                                  _MOST_CURVES, axes=axes)
        return self._draw_components(curves, "body i", ax)

    def _draw_components(self, curves: Curves, along: str, ax: Any) -> Any:
        count = curves.values.shape[1]
        if count == 0:
            raise ValueError(f"there is no {curves.quantity.split()[0]}")
        _, windows, of_forces, note, logarithmic, *_ = _core.picture(self._impact._run)
        if curves.at_peak and ax is None and count <= _MOST_CURVES:
            return self._draw(curves, of_forces, along, logarithmic, ax, note)
        return self._draw(curves, windows, along, logarithmic, ax)

    def energy(self, ax: Optional[Any] = None) -> Any:
        """Kinetic, stored and dissipated energy of a chain over time.

        Dissipated is left out where gravity, drives or moving walls do work. Raises ValueError for other
        scenes, and for contacts that yield or adhere.
        """
        time, *energies = self._impact._run.energy_course()
        windows = list(_core.picture(self._impact._run)[1])
        if windows[0][0] > 0:
            windows.insert(0, (0.0, windows[0][0]))
        named = [(name, one) for name, one in zip(("kinetic", "stored", "dissipated"), energies) if one.size]
        curves = Curves("energy E", "J", [name for name, _ in named], False, time,
                        np.stack([one for _, one in named], axis=1))
        return self._draw(curves, windows, "", False, ax)

    def waves(self, ax: Optional[Any] = None, *, rows: int = 500, until: Optional[Numbers] = None) -> Any:
        """Velocity over time and ball as an image, for long chains, at `rows` times; `until` a time [s].

        Raises ValueError for what is no chain.
        """
        if not isinstance(self._impact.scene, Chain):
            raise ValueError("waves() shows the balls of a chain; velocities() shows those of other scenes")
        end = self._impact.time if until is None else float(numbers(until, "s"))
        velocity = self._impact.trajectory.velocity(np.linspace(0, end, rows))
        with style_of(ax):
            return self._waves(velocity, end, _axes(ax))

    def _waves(self, velocity: Array, end: float, ax: Any) -> Any:
        factor, unit = _core.display([end], "s")
        scale, velocity_unit = _core.display([float(velocity.min()), float(velocity.max())], "m/s")
        image = ax.imshow(scale * velocity.T, aspect="auto", origin="lower",
                          extent=(0, factor * end, 0.5, velocity.shape[1] + 0.5))
        ax.figure.colorbar(image, label=f"velocity v [{velocity_unit}]")
        ax.set(xlabel=f"time t [{unit}]", ylabel="ball i", title=wrapped(self._impact.scene.title))
        return ax

    def _draw(self, curves: Curves, windows: List[Window], along: str, logarithmic: bool, ax: Any,
              note: str = "") -> Any:
        with style_of(ax):
            axes, windows = make_panels(ax, windows, wrapped(self._impact.scene.title))
            if curves.values.shape[1] > _MOST_CURVES:
                draw_image(axes, windows, curves, along, self._marks(), logarithmic)
            else:
                draw_curves(axes, windows, curves, self._marks(), note)
        return axes[0]

    def _marks(self) -> "List[Event]":
        """Events that part phases: contacts close, open, or change their branch. Those of bodies that have touched from
        the start close when they are pressed."""
        events = self._impact.events
        if isinstance(self._impact.scene, Bodies):
            events = [event._replace(close=tuple(sorted({*event.close, *event.touch} - {*event.part})), unload=())
                      for event in events]
        return [event for event in events if event.close or event.open or event.yields or event.unload]


def _asked(places: Optional[Sequence[int]], known: Sequence[int]) -> List[int]:
    """Places from 0 as numbers from 1; those that there are not are refused."""
    numbers = [] if places is None else [int(place) + 1 for place in places]
    missing = [number - 1 for number in numbers if number not in known]
    if missing:
        raise IndexError(f"no {missing[0]} among those of the figure: {known[0] - 1} to {known[-1] - 1}")
    return numbers


def dimension_of(scene: Scene[Any]) -> int:
    """Velocities of a ball that follow each other."""
    if isinstance(scene, Bodies):
        return scene.dimension
    return max(1, int(scene.json()["network"]["dimension"])) if scene._box.kind == "network" else 1


def names_of_velocities(scene: Scene[Any], moving: str, count: int) -> List[str]:
    """Of the curves, from 1; bodies have names."""
    if isinstance(scene, Body):
        return ["normal", "along $e_2$", "along $e_3$"]
    if isinstance(scene, Chain):
        return ["wall" if np.isinf(mass) else f"ball {i + 1}" for i, mass in enumerate(scene.mass)]
    dimension = dimension_of(scene)
    if isinstance(scene, Bodies):
        return [f"{name} {axis}" for name in names_of_bodies(scene) for axis in _AXES[:dimension]]
    if scene.json()["network"]["dimension"] == 0:
        return [f"{moving} {i + 1}" for i in range(count)]
    return [f"ball {i // dimension + 1} {_AXES[i % dimension]}" for i in range(count)]


def names_of_bodies(scene: Scene[Any]) -> List[str]:
    """Of each, or its number from 1."""
    return [one["name"] or f"body {i + 1}" for i, one in enumerate(scene.json()["bodies"]["body"])]


def _closed(impact: "Impact") -> Optional[List[int]]:
    """Of bodies, which may touch anywhere, the contacts that have closed; of others all have curves."""
    if not isinstance(impact, BodiesImpact):
        return None
    return [j for j, periods in enumerate(impact.periods) if len(periods)]


def names_of_contacts(impact: "Impact", count: int) -> List[str]:
    """Of the curves, from 1, with the two that touch where they are known."""
    scene = impact.scene
    pairs = [""] * count
    if isinstance(impact, BodiesImpact):
        pairs = [f" ({'–'.join(pair)})" for pair in impact.between]
    if scene._box.kind == "network":
        balls = [one.get("balls") for one in scene.json()["network"]["contact"]]
        pairs = [f" ({pair[0]}–{pair[1]})" if pair else "" for pair in balls]
    return [f"$f_{{{j + 1}}}${pair}" for j, pair in enumerate(pairs)]


def _with_friction(normal: Array, friction: Array) -> Tuple[Array, List[str]]:
    """Three forces per tip, and their names."""
    rows, tips = normal.shape
    forces = np.concatenate([normal[:, :, None], friction.reshape(rows, tips, 2)], axis=2)
    names = [f"tip {i + 1} {direction}" for i in range(tips) for direction in ("normal", "$e_2$", "$e_3$")]
    return forces.reshape(rows, 3 * tips), names


def _with_gaps(along: Array, curve: Array, ending: Any) -> Tuple[Array, Array]:
    """Points of a line, which has a gap where the next one ends in another way."""
    gaps = 1 + np.flatnonzero(np.diff(ending))
    return np.insert(along, gaps, np.nan), np.insert(curve, gaps, np.nan)


def _plot_line(ax: Any, along: Array, curve: Array, ending: Any, place: int, name: str) -> None:
    """A line with gaps where the ending changes; a point between two of them is a dot. Where what is varied goes to and
    fro, all are."""
    x, y = _with_gaps(along, curve, ending)
    known = np.concatenate([[False], np.isfinite(y), [False]])
    alone = np.flatnonzero(known[1:-1] & ~known[:-2] & ~known[2:])
    style = line_style(place)
    if np.any(np.diff(along) < 0):
        style.update(marker="o", markersize=3, linestyle="none")
    elif alone.size:
        style.update(marker="o", markersize=3, markevery=alone.tolist())
    ax.plot(x, y, label=name, **style)


def _name_lines(ax: Any, count: int) -> None:
    """Many names stand beside the figure, in columns."""
    if count <= _MOST_OF_A_FAMILY:
        ax.legend()
    else:
        ax.legend(loc="center left", bbox_to_anchor=(1, 0.5), ncol=-(-count // 13), fontsize=text_size(0.8))


class SweepPlot:
    """Figures of a sweep: ``grid.plot("icr[0]")``."""

    def __init__(self, sweep: "Sweep") -> None:
        self._sweep = sweep

    def __call__(self, column: Optional[str] = None, ax: Optional[Any] = None) -> Any:
        """Curves along one axis; of a single number over two axes a map, or a curve per value of one that has no more
        than seven. The column may be left out if there is one. Returns the axes."""
        if column is None:
            column = self._only_column()
        with style_of(ax):
            return self._draw(column, ax)

    def _only_column(self) -> str:
        if len(self._sweep) != 1:
            raise ValueError(f"which column? there are {len(self._sweep)}")
        return next(iter(self._sweep))

    def _draw(self, column: str, ax: Any) -> Any:
        values, ending = self._sweep[column], self._sweep.ending
        if ending.ndim > 2 or (ending.ndim == 2 and values.ndim > 2):
            raise ValueError(f"{column} has the shape {values.shape}: a figure shows one axis, or one number over two")
        for axis in range(ending.ndim):
            order = self._order(axis)
            values, ending = np.take(values, order, axis), np.take(ending, order, axis)
        if ending.ndim == 1:
            return self._curves(column, values, ending, _axes(ax))
        short = [axis for axis in (0, 1) if len(self._along(axis)[1]) <= _MOST_OF_A_FAMILY]
        if short:
            return self._family(column, values, ending, short[0], _axes(ax))
        return self._map(column, values, _axes(ax))

    def _curves(self, column: str, values: Array, ending: Any, ax: Any) -> Any:
        keys = self._sweep.keys_of(column)
        (along, x), (heights, y) = self._shown(*self._along(0)), self._of_column(column, values)
        for place, (key, curve) in enumerate(zip(keys, heights.reshape(len(values), -1).T)):
            _plot_line(ax, along, curve, ending, place, mathtext(self._sweep._run.short_label(key)))
        if len(keys) > 1:
            _name_lines(ax, len(keys))
        self._mark(ax, "x", 0)
        ax.set(xlabel=x, ylabel=y, title=wrapped(self._sweep.scene.title))
        return ax

    def _shown(self, key: str, values: Any, name: str = "") -> Tuple[Array, str]:
        """Values in the unit that suits them, or the places of words, and what stands beside their axis; `name` is the
        key of several."""
        label, given = self._sweep._run.long_label(key, name or key), self._sweep.units[key]
        if values.dtype.kind == "U":
            return np.arange(len(values), dtype=float), labelled(label, "")
        if given == "rad" and key in self._sweep.axes:
            return np.degrees(values), labelled(label, "deg")
        largest = float(np.abs(values[np.isfinite(values)]).max(initial=0))
        factor, unit = _core.display([largest], given) if given else (1.0, "")
        return factor * values, labelled(label, unit)

    def _of_column(self, column: str, values: Array) -> Tuple[Array, str]:
        keys = self._sweep.keys_of(column)
        several = key_of_result(self._sweep.scene, column).replace("[*]", "")
        return self._shown(keys[0], values, several if len(keys) > 1 else "")

    def _family(self, column: str, values: Array, ending: Any, short: int, ax: Any) -> Any:
        """A curve along one axis for each value of the short one."""
        key, each = self._along(short)
        (along, x), (per_curve, heading) = self._shown(*self._along(1 - short)), self._shown(key, each)
        heights, y = self._of_column(column, values)
        names = each.tolist() if each.dtype.kind == "U" else _told_apart(per_curve)
        rows = zip(names, np.moveaxis(heights, short, 0), np.moveaxis(ending, short, 0))
        for place, (name, curve, ends) in enumerate(rows):
            _plot_line(ax, along, curve, ends, place, name)
        ax.legend(title=heading)
        self._mark(ax, "x", 1 - short)
        ax.set(xlabel=x, ylabel=y, title=wrapped(self._sweep.scene.title))
        return ax

    def _map(self, column: str, values: Array, ax: Any) -> Any:
        (right, x), (up, y) = (self._shown(*self._along(axis)) for axis in (0, 1))
        colours, name = self._of_column(column, values)
        ax.figure.colorbar(ax.pcolormesh(right, up, colours.T, shading="nearest"), label=name)
        for axis, letter in enumerate("xy"):
            self._mark(ax, letter, axis)
        ax.set(xlabel=x, ylabel=y, title=wrapped(self._sweep.scene.title))
        return ax

    def _mark(self, ax: Any, letter: str, axis: int) -> None:
        """Words along an axis, or decades where values are evenly spaced in their logarithm."""
        key, values = self._along(axis)
        if values.dtype.kind == "U":
            ax.set(**{f"{letter}ticks": range(len(values)), f"{letter}ticklabels": values.tolist()})
        elif _is_logarithmic(values):
            make_logarithmic(ax, letter, self._shown(key, values)[0])

    def _along(self, axis: int) -> Tuple[str, Any]:
        """The first key that moves along an axis, and its values in the order in which they are drawn."""
        key = self._moving(axis)[0]
        return key, self._sweep.axes[key][self._order(axis)]

    def _order(self, axis: int) -> Any:
        """From small to large, unless other keys move along, or what is varied is text."""
        keys = self._moving(axis)
        values = self._sweep.axes[keys[0]]
        if len(keys) > 1 or values.dtype.kind == "U":
            return np.arange(len(values))
        return np.argsort(values, kind="stable")

    def _moving(self, axis: int) -> List[str]:
        return [key for key, place in self._sweep.axis_of.items() if place == axis]


def plot_fit(fit: "Fit", ax: Any) -> Any:
    """Measurements, with their deviations, and the fitted curves."""
    if fit._curves is None:
        raise ValueError("no figure: no setting is a number, or there would be too many curves to tell apart")
    with style_of(ax):
        return _fitted(fit, _axes(ax))


def _fitted(fit: "Fit", ax: Any) -> Any:
    x, y, key, factor, logarithmic, curves, curve_of_row = fit._curves
    along, rows = factor * fit.setting(key), np.array(curve_of_row)
    for place, (name, abscissa, ordinate, captured) in enumerate(curves):
        own = rows == place
        ax.plot(*_with_gaps(abscissa, ordinate, captured), label=name or "fitted", **line_style(place))
        bars = None if np.isnan(fit.deviation).any() else fit.deviation[own]
        ax.errorbar(along[own], fit.measured[own], bars, color=line_style(place)["color"], fmt="o",
                    markersize=2.5, elinewidth=0.5, label="_" if name else "measured")
    if logarithmic:
        make_logarithmic(ax, "x", np.concatenate([curve[1] for curve in curves]))
    _name_lines(ax, len(curves))
    ax.set(xlabel=beside_axis(x), ylabel=beside_axis(y), title=wrapped(fit.json()["title"]))
    return ax


def _is_logarithmic(values: Array) -> bool:
    """Whether ratios are even, and not distances."""
    if len(values) < 3 or values.min() <= 0:
        return False
    return bool(np.ptp(np.diff(np.log(values))) < 1e-6 and np.ptp(np.diff(values)) > 1e-6 * np.ptp(values))


def _told_apart(values: Array) -> List[str]:
    """Numbers with three digits, or as many more as it takes."""
    for digits in range(3, 17):
        names = [f"{value:.{digits}g}" for value in values]
        if len(set(names)) == len(set(values.tolist())):
            break
    return names
