"""Capture velocities, curves of restitution, and fits to measurements."""

from __future__ import annotations

import json
import math
import os
from functools import cached_property
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._columns import names
from ._errors import warn
from ._keys import whole_key
from ._numbers import Array, Numbers, listed, number, numbers
from ._scene import Path, Scene, box_of_text


#: One value per measurement; cells may be text with a unit.
Column = Union[Numbers, Sequence[Any]]


class CaptureVelocity(NamedTuple):
    """Two speeds with the capture velocity between them."""

    captured: float  #: largest speed found at which the body is captured [m/s]
    separated: float  #: smallest speed found at which it separates [m/s]
    runs: int  #: impacts simulated

    @property
    def value(self) -> float:
        """The middle [m/s]."""
        return 0.5 * (self.captured + self.separated)

    def __float__(self) -> float:
        return self.value


def capture_velocity(body: Scene[Any], *, tolerance: float = 1e-9) -> CaptureVelocity:
    """Find the normal speed below which a body does not come off the plane again, or two bodies off each other.

    Parameters
    ----------
    body : Body or Chain
        Its normal speed is where the search starts; of a chain, which has two bodies, their approach.
    tolerance : float
        Width of the bracket, relative to the speed.

    Raises
    ------
    SceneError
        For a scene of anything else.
    Error
        If no speed within a factor of a million parts capture from separation (code R003).

    Examples
    --------
    >>> import mariotte as mt
    >>> sphere = mt.Body(shape="sphere", radius="2.45 um", density="1350 kg/m^3",
    ...                  surface={"stiffness": "1.74 GPa", "work_of_adhesion": "0.38 J/m^2", "zeta_hertz": 1.5,
    ...                           "zeta_adhesion": 0.5}, incidence={"normal_speed": "5 m/s"})
    >>> round(mt.capture_velocity(sphere).value, 6)
    1.310359
    """
    return CaptureVelocity(*_core.capture_velocity(box_of_text(body), number(tolerance, "tolerance")))


class RestitutionCurve(NamedTuple):
    """How the restitution of two bodies depends on their speed."""

    speed: Array  #: of approach [m/s]
    restitution: Array  #: e at each speed; 0 where adhesion keeps them
    closed_form: Array  #: the same without integration; nan where the law has no closed form


def restitution(pair: Scene[Any], speed: Numbers) -> RestitutionCurve:
    """Find e of two bodies that nothing else touches at speeds of approach.

    Parameters
    ----------
    pair : Chain
        Two balls, or a ball and a wall. Of a :class:`Body` sweep ``incidence.normal_speed``.
    speed : array_like
        One, or a row [m/s]. A damper that follows from a restitution in the scene stays as it is there.

    Warns
    -----
    ModelWarning
        Of what has to be said of the fastest impact.

    Examples
    --------
    >>> import mariotte as mt
    >>> beads = mt.Chain(mass=[1, 1], velocity=[1, 0], law="kelvin-voigt", stiffness=1e6, damping=100)
    >>> mt.restitution(beads, [0.1, 1]).restitution.round(6)
    array([0.808424, 0.808424])
    """
    box, speeds = box_of_text(pair), listed(np.atleast_1d(numbers(speed, "m/s")))
    found, closed, warnings = _core.restitution(box, speeds)
    warn(warnings)
    return RestitutionCurve(np.array(speeds), found, closed)


class Estimate(NamedTuple):
    """One value that was found [SI]."""

    value: float
    standard_error: float  #: inf of a value that the search has followed down to zero
    lower: float  #: end of the confidence interval; 0 where zero is not told from the value
    upper: float
    start: float


class Fit:
    """Values that fit measurements best, and how well these know them; Jupyter shows the report."""

    def __init__(self, run: _core.FitRun) -> None:
        self._run = run
        self._report: Dict[str, Any] = json.loads(run.json())
        self._table = run.table()
        self._of_speeds = run.warnings()

    @property
    def estimates(self) -> Dict[str, Estimate]:
        """By key of the scene."""
        return {one["key"]: _estimate(**one) for one in self._report["estimates"]}

    @property
    def values(self) -> Dict[str, float]:
        """By key of the scene [SI]; ``scene.replace(fit.values)`` is the fitted one."""
        return {key: one.value for key, one in self.estimates.items()}

    @property
    def correlation(self) -> Array:
        """Of the logarithms of the values, of shape (p, p)."""
        return np.array(self._report["correlation"])

    @property
    def measured(self) -> Array:
        """What was measured, one per measurement [SI]."""
        return self._of_rows("measured")

    @property
    def deviation(self) -> Array:
        """Of what was measured, one per measurement [SI]; nan where none is known."""
        return self._of_rows("deviation")

    @property
    def predicted(self) -> Array:
        """The same with the fitted values, one per measurement [SI]."""
        return self._of_rows("predicted")

    @property
    def rms(self) -> float:
        """Root mean square of measured − predicted."""
        return float(self._report["rms"])

    @property
    def warnings(self) -> List[str]:
        """Values that the measurements hardly determine, and a restitution that holds at every speed."""
        return [*self._report["warnings"], *self._of_speeds]

    def setting(self, key: str) -> Array:
        """What the measurements put into the scene [SI], one per measurement."""
        return np.array([one["settings"][key] for one in self._report["measurements"]])

    def plot(self, ax: Optional[Any] = None) -> Any:
        """Draw what was measured and the fitted curves over the setting that varies most; return the axes.

        Raises ValueError if no setting is a number, or if there would be too many curves to tell apart.
        """
        from ._plot import plot_fit

        return plot_fit(self, ax)

    @cached_property
    def _curves(self) -> Any:
        """What a figure shows; it takes some runs more."""
        return self._run.curves()

    def __getstate__(self) -> Dict[str, Any]:
        return {"_report": self._report, "_table": self._table, "_of_speeds": self._of_speeds,
                "_curves": self._curves}

    def json(self) -> Dict[str, Any]:
        """All of it, as `mariotte fit --json` prints it."""
        return self._report

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<mariotte.Fit: {', '.join(f'{key} = {value:.6g}' for key, value in self.values.items())}>"

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self._table)}</pre>"

    def _of_rows(self, name: str) -> Array:
        return np.array([one[name] for one in self._report["measurements"]], dtype=np.float64)


