"""Impact laws, which take one step from the velocities before to those after; and contact laws of one's own."""

from __future__ import annotations

import ctypes
from typing import Any, Dict, NamedTuple, Optional, Sequence, TypeVar, Union

from . import _core
from ._numbers import Array, Numbers, listed, number
from ._scene import Chain, Network, Scene, box_of

S = TypeVar("S", bound=Scene[Any])
Function = Union[int, Any]  # an address, or what has one


class LawOutcome(NamedTuple):
    """What an impact law answers."""

    status: str  #: admissible, tensile_impulse, penetrating_velocity, complex, no_impact or unfinished
    reason: str  #: why it is not admissible; empty if it is
    velocity: Array  #: n values [m/s]; none if the status is complex
    impulse: Array  #: n − 1 values [N s]
    ratio_lab: float  #: T⁺/T⁻ in the given frame; nan if T⁻ = 0
    ratio_centre: float  #: the same relative to the mass centre
    least_energy_ratio: float  #: of the multiple-impact law: below it there is no real outcome


def multiple_impact_law(mass: Numbers, velocity: Numbers, *, icr: Optional[Numbers] = None,
                        direction: Optional[Numbers] = None, energy_ratio: float = 1.0,
                        frame: str = "given") -> LawOutcome:
    """Apply the multiple-impact law to balls on a line [Acary 2003, appendix A].

    Parameters
    ----------
    mass, velocity : array_like
        Of n balls from left to right [kg], [m/s]; an infinite mass is a wall.
    icr : array_like
        Ratios of neighbouring impulses, n − 2 values; or else
    direction : array_like
        the impulses up to their size, n − 1 values.
    energy_ratio : float
        T⁺/T⁻ ≥ 0. Above 1 the impact gains energy, which only contacts that are pressed before it can give.
    frame : {"given", "mass-centre"}
        Whose kinetic energies the ratio compares.

    Raises
    ------
    InvalidParameter
        For input that makes no sense. An outcome that is not admissible is told by its status.

    Examples
    --------
    >>> import mariotte as mt
    >>> mt.multiple_impact_law([1, 1, 1], [1, 0, 0], icr=[1.0768217704]).velocity.round(6)
    array([-0.070952,  0.076403,  0.994549])
    """
    if (icr is None) == (direction is None):
        raise TypeError("give icr or direction")
    if frame not in ("given", "mass-centre"):
        raise ValueError(f"frame must be given or mass-centre, not {frame}")
    ratios = () if icr is None else icr
    along = listed(direction) if direction is not None else _core.direction_of_ratios(listed(ratios))
    return LawOutcome(*_core.multiple_impact_law(listed(mass, "kg"), listed(velocity, "m/s"), along,
                                                 number(energy_ratio, "energy_ratio"), frame == "mass-centre"))


def rival_laws(mass: Numbers, velocity: Numbers, *, restitution: float = 1.0, stiffness: Numbers = (),
               exponent: float = 1.5, direction: Numbers = ()) -> Dict[str, LawOutcome]:
    """What the usual impact laws answer, by name: Newton, Poisson, Moreau, sequential collisions and others.

    Parameters
    ----------
    mass, velocity : array_like
        Of n balls from left to right [kg], [m/s].
    restitution : float
        e of every contact, 0 ≤ e ≤ 1.
    stiffness, exponent : array_like, float
        Of the distribution law of Liu, Zhao and Brogliato, one per contact; equal ones if there are none.
    direction : array_like
        Impulses up to their size, for the law of Ceanga and Hurmuzlu.

    Examples
    --------
    >>> import mariotte as mt
    >>> mt.rival_laws([1, 1, 1], [1, 0, 0])["by-event"].velocity
    array([0., 0., 1.])
    """
    made = _core.rival_laws(listed(mass, "kg"), listed(velocity, "m/s"), number(restitution, "restitution"),
                            listed(stiffness), number(exponent, "exponent"), listed(direction))
    return {name: LawOutcome(*outcome) for name, outcome in made.items()}


def with_law(scene: S, *, force: Function, stored_energy: Function, name: str = "own", dissipates: bool = False,
             contacts: Optional[Sequence[int]] = None) -> S:
    """The scene with a contact law of your own, compiled: no Python runs while it is followed.

    CVODE follows contacts of such a law. The scene cannot be pickled or swept, since no text says what the law is.

    Parameters
    ----------
    force : int, or a function of numba.cfunc or ctypes
        Address of ``void force(double indentation, double rate, double out[3])``. It writes the force [N] and its
        slopes ∂f/∂δ and ∂f/∂δ̇ at δ ≥ 0 [m] and any rate [m/s].
    stored_energy : int, or a function of numba.cfunc or ctypes
        Address of ``double stored_energy(double indentation)``: elastic energy [J], 0 at 0, and grows with δ.
    name : str
        As results call it.
    dissipates : bool
        Whether the force depends on the rate.
    contacts : sequence of int, optional
        Which contacts, from 0; all if left out.

    Examples
    --------
    >>> import ctypes, mariotte as mt
    >>> Force = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
    >>> Energy = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)
    >>> @Force
    ... def cone(depth, rate, out):
    ...     out[0], out[1], out[2] = 1e9 * depth**2, 2e9 * depth, 0
    >>> energy = Energy(lambda depth: 1e9 * depth**3 / 3)
    >>> pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness=1)
    >>> mt.simulate(mt.with_law(pair, force=cone, stored_energy=energy)).velocity.round(9)
    array([0., 1.])
    """
    box_of(scene)
    places = range(_contacts(scene)) if contacts is None else contacts
    if len(places) == 0:
        raise ValueError("contacts is empty: no contact would have the law")
    double = ctypes.c_double
    of_force, of_energy = _address(force, None, double, double, None), _address(stored_energy, double, double)
    made = type(scene)._of(_core.with_law(scene._box, name, of_force, of_energy, dissipates, list(places),
                                          (force, stored_energy)))
    assert isinstance(made, type(scene))
    return made


def _contacts(scene: Scene[Any]) -> int:
    if isinstance(scene, (Chain, Network)):
        return len(scene.gap)
    raise TypeError(f"only contacts of chains and networks take a law, and {scene!r} has none")


def _address(function: Function, result: Any, *arguments: Any) -> int:
    """Of a compiled function; one whose prototype is known must have this one. A last argument of None is a pointer."""
    if isinstance(function, int) and not isinstance(function, bool) and function > 0:
        return function
    typed = getattr(function, "ctypes", function)  # numba.cfunc has one
    if not isinstance(typed, ctypes._CFuncPtr):  # type: ignore[attr-defined]
        raise TypeError(f"a contact law needs compiled functions of C, or their addresses: {function!r} is none")
    known = typed.argtypes
    if known is not None and not (typed.restype is result and len(known) == len(arguments) and all(
            have is want or (want is None and have is not ctypes.c_double) for have, want in zip(known, arguments))):
        raise TypeError(f"a function of another prototype: {', '.join(one.__name__ for one in known)} are its arguments, "
                        f"{getattr(typed.restype, '__name__', None)} its result")
    return ctypes.cast(typed, ctypes.c_void_p).value or 0
