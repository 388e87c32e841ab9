"""What happens at instants of a run."""

from __future__ import annotations

import math
from typing import Any, Dict, List, NamedTuple, Tuple

Places = Tuple[int, ...]


class Event(NamedTuple):
    """What changes at one instant; contacts or tips count from 0."""

    time: float  #: [s]
    open: Places = ()
    close: Places = ()
    stick: Places = ()
    slip: Places = ()
    capture: Places = ()  #: tips that have turned back in the well of adhesion
    push: Places = ()  #: tips whose force turns positive
    pull: Places = ()  #: tips whose force turns negative
    yields: Places = ()  #: contacts that become plastic, for the first time or again
    unload: Places = ()  #: contacts whose indentation begins to fall
    load: Places = ()  #: contacts of bodies whose indentation grows again
    reverse: Places = ()  #: rigid contacts of bodies whose slip turns round
    slack: Places = ()  #: contacts of bodies whose damper takes all of the force, or that begin to pull
    grip: Places = ()  #: contacts of bodies that push again after that
    touch: Places = ()  #: contacts of bodies at rest at gap 0 that are pressed or part
    part: Places = ()  #: of these, those that part without a force


class TipImpact(NamedTuple):
    """One contact of one tip, from touch to separation; what is known only of its end is nan if it does not
    separate."""

    tip: int  #: from 0
    start: float  #: [s]
    end: float  #: [s]
    normal_velocity_in: float  #: of the tip [m/s]
    normal_velocity_out: float
    centre_velocity_in: float  #: of the mass centre, along the normal [m/s]
    centre_velocity_out: float
    slip_out: Tuple[float, float]  #: of the contact point along e2, e3 [m/s]
    peak_force: float  #: largest push [N]
    peak_pull: float  #: largest pull, ≥ 0 [N]
    peak_indentation: float  #: [m]


def event(one: Dict[str, Any]) -> Event:
    """From JSON, where contacts and tips count from 1."""
    signs = one.get("force_sign", [])
    places = {**one, "yields": one.get("yield", []), "push": [i for i in signs if i > 0],
              "pull": [-i for i in signs if i < 0]}
    return Event(one["time"], **{name: _from_zero(places.get(name, [])) for name in Event._fields[1:]})


def tip_impact(one: Dict[str, Any]) -> TipImpact:
    """From JSON, where tips count from 1 and what is not known is null."""
    known = {name: math.nan if value is None else value for name, value in one.items()}
    slip = (math.nan, math.nan) if one["slip_out"] is None else tuple(map(_or_nan, one["slip_out"]))
    return TipImpact(**{**known, "tip": one["tip"] - 1, "slip_out": slip})


def _or_nan(value: Any) -> float:
    return math.nan if value is None else float(value)


def _from_zero(numbers: List[int]) -> Places:
    return tuple(number - 1 for number in numbers)
