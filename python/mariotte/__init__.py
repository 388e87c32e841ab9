"""Fast, exact impacts of ball chains, networks, microbodies and bodies with friction.

Make a scene with :class:`Chain`, :class:`Network`, :class:`Body`, :class:`Bodies` or :func:`load`, and
:func:`simulate` it. Numbers are in SI units, text may carry a unit, and indices count from 0.
"""

try:
    from ._core import version as __version__
except ModuleNotFoundError as missing:
    raise ModuleNotFoundError("the compiled part of mariotte is not there for this Python; ./dev python builds it",
                              name=missing.name) from missing
from ._errors import Error, FileError, FitError, InvalidParameter, ModelWarning, SceneError
from ._bodies import BodiesImpact, Losses
from ._events import Event, TipImpact
from ._impact import (ChainImpact, ContactImpact, Ending, Energy, Flow, Impact, MicrobodyImpact, Momentum,
                      NetworkImpact, Restitution, simulate)
from ._laws import LawOutcome, multiple_impact_law, rival_laws, with_law
from ._modes import BandEdges, Modes, Rest, modes
from ._numbers import Array
from ._scene import Bodies, Body, Chain, Network, Scene, load, parse
from ._sensitivity import Sensitivity, sensitivity, vjp
from ._studies import (CaptureVelocity, Estimate, Fit, RestitutionCurve, capture_velocity, fit, restitution)
from ._sweep import Solved, Sweep, solve, sweep
from ._trajectory import Samples, Trajectory

__all__ = [
    "Array", "BandEdges", "Bodies", "BodiesImpact", "Body", "CaptureVelocity", "Chain", "ChainImpact", "ContactImpact",
    "Ending", "Energy", "Error", "Estimate", "Event", "FileError", "Fit", "FitError", "Flow", "Impact",
    "InvalidParameter", "LawOutcome", "Losses", "MicrobodyImpact", "ModelWarning", "Modes", "Momentum", "Network",
    "NetworkImpact", "Rest", "Restitution", "RestitutionCurve", "Samples", "Scene", "SceneError", "Sensitivity",
    "Solved", "Sweep", "TipImpact", "Trajectory", "__version__", "capture_velocity", "fit", "load", "modes",
    "multiple_impact_law", "parse", "restitution", "rival_laws", "sensitivity", "simulate", "solve", "sweep", "vjp",
    "with_law",
]
