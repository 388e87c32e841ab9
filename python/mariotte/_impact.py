"""One impact: simulation of a scene, and all that its result says."""

from __future__ import annotations

import difflib
import enum
import html
import json
from typing import TYPE_CHECKING, Any, ClassVar, Dict, List, NamedTuple, Optional, Sequence, Tuple, Type, Union

import numpy as np

from . import _core
from ._columns import key_of_result
from ._errors import in_python, warn
from ._events import Event, TipImpact, event, tip_impact
from ._files import save
from ._numbers import Array, Numbers, counted, number, whole
from ._scene import Body, Chain, Network, Path, Result, Scene, box_of
from ._sensitivity import Sensitivity, sensitivity
from ._toml import plain
from ._trajectory import Trajectory

if TYPE_CHECKING:
    from ._plot import ImpactPlot

Time = Union[float, str]


class Ending(enum.IntEnum):
    """How a run ends."""

    separated = 0  #: no contact carries force and no two bodies can meet again
    captured = 1  #: a tip has turned back in the well of adhesion
    bound = 2  #: adhesion holds bodies together for ever
    time_limit = 3  #: `until` or `max_time` was reached
    event_limit = 4  #: `max_events` was reached
    interrupted = 5  #: it was given up; what was computed until then is kept
    unsure = 6  #: it came to an end, but a balance does not close
    invalid = 7  #: it came to an end, but beyond where any contact law holds
    failed = 8  #: a flow could not go on; what was computed until then is kept
    rejected = 9  #: of a point of a sweep: its values together are no scene

    def __str__(self) -> str:
        return self.name

    def __format__(self, spec: str) -> str:
        return format(int(self) if spec.endswith("d") else self.name, spec)


class Energy(NamedTuple):
    """final + stored + dissipated − initial − work = residual [J]."""

    initial: float  #: kinetic and elastic energy at the start
    final: float  #: kinetic energy at the end
    stored: float  #: in closed contacts at the end
    dissipated: float
    work: float  #: of gravity, moving walls and forces
    residual: float  #: error of the balance


class Momentum(NamedTuple):
    """Of the balls of finite mass [N s]."""

    initial: float
    final: float
    residual: float  #: final − initial − impulses of walls and gravity


class Flow(NamedTuple):
    """What one method did in a run."""

    name: str
    phases: int
    steps: int
    rhs: int  #: evaluations of the right-hand side


class Restitution(NamedTuple):
    """Rebound over incident normal velocity of the first impact; nan if it has not ended."""

    tip: float
    centre: float  #: of the mass centre


