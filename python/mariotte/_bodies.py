"""The result of bodies with friction."""

from __future__ import annotations

from typing import List, NamedTuple, Tuple

from ._impact import WithContacts
from ._numbers import Array
from ._scene import Bodies


class Losses(NamedTuple):
    """Energy that m contacts have lost, each ≥ 0 [J]."""

    friction: Array  #: by slip
    rescale: Array  #: by Mindlin's law, whose stiffness falls on unloading
    damper: Array  #: by dampers of the normal laws
    plastic_work: Array  #: by yielding
    adhesion_loss: Array  #: where adhesive contacts snap in and let go


class BodiesImpact(WithContacts, of=Bodies):
    """The impact of n :class:`Bodies` with m contacts: those that the scene names, then all others that have closed.

    Examples
    --------
    >>> import mariotte as mt
    >>> ball = mt.Bodies(dimension=2, law="hertz", tangential="rigid", friction=0.3, stiffness=1e9, share=0,
    ...                  body=[{"mass": 1, "radius": 0.1, "position": [0, 0.1], "velocity": [0, -1], "spin": 5}],
    ...                  plane=[{"normal": [0, 1]}])
    >>> hit = mt.simulate(ball)
    >>> hit.velocity.round(6), hit.spin.round(6), hit.between
    (array([[-0.142857,  1.      ]]), array([1.428571]), [('plane 1', 'body 1')])
    """

    __slots__ = ()

    @property
    def position(self) -> Array:
        """Of the mass centres at the end, of shape (n, 2) or (n, 3) [m]."""
        return self._run.position

    @property
    def velocity(self) -> Array:
        """Of the mass centres at the end, of shape (n, 2) or (n, 3) [m/s]."""
        return self._run.velocity

    @property
    def spin(self) -> Array:
        """At the end, of shape (n,) in the plane, or (n, 3), space axes [rad/s]."""
        return self._run.spin

    @property
    def angle(self) -> Array:
        """At the end of n bodies in the plane, above −π and at most π [rad]; 0 in space."""
        return self._run.angle

    @property
    def quaternion(self) -> Array:
        """Attitude at the end, w, x, y, z, of shape (n, 4)."""
        return self._run.quaternion

    @property
    def between(self) -> List[Tuple[str, str]]:
        """Names of the two of each of m contacts, a plane first: all pairs that may touch, as ``mariotte check`` lists
        them; of more than 200 those that the scene names, then those that have closed."""
        return self._run.between

    @property
    def normal_impulse(self) -> Array:
        """∫ f_n dt of m contacts [N s]."""
        return self._run.normal_impulse

    @property
    def tangential_impulse(self) -> Array:
        """∫ f_t dt on the second of the two, of shape (m, 3), or (m,) in the plane: along the normal turned by 90°
        [N s]."""
        return self._run.tangential_impulse

    @property
    def peak_friction(self) -> Array:
        """Of m contacts [N]."""
        return self._run.peak_friction

    @property
    def losses(self) -> Losses:
        """Energy that m contacts have lost [J]."""
        return Losses(*self._run.losses)
