"""The inside of a run."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ._numbers import Array, Numbers, numbers

if TYPE_CHECKING:
    from ._impact import Impact


_ROUNDED = 1 + 1e-15  #: the end of a run may lie so far before what was asked for


class Samples(NamedTuple):
    """A row per time."""

    time: Array  #: of shape (T,) [s]
    velocity: Array  #: of shape (T, n): balls [m/s], degrees of freedom, a body's mass centre; (T, n, d) of bodies
    gap: Array  #: of shape (T, m): contacts or tips, negative in contact [m]
    force: Array  #: of shape (T, m) [N]


class Trajectory:
    """Velocities, gaps and forces at any time of a run, by the dense output of its steps.

    Nothing is stored: every call runs the scene again and looks at it at these times, until its end is that of the
    result to twice the accuracy that was asked for. So ask for all times at once, and by `at` for all that is known.

    Examples
    --------
    >>> import mariotte as mt
    >>> pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness=1)
    >>> hit = mt.simulate(pair)
    >>> hit.trajectory.velocity([0, hit.time / 2, hit.time]).round(9)
    array([[1. , 0. ],
           [0.5, 0.5],
           [0. , 1. ]])
    """

    def __init__(self, impact: "Impact") -> None:
        self._impact = impact

    def at(self, t: Numbers) -> "Samples":
        """All of it at times `t` of any shape, in one run: (…, n) or, of bodies, (…, n, d), and (…, m)."""
        times = numbers(t, "s")
        end = self._impact.time
        if times.size and not (times.min() >= 0 and times.max() <= end * _ROUNDED):
            raise ValueError(f"times lie between 0 and {end} s, the end of the run")
        times = np.minimum(times, end)
        order, back = np.unique(times, return_inverse=True)
        _, velocity, gap, force = self._impact._run.sample(order)
        velocity = velocity.reshape(len(order), *self._impact.velocity.shape)
        return Samples(times, *(one[back].reshape(*times.shape, *one.shape[1:]) for one in (velocity, gap, force)))

    def velocity(self, t: Numbers) -> Array:
        """At times `t` of any shape: (…, n) [m/s]."""
        return self.at(t).velocity

    def gap(self, t: Numbers) -> Array:
        """At times `t` of any shape: (…, m) [m]."""
        return self.at(t).gap

    def force(self, t: Numbers) -> Array:
        """At times `t` of any shape: (…, m) [N]."""
        return self.at(t).force

    def steps(self) -> Samples:
        """At the times of its steps, as many as make a picture."""
        time, velocity, gap, force = self._impact._run.steps()
        return Samples(time, velocity.reshape(len(time), *self._impact.velocity.shape), gap, force)
