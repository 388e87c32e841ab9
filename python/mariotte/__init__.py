"""Fast, exact impacts of ball chains, networks and microbodies.

Make a scene with :class:`Chain`, :class:`Network`, :class:`Body` or :func:`load`, and :func:`simulate` it. Numbers are
in SI units, text may carry a unit, and indices count from 0.
"""

from ._core import version as __version__
from ._errors import Error, FileError, FitError, InvalidParameter, SceneError
from ._impact import (ChainImpact, ContactImpact, Ending, Energy, Event, Flow, Impact, MicrobodyImpact, Momentum,
                      NetworkImpact, Restitution, TipImpact, simulate)
from ._laws import LawOutcome, multiple_impact_law, rival_laws, with_law
from ._scene import Body, Chain, Network, Scene, load, parse
from ._sensitivity import Sensitivity, sensitivity
from ._studies import CaptureVelocity, Estimate, Fit, capture_velocity, fit
from ._sweep import Solved, Sweep, solve, sweep
from ._trajectory import Samples, Trajectory

__all__ = [
    "Body", "CaptureVelocity", "Chain", "ChainImpact", "ContactImpact", "Ending", "Energy", "Error", "Estimate", "Event",
    "FileError", "Fit", "FitError", "Flow", "Impact", "InvalidParameter", "LawOutcome", "MicrobodyImpact", "Momentum",
    "Network", "NetworkImpact", "Restitution", "Samples", "Scene", "SceneError", "Sensitivity", "Solved", "Sweep", "TipImpact",
    "Trajectory", "__version__", "capture_velocity", "fit", "load", "multiple_impact_law", "parse", "rival_laws",
    "sensitivity", "simulate", "solve", "sweep", "with_law",
]