def fit(scene: Scene[Any], data: Union[Path, Mapping[str, Column]], *,
        free: Union[str, Sequence[str]] = ("surface.zeta_hertz", "surface.zeta_adhesion"),
        confidence: float = 0.95) -> Fit:
    """Find values of a scene from what was measured: of a body, a chain or a network.

    Parameters
    ----------
    scene : Body, Chain or Network
        All that is known; values of the free keys are where the search starts.
    data : path or dict
        A CSV file, or columns of one length by name: ``speed``, ``diameter`` or any key of the scene,
        ``restitution`` or any other key of the result that was measured, and ``deviation`` if it is known. In a dict
        the name of the model may be left out: ``velocity[0]`` of a chain is ``chain.velocity[0]``, before the impact.
    free : str or sequence of str
        Keys whose values are to be found; the name of the model may be left out, as in ``"damping"`` of a chain.
    confidence : float
        Of the intervals.

    Raises
    ------
    FitError
        If the measurements do not determine the values.

    Warns
    -----
    ModelWarning
        Of values that they hardly determine, or that tend to zero.

    Examples
    --------
    >>> import mariotte as mt
    >>> sphere = mt.Body(shape="sphere", radius="2.45 um", density="1350 kg/m^3",
    ...                  surface={"stiffness": "1.74 GPa", "damping_hertz": "1e-3 s/m"},
    ...                  incidence={"normal_speed": "5 m/s"})
    >>> speeds = [1.0, 2.0, 4.0, 8.0]
    >>> truth = sphere.replace({"surface.damping_hertz": 2e-3})
    >>> measured = mt.sweep(truth, {"incidence.normal_speed": speeds}, columns=["restitution.tip"])["restitution.tip"]
    >>> found = mt.fit(sphere, {"speed": speeds, "restitution": measured}, free=["surface.damping_hertz"])
    >>> round(found.values["surface.damping_hertz"], 9)
    0.002
    """
    box = box_of_text(scene)
    if isinstance(data, Mapping):
        text, name = _csv([(_header(scene, key), column) for key, column in data.items()]).encode(), "<data>"
    else:
        text, name = _core.read_text(os.fspath(data)), os.fspath(data)
    keys = [whole_key(box.kind, key) for key in names(free)]
    found = Fit(_core.fit(box, text, name, keys, number(confidence, "confidence")))
    warn(found.warnings)
    return found


def _estimate(
    *, key: str, start: float, value: float, standard_error: Optional[float], interval: List[Optional[float]]
) -> Estimate:
    """JSON has null for what is beyond all numbers."""
    error, lower, upper = (math.inf if one is None else one for one in (standard_error, *interval))
    return Estimate(value, error, lower, upper, start)


def _header(scene: Scene[Any], name: str) -> str:
    """The key of a scene may be short, as those of axes; what stands behind it is a unit."""
    key, blank, unit = name.strip().partition(" ")
    known = key in ("speed", "diameter", "deviation", "ending", "reason") or _core.is_of_results(key)
    return name if known else whole_key(scene._box.kind, key) + blank + unit


def _csv(columns: List[Tuple[str, Column]]) -> str:
    header, cells = zip(*(_cells(name, column) for name, column in columns)) if columns else ((), ())
    lengths = {name: len(column) for name, column in zip(header, cells)}
    if len(set(lengths.values())) > 1:
        raise ValueError(f"columns have different lengths: {lengths}")
    return "\n".join([",".join(header), *map(",".join, zip(*cells))]) + "\n"


def _cells(name: str, column: Any) -> Tuple[str, List[str]]:
    """Header and cells as text; quantities bring their units, and become SI."""
    if hasattr(column, "to_base_units"):
        name, column = name.split("[")[0].strip(), numbers(column)
    if isinstance(column, str) or np.ndim(column) != 1:
        raise ValueError(f"the column {name} is not one row of values")
    return name, [one if isinstance(one, str) else repr(number(one, name)) for one in column]
