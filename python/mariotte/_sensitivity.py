"""Slopes of outcomes by the numbers of a scene."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._columns import matches, names
from ._numbers import Array, Numbers, counted, numbers
from ._scene import Scene, box_of


class Sensitivity:
    """How the outcome of a scene changes with its parameters, exactly and through every event."""

    def __init__(self, found: Dict[str, Any]) -> None:
        self._found = found

    @property
    def parameters(self) -> List[str]:
        """Names of the P parameters, such as ``"mass[0]"``."""
        return list(self._found["parameters"])

    @property
    def parameter_values(self) -> Array:
        """P values [SI]."""
        return np.array(self._found["parameter_values"])

    @property
    def outcomes(self) -> List[str]:
        """Names: ``"velocity"``, ``"impulse"``, ``"icr"``, ``"time"``, ``"dissipated"``, those of a body, or of bodies, such as
        ``"bodies[0].velocity"``."""
        return list(self._found["derivative"])

    @property
    def notes(self) -> List[str]:
        """Where slopes are large, one-sided or missing, and why."""
        return list(self._found["notes"])

    def value(self, outcome: str) -> Array:
        """The outcome itself [SI], of shape (n,), or () for one number; nan where it is undefined."""
        return _numbers(self._of("values", outcome))

    def slopes(self, outcome: str) -> Array:
        """Its slopes [SI], of shape (n, P), or (P,) for one number; nan where there is none."""
        return _numbers(self._of("derivative", outcome))

    def jvp(self, change: Mapping[str, Numbers]) -> Dict[str, Array]:
        """Change of every outcome, to first order, where parameters change by so much [SI]: a number for ``mass[0]``,
        one per element for ``mass``.

        Examples
        --------
        >>> import mariotte as mt
        >>> pair = mt.Chain(mass=[2, 3], velocity=[1.5, 0], law="linear", stiffness="5 N/m")
        >>> slopes = mt.sensitivity(pair, to="velocity")
        >>> slopes.jvp({"velocity": [0.1, 0.1]})["velocity"].round(9)
        array([0.1, 0.1])
        """
        if not isinstance(change, Mapping):
            raise TypeError(f"changes by parameter are needed, not {change!r}")
        direction = np.zeros(len(self.parameters))
        for name, amount in change.items():
            places, shape = self._places(name)
            amounts = numbers(amount)
            if amounts.shape != shape:
                raise ValueError(f"changes of {name} have the shape {shape}, not {amounts.shape}")
            direction[places] += amounts
        return {outcome: self.slopes(outcome) @ direction for outcome in self.outcomes}

    def vjp(self, weights: Mapping[str, Any]) -> Dict[str, float]:
        """Slopes of the weighted sum of outcomes by every parameter: weights have the shapes of the outcomes."""
        total = np.zeros(len(self.parameters))
        for outcome, weight in weights.items():
            slopes, factors = self.slopes(outcome), np.asarray(weight, dtype=np.float64)
            if factors.shape != slopes.shape[:-1]:
                raise ValueError(f"weights of {outcome} have the shape {slopes.shape[:-1]}, not {factors.shape}")
            total = total + factors @ slopes if factors.ndim else total + factors * slopes
        return dict(zip(self.parameters, map(float, total)))

    def _places(self, name: str) -> Tuple[List[int], Tuple[int, ...]]:
        """Of one parameter, or of all elements of that name; and the shape of what belongs to them."""
        elements = list(matches(f"{name}[*]", self.parameters))
        if elements:
            return elements, (len(elements),)
        _expect(name, "parameter", self.parameters)
        return [self.parameters.index(name)], ()

    def _of(self, what: str, outcome: str) -> Any:
        _expect(outcome, "outcome", self.outcomes)
        return self._found[what][outcome]

    def __repr__(self) -> str:
        outcomes, parameters = counted(len(self.outcomes), "outcome"), counted(len(self.parameters), "parameter")
        return f"<mariotte.Sensitivity: {outcomes} by {parameters}>"


def sensitivity(scene: Scene[Any], *, to: Union[str, Sequence[str]] = ()) -> Sensitivity:
    """Slopes of the outcome of a scene, exact through every event.

    Other threads of Python run meanwhile; Ctrl-C ends it.

    Parameters
    ----------
    scene : Chain, Network, Body or Bodies
        What is simulated; laws of bodies are ``linear``, ``hertz`` and ``viscoelastic``.
    to : str or sequence of str
        Parameters: ``"mass"``, ``"contact[1].stiffness"`` or any number of the scene by its key; all numbers of the
        model unless some are named.

    Returns
    -------
    Sensitivity
        Of all outcomes; `vjp` takes less time where one velocity of a long row is wanted.

    Raises
    ------
    SceneError
        For a parameter that is no finite number, or at which the scene ends, as at a gap of zero.

    Examples
    --------
    >>> import mariotte as mt
    >>> pair = mt.Chain(mass=[2, 3], velocity=[1.5, 0], law="linear", stiffness="5 N/m")
    >>> slopes = mt.sensitivity(pair, to=["velocity"])
    >>> slopes.slopes("velocity").round(9).tolist()
    [[-0.2, 1.2], [0.8, 0.2]]
    """
    return Sensitivity(json.loads(_core.sensitivity(box_of(scene), names(to))))


def vjp(scene: Scene[Any], weights: Mapping[str, Any], *, to: Union[str, Sequence[str]] = ()) -> Dict[str, float]:
    """Slopes of a weighted sum of outcomes by every parameter.

    Those of velocities of a row of power laws are swept back through one run, which costs the same however many
    parameters there are; all others are sums of the slopes of every outcome.

    Parameters
    ----------
    scene : Chain, Network, Body or Bodies
        What is simulated, as for `sensitivity`.
    weights : mapping of str to array
        By outcome, of its shape, as ``{"velocity": [0, 0, 1]}``.
    to : str or sequence of str
        Parameters as for `sensitivity`.

    Raises
    ------
    SceneError
        For a parameter that is no finite number, or at which the scene ends, as at a gap of zero.

    Examples
    --------
    >>> import mariotte as mt
    >>> pair = mt.Chain(mass=[2, 3], velocity=[1.5, 0], law="linear", stiffness="5 N/m")
    >>> {name: round(slope, 9) for name, slope in mt.vjp(pair, {"velocity": [0, 1]}, to="velocity").items()}
    {'velocity[0]': 0.8, 'velocity[1]': 0.2}
    """
    if not isinstance(weights, Mapping):
        raise TypeError(f"weights by outcome are needed, not {weights!r}")
    if list(weights) != ["velocity"] or not _core.sweeps_back(box_of(scene)):
        return sensitivity(scene, to=to).vjp(weights)
    of_balls = _numbers(weights["velocity"])
    if of_balls.ndim != 1:
        raise ValueError(f"weights of velocity are one per ball, not of the shape {of_balls.shape}")
    found = _core.sensitivity_of_sum(scene._box, names(to), of_balls.tolist())
    return Sensitivity(json.loads(found)).vjp({"sum": 1})


def _numbers(values: Any) -> Array:
    return np.array(values, dtype=np.float64)


def _expect(name: str, thing: str, known: Sequence[str]) -> None:
    """A KeyError that says what there is, unless it is known."""
    if name not in known:
        shown = [*known[:12], "…"] if len(known) > 12 else known
        raise KeyError(f"{name} is no {thing} here: {', '.join(shown)}")