class Impact:
    """The result of a run. Arrays are read-only and share the memory of the result.

    Jupyter shows the report of the command, and so does ``print``. A result is pickled as its scene, and computed
    again where it is needed.
    """

    __slots__ = ("scene", "_run", "_options")
    _of: ClassVar[Dict[Type[Scene[Any]], Type["Impact"]]] = {}

    def __init_subclass__(cls, *, of: Optional[Type[Scene[Any]]] = None) -> None:
        if of:
            Impact._of[of] = cls

    def __init__(self, scene: Scene[Any], run: _core.Impact, options: Tuple[Any, ...]) -> None:
        self.scene = scene
        self._run = run
        self._options = options

    @property
    def ending(self) -> Ending:
        """How the run ended."""
        return Ending(self._run.ending)

    @property
    def message(self) -> str:
        """Why, for endings other than separated and captured; else empty."""
        return in_python(self._run.message)

    @property
    def warnings(self) -> List[str]:
        """What has to be said beside the numbers, of the scene and of the run; :func:`simulate` warns of each."""
        return [in_python(text) for text in self._run.warnings]

    @property
    def time(self) -> float:
        """Of the ending [s]."""
        return self._run.time

    @property
    def velocity(self) -> Array:
        """At the end: of n balls [m/s] or degrees of freedom; of mass centres of bodies, of a microbody the normal one
        first."""
        return self._run.velocity

    def sensitivity(self, *, to: Union[str, Sequence[str]] = ()) -> Sensitivity:
        """Slopes of the outcome by these parameters of its scene, see :func:`sensitivity`."""
        return sensitivity(self.scene, to=to)

    @property
    def energy(self) -> Energy:
        """The balance of energy [J]."""
        return Energy(*(self[f"energy.{name}"] for name in Energy._fields))

    @property
    def estimated_accuracy(self) -> float:
        """Upper bound on the error of the velocities, relative to the largest incident speed; nan if none was
        estimated, by a run that doubted itself or because of ``simulate(…, estimate=True)``. Infinite where nothing
        bounds it, as a warning says."""
        return float(self["accuracy.estimated"])

    @property
    def events(self) -> List[Event]:
        """Instants at which contacts or friction change, in order of time."""
        return [event(one) for one in self.json()["events"]]

    @property
    def flows(self) -> List[Flow]:
        """Methods that followed at least one phase."""
        return [Flow(**one) for one in self.json()["flows"]]

    @property
    def trajectory(self) -> "Trajectory":
        """Velocities, gaps and forces at any time of the run."""
        return Trajectory(self)

    def force(self, t: Numbers) -> Array:
        """Of the contacts, or the normal force of the tips, at times `t`: ``trajectory.force(t)`` [N]."""
        return self.trajectory.force(t)

    @property
    def plot(self) -> "ImpactPlot":
        """Figures, by matplotlib: ``hit.plot.forces()``, ``velocities()``, ``energy()`` and ``waves()``; of bodies
        ``friction()`` and ``spins()``."""
        from ._plot import ImpactPlot

        return ImpactPlot(self)

    def save(self, path: Path) -> None:
        """Write the result as the command does: all of it as JSON if the name ends in .json, the trace, one row per
        step, if in .csv, .h5 or .hdf5. Beside a CSV its name with ``-metadata.json`` tells where it comes from, with
        unit and meaning of each column. A file of this name is replaced."""
        run = self._run
        save(path, {".json": run.save_json, ".csv": run.save_csv, ".h5": run.save_hdf5, ".hdf5": run.save_hdf5})

    def cite(self) -> str:
        """What to cite, as BibTeX: this version of mariotte with this scene, and the papers of the model.

        Examples
        --------
        >>> import mariotte as mt
        >>> hit = mt.simulate(mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness=1))
        >>> hit.cite().splitlines()[0]
        '@software{mariotte,'
        """
        return self._run.to_cite()

    def __getitem__(self, key: str) -> Any:
        """A number of the result by the key it has in JSON, in SI units; nan where it is undefined. A name that a sweep
        takes as a column, as ``velocity``, is that member, and ``velocity[1]`` a number of it. A key with ``[*]`` is
        an array of the numbers that it stands for.

        Raises
        ------
        KeyError
            For a key that no such result has, and for an index beyond what this one has.

        Examples
        --------
        >>> import mariotte as mt
        >>> hit = mt.simulate(mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness=1))
        >>> round(hit["contacts[0].peak_force"], 6)
        0.754272
        >>> hit["velocity"].round(6)
        array([0., 1.])
        >>> round(hit["velocity[1]"], 6)
        1.0
        >>> hit["final.velocity[*]"].round(6)
        array([0., 1.])
        """
        whole = key_of_result(self.scene, key)
        if whole != key and key.isidentifier():
            return getattr(self, key)
        if hasattr(type(self), key):
            raise KeyError(f"{key} is no number but a member of results, as in hit.{key}")
        return self._numbers(whole)

    def _numbers(self, key: str) -> Union[float, Array]:
        """With an axis per star."""
        if "[*]" not in key:
            return self._run.number(key)
        rows = [self._numbers(one) for one in self._run.keys(key)]
        if len({np.shape(row) for row in rows}) > 1:
            raise KeyError(f"{key} stands for rows of different lengths: give the first index")
        return np.array(rows)

    if not TYPE_CHECKING:  # which knows all members

        def __getattr__(self, name: str) -> Any:
            known = [one for one in dir(type(self)) if not one.startswith("_")]
            near = difflib.get_close_matches(name, known, n=1)
            hint = f"did you mean {near[0]}?" if near else f"it has {', '.join(known)}"
            raise AttributeError(f"{type(self).__name__} has no {name}: {hint}")

    def json(self) -> Dict[str, Any]:
        """All of the result, as `mariotte run --json` prints it; there contacts and balls count from 1."""
        made: Dict[str, Any] = json.loads(self._run.json())
        return made

    def __str__(self) -> str:
        return self._run.table() + "".join(f"\nwarning: {text}" for text in self.warnings)

    def __repr__(self) -> str:
        warned = f", {counted(len(self.warnings), 'warning')}" if self.warnings else ""
        return f"<mariotte.{type(self).__name__}: {self.ending.name} at {self.time:.6g} s{warned}>"

    def _repr_html_(self) -> str:
        return (f"<pre>{html.escape(str(self))}</pre>"
                "<small>Here balls and contacts count from 1; in arrays they count from 0.</small>")

    def __reduce__(self) -> Tuple[Any, ...]:
        return _simulated, (self.scene, self._options)


class WithContacts(Impact):
    """A result with m contacts, of whatever touches."""

    __slots__ = ()

    @property
    def peak_force(self) -> Array:
        """Largest normal force of m contacts [N]."""
        return self._run.peak_force

    @property
    def peak_indentation(self) -> Array:
        """Of m contacts [m]."""
        return self._run.peak_indentation

    @property
    def stored(self) -> Array:
        """Elastic energy of m contacts at the end [J]."""
        return self._run.stored

    @property
    def periods(self) -> List[Array]:
        """Per contact an array of shape (k, 2): start and end of its k periods of force [s]; nan for an end that
        never came."""
        return self._run.periods


