"""Fast, exact impacts of ball chains, networks and microbodies.

Make a scene with :class:`Chain`, :class:`Network`, :class:`Body` or :func:`load`, and :func:`simulate` it. Numbers are
in SI units, text may carry a unit, and indices count from 0.
"""

from ._core import version as __version__
from ._errors import Error, FileError, FitError, InvalidParameter, SceneError
from ._impact import (ChainImpact, ContactImpact, Ending, Energy, Event, Flow, Impact, MicrobodyImpact, Momentum,
                      NetworkImpact, Restitution, TipImpact, simulate)
from ._scene import Body, Chain, Network, Scene, load, parse

__all__ = [
    "Body", "Chain", "ChainImpact", "ContactImpact", "Ending", "Energy", "Error", "Event", "FileError", "FitError",
    "Flow", "Impact", "InvalidParameter", "MicrobodyImpact", "Momentum", "Network", "NetworkImpact", "Restitution",
    "Scene", "SceneError", "TipImpact", "__version__", "load", "parse", "simulate",
]