class ContactImpact(WithContacts):
    """Of m contacts between n balls, or of n degrees of freedom."""

    __slots__ = ()

    @property
    def impulse(self) -> Array:
        """p_j = ∫ f_j dt of m contacts [N s]."""
        return self._run.impulse

    @property
    def icr(self) -> Array:
        """Impulse correlation ratios α_j = p_j/p_{j+1}, m − 1 values; nan where p_{j+1} = 0 or noise [Acary 2003, eq. 5]."""
        return self._run.icr

    @property
    def impulse_direction(self) -> Array:
        """r = p/abs(p), m values; zeros if no impulse was exchanged."""
        return self._run.impulse_direction

    @property
    def gap(self) -> Array:
        """Of m contacts at the end [m], negative in contact."""
        return self._run.gap

    @property
    def dissipated(self) -> Array:
        """Energy that m contacts have lost [J]."""
        return self._run.dissipated

    @property
    def plastic_work(self) -> Array:
        """Of it, what m contacts have lost by yielding [J]."""
        return self._run.plastic_work

    @property
    def adhesion_loss(self) -> Array:
        """Of it, what m contacts have lost where adhesion snapped in and gave way [J]."""
        return self._run.adhesion_loss

    @property
    def permanent_indentation(self) -> Array:
        """Depth of the dent at which each of m contacts closes again [m]."""
        return self._run.permanent_indentation


class ChainImpact(ContactImpact, of=Chain):
    """The impact of a :class:`Chain`.

    Examples
    --------
    >>> import mariotte as mt
    >>> cradle = mt.Chain(balls=3, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0])
    >>> hit = mt.simulate(cradle)
    >>> hit.ending, hit.velocity.round(6), hit.icr.round(6)
    (<Ending.separated: 0>, array([-0.070952,  0.076403,  0.994549]), array([1.076822]))
    """

    __slots__ = ()

    @property
    def momentum(self) -> Momentum:
        """The balance of momentum [N s]."""
        return Momentum(*(self[f"momentum.{name}"] for name in Momentum._fields))


class NetworkImpact(ContactImpact, of=Network):
    """The impact of a :class:`Network`."""

    __slots__ = ()


class MicrobodyImpact(Impact, of=Body):
    """The impact of a :class:`Body`. e1 is normal to the plane; e2 and e3 lie in it."""

    __slots__ = ()

    @property
    def position(self) -> Array:
        """Of the mass centre at the end: height over the plane, then way along e2 and e3 [m]."""
        return self._run.position

    @property
    def spin(self) -> Array:
        """Angular velocity at the end, space axes [rad/s]."""
        return self._run.spin

    @property
    def restitution(self) -> Restitution:
        """Of the first impact."""
        return Restitution(self["restitution.tip"], self["restitution.centre"])

    @property
    def impacts(self) -> List[TipImpact]:
        """Contacts of the tips, in order of time."""
        return [tip_impact(one) for one in self.json()["impacts"]]


def simulate(scene: Scene[Result], *, accuracy: Optional[float] = None, until: Optional[Time] = None,
             max_time: Optional[Time] = None, max_events: Optional[int] = None,
             flow: Optional[str] = None, estimate: bool = False) -> Result:
    """Simulate a scene until its bodies part for good, or a limit.

    Other threads of Python run meanwhile. Ctrl-C ends a run of more than a moment.

    Parameters
    ----------
    scene : Scene
        What collides.
    accuracy : float, optional
        Wanted error of the final velocities relative to the largest incident speed; this and the next go before what
        the scene says.
    until : float or str, optional
        The end that is wanted [s].
    max_time : float or str, optional
        A limit [s].
    max_events : int, optional
        A limit: instants at which contacts or friction change.
    flow : str, optional
        Method for the contact phases, as in scene files.
    estimate : bool
        Whether `estimated_accuracy` is wanted: a second, tighter run tells it, as by ``--estimate`` of the command.

    Returns
    -------
    ChainImpact, NetworkImpact, MicrobodyImpact or BodiesImpact
        Ending, time, velocities, impulses and their ratios of a chain of less than 48 balls are known at once; all
        else is computed when it is asked for.

    Raises
    ------
    InvalidParameter
        For an accuracy, limit or flow that makes no sense.

    Warns
    -----
    ModelWarning
        Of each text in `warnings` of the result.

    Examples
    --------
    >>> import mariotte as mt
    >>> pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness="1e9 N/m^1.5")
    >>> mt.simulate(pair, until="1 us").ending
    <Ending.time_limit: 3>
    """
    if until is not None and max_time is not None:
        raise TypeError("give until, the end that is wanted, or max_time, a limit")
    if not (flow is None or isinstance(flow, str)):
        raise TypeError(f"flow is a word, such as 'taylor', not {flow!r}")
    if not isinstance(estimate, (bool, np.bool_)):
        raise TypeError(f"estimate is True or False, not {estimate!r}")
    tight = None if accuracy is None else number(accuracy, "accuracy")
    most = None if max_events is None else whole(max_events, "max_events")
    made = _simulated(scene, (tight, plain(until), plain(max_time), most, flow, bool(estimate)))
    warn(made.warnings)
    result: Result = made
    return result


def _simulated(scene: Scene[Any], options: Tuple[Any, ...]) -> Any:
    return Impact._of.get(type(scene), Impact)(scene, _core.simulate(box_of(scene), *options), options)
