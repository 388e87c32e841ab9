"""Many impacts: sweeps over keys of a scene, and chains as arrays."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterable, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._columns import extents, from_start, key_of_result, matches, names
from ._errors import InvalidParameter, SceneError, in_python, warn
from ._files import save
from ._impact import Ending
from ._keys import whole_key
from ._numbers import Array, Numbers, counted, number, numbers, whole
from ._scene import Chain, Path, Scene, box_of_text
from ._toml import plain

_Asked = Tuple[List[Tuple[str, List[Any], bool]], List[str]]  # axes and columns, as the scene would say them
Axes = Mapping[Any, Any]  # values by key, or by a tuple of keys
Endings = npt.NDArray[np.uint8]
_NO_ELEMENT = "S017"  # the code of a key that leads nowhere


class Sweep(Mapping[str, Array]):
    """Numbers over a grid of values; ``grid[column]`` has the shape of the grid, and more axes if the column stands
    for several numbers.

    Columns are views of one table with a row per point, read-only. Where a point has no number stands nan; `ending`
    and `reasons` say why. A sweep is pickled with its numbers.
    """

    def __init__(self, scene: Scene[Any], run: _core.Sweep, asked: _Asked) -> None:
        self.scene = scene
        self._run = run
        self._asked = asked

    @property
    def shape(self) -> Tuple[int, ...]:
        """Points along each axis."""
        return tuple(self._run.shape)

    @property
    def axes(self) -> Dict[str, npt.NDArray[Any]]:
        """What was varied: values in SI, or words, by key."""
        return {key: np.asarray(values) for key, _, values, _ in self._run.parameters}

    @property
    def axis_of(self) -> Dict[str, int]:
        """The axis of the grid along which each key moves."""
        return {key: axis for key, axis, _, _ in self._run.parameters}

    @property
    def table(self) -> Array:
        """All numbers, of shape (points, columns), the last axis of the grid fastest."""
        return self._run.table

    @property
    def units(self) -> Dict[str, str]:
        """SI unit of each axis and column; "1" of pure numbers, nothing of text and formulas."""
        return {**{key: unit for key, _, _, unit in self._run.parameters},
                **{key: unit for key, unit, _, _ in self._run.columns}}

    @property
    def symbols(self) -> Dict[str, str]:
        """Symbol of each column, as figures write it; may be empty."""
        return {key: symbol for key, _, symbol, _ in self._run.columns}

    @property
    def ending(self) -> Endings:
        """How each point ended, as numbers of :class:`mariotte.Ending`, of the shape of the grid."""
        return self._run.ending.reshape(self.shape)

    @property
    def reasons(self) -> Dict[int, str]:
        """Why points have no numbers, ended at a limit, or are less exact than was asked, by the row of the table."""
        return self._run.reasons

    @property
    def warnings(self) -> List[str]:
        """What has to be said of the scene, and whether points are less exact than was asked; :func:`sweep` warns of
        each. Limits of laws are columns, such as ``validity.yield_ratio``."""
        return [in_python(text) for text in self._run.warnings]

    def __getitem__(self, column: str) -> Array:
        found = self._matches(column)
        if not found:
            raise KeyError(f"{column} is no column of this sweep: {self._some_columns()}")
        places, shape = list(found), [*self.shape, *extents(found.values())]
        if places == list(range(places[0], places[-1] + 1)):
            return self.table[:, places[0] : places[-1] + 1].reshape(shape)
        return self.table[:, places].reshape(shape)

    def __iter__(self) -> Iterator[str]:
        return (key for key, _, _, _ in self._run.columns)

    def __len__(self) -> int:
        return len(self._run.columns)

    def __repr__(self) -> str:
        things = "point" if self.ending.size == 1 else "points"
        return f"<mariotte.Sweep of {' × '.join(map(str, self.shape))} {things}: {self._some_columns()}>"

    def _some_columns(self) -> str:
        """The first, and how many there are."""
        most, keys = 8, list(self)
        return ", ".join(keys[:most]) + (f", … {len(keys)} columns" if len(keys) > most else "")

    def save(self, path: Path) -> None:
        """Write all points as the command does: as CSV if the name ends in .csv, as HDF5 if in .h5 or .hdf5. A file of
        this name is replaced."""
        save(path, {".csv": self._run.save_csv, ".h5": self._run.save_hdf5, ".hdf5": self._run.save_hdf5})

    @property
    def plot(self) -> Any:
        """Figures: ``grid.plot(column)`` draws curves along one axis, and over two a map, or a curve per value of a short
        one."""
        from ._plot import SweepPlot

        return SweepPlot(self)

    def keys_of(self, column: str) -> List[str]:
        """Keys of the columns that a name stands for: ``velocity`` is ``final.velocity[0]``, …"""
        keys = list(self)
        return [keys[place] for place in self._matches(column)]

    def __eq__(self, other: object) -> bool:
        """The same scene over the same grid, with the same numbers."""
        if not isinstance(other, Sweep):
            return NotImplemented
        return (self.scene == other.scene and self._asked == other._asked
                and np.array_equal(self.table, other.table, equal_nan=True)
                and np.array_equal(self.ending, other.ending))

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (self.scene, self._asked, self.table, self._run.ending, self.reasons)

    def _matches(self, column: str) -> Dict[int, Tuple[int, ...]]:
        keys = list(self)
        return matches(from_start(key_of_result(self.scene, column), keys), keys)


def sweep(scene: Scene[Any], axes: Optional[Axes] = None, *, columns: Union[str, Sequence[str], None] = None,
          accuracy: Optional[float] = None, until: Union[float, str, None] = None,
          threads: Optional[int] = None) -> Sweep:
    """Simulate a scene for all values of some of its keys.

    Other threads of Python run meanwhile; Ctrl-C ends it.

    Parameters
    ----------
    scene : Scene
        What collides.
    axes : dict, optional
        Values by key, an axis of the grid each, the last one the fastest. The name of the model may be left out:
        ``velocity[0]`` is ``chain.velocity[0]``. A tuple of keys with a tuple of arrays moves together along one
        axis. If it is left out, the scene says by ``[[sweep]]`` what is varied.
    columns : str or sequence of str
        What to compute: members of results, such as ``velocity``, or keys of their JSON, such as
        ``contacts[1].peak_force`` and ``events.count``. Without any those that say most.
    accuracy : float, optional
        Goes before what the scene says.
    until : float or str, optional
        End of every run [s], instead of `run.until` of the scene. Long rows rattle on for long after a wave.
    threads : int, optional
        How many points at once; one per core that this process may use.

    Returns
    -------
    Sweep

    Raises
    ------
    SceneError, InvalidParameter
        For keys, values and columns that make no sense at any point. Points that make no sense in some company only
        end as ``Ending.rejected``.

    Warns
    -----
    ModelWarning
        Of values of the scene that look like a mistake, once, not at each point.

    Examples
    --------
    >>> import numpy as np, mariotte as mt
    >>> triplet = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
    >>> grid = mt.sweep(triplet, {"stiffness[1]": np.geomspace(0.1, 10, 5), "velocity[2]": [-1, 0]},
    ...                 columns=["velocity", "icr[0]"])
    >>> grid["velocity"].shape, grid["icr[0]"].shape
    ((5, 2, 3), (5, 2))
    >>> grid["icr[0]"][2, 1].round(6)
    1.076822
    """
    box_of_text(scene)
    if not isinstance(axes or {}, Mapping):
        raise TypeError(f"values by key are needed, not {axes!r}")
    if accuracy is not None:
        scene = scene.replace({"run.accuracy": number(accuracy, "accuracy")})
    if until is not None:
        scene = scene.replace({"run.until": until})
    listed = _axes(scene, axes or {})
    if isinstance(scene, Chain):
        scene = _with_elements(scene, [key for key, _, _ in listed if key.startswith("chain.gap[")])
    keys = [key_of_result(scene, column) for column in names(() if columns is None else columns)]
    grid = Sweep(scene, _core.sweep(scene._box, listed, keys, _workers(threads)), (listed, keys))
    warn(grid.warnings)
    return grid


def _restored(scene: Scene[Any], asked: _Asked, table: Array, ending: Endings, reasons: Dict[int, str]) -> Sweep:
    return Sweep(scene, _core.restored_sweep(scene._box, *asked, table, ending, reasons), asked)


def _with_elements(scene: Chain, gaps: Sequence[str]) -> Chain:
    """One gap for all contacts, or none, has no elements to vary; resolved gaps may be indented already."""
    try:
        scene.replace({key: 1.0 for key in gaps})
    except SceneError as error:
        if error.code == _NO_ELEMENT:
            return scene.replace({"chain.gap": scene.gap})
    return scene


class Solved(NamedTuple):
    """What :func:`solve` returns; nan where a run could not go on, as `ending` says.

    Examples
    --------
    >>> import mariotte as mt
    >>> many = mt.solve([1, 1, 1], [1, 1], [[1, 0, 0], [2, 0, 0]])
    >>> many
    <mariotte.Solved of 2 chains of 3 balls: 2 separated>
    >>> many.ending == mt.Ending.separated
    array([ True,  True])
    """

    velocity: Array  #: after the impact, of shape (N, n) [m/s]
    impulse: Array  #: of each contact, of shape (N, n − 1) [N s]
    time: Array  #: of the ending, of shape (N,) [s]
    ending: Endings  #: numbers of :class:`mariotte.Ending`, of shape (N,)
    #: upper bound on the error of the velocities relative to the largest incident speed, of shape (N,); nan where none
    #: was estimated, infinite where nothing bounds it
    estimated_accuracy: Array

    @property
    def icr(self) -> Array:
        """Impulse correlation ratios α_j = p_j/p_{j+1}, of shape (N, n − 2); nan where p_{j+1} = 0 or noise."""
        left, right = self.impulse[:, :-1], self.impulse[:, 1:]
        return np.divide(left, right, out=np.full(left.shape, np.nan), where=right != 0)

    def __repr__(self) -> str:
        count = np.bincount(self.ending)
        ends = ", ".join(f"{count[one]} {Ending(one)}" for one in np.flatnonzero(count))
        chains, balls = counted(len(self.velocity), "chain"), counted(self.velocity.shape[1], "ball")
        return f"<mariotte.Solved of {chains} of {balls}: {ends}>"


def solve(mass: Numbers, stiffness: Numbers, velocity: Numbers, *, gap: Numbers = 0.0,
          damping: Numbers = 0.0, law: str = "hertz", exponent: Optional[float] = None,
          accuracy: float = 1e-10, threads: Optional[int] = None) -> Solved:
    """Solve N chains of n balls at once, for Monte Carlo or an optimiser of your own.

    Parameters
    ----------
    mass, velocity : array_like
        Real, of shape (N, n), or what can be spread to that; N may be 0 [kg], [m/s]. An infinite mass is a wall.
    stiffness, gap, damping : array_like
        Of shape (N, n − 1), or what can be spread to that; k in N/m^n, gaps in m, damping in the unit of the law.
    law : str
        ``linear`` or ``hertz``, which have no damping; ``viscoelastic``, ``kelvin-voigt``, ``kuwabara-kono``,
        ``hunt-crossley`` or ``tsuji``. A sweep takes all other laws of scenes.
    exponent : float, optional
        n ≥ 1 of ``viscoelastic`` and ``hunt-crossley``, which leave it open; 3/2 if it is left out.
    accuracy : float
        Wanted error of the final velocities relative to the largest incident speed.
    threads : int, optional
        How many chains at once; one per core that this process may use.

    Returns
    -------
    Solved

    Raises
    ------
    InvalidParameter
        For an array of the wrong shape, by its name, or the first row that makes no sense, by its number from 0; for a
        damping or an exponent that the law does not have.

    Examples
    --------
    >>> import numpy as np, mariotte as mt
    >>> speed = np.linspace(1, 2, 1000)
    >>> many = mt.solve(1.0, [1e9, 1e9], np.stack([speed, 0 * speed, 0 * speed], axis=1))
    >>> many.velocity.shape, (many.velocity[:, 2] / speed).std().round(9)
    ((1000, 3), 0.0)
    """
    of_balls = {"mass": _rows("mass", mass, "kg"), "velocity": _rows("velocity", velocity, "m/s")}
    of_contacts = {"stiffness": _rows("stiffness", stiffness), "gap": _rows("gap", gap, "m"),
                   "damping": _rows("damping", damping)}
    balls = max(one.shape[1] for one in of_balls.values())
    rows = _count(one.shape[0] for one in (*of_balls.values(), *of_contacts.values()))
    m, v = (_spread(name, one, rows, balls) for name, one in of_balls.items())
    k, g, c = (_spread(name, one, rows, balls - 1) for name, one in of_contacts.items())
    n = None if exponent is None else number(exponent, "exponent")
    asked = number(accuracy, "accuracy")
    made = Solved(*_core.solve(rows, m, k, v, g, c, law, n, asked, _workers(threads)))
    doubtful = int(np.sum(made.estimated_accuracy > asked))
    if doubtful:
        warn([f"velocities of {counted(doubtful, 'chain')} may be less exact than was asked: see estimated_accuracy"])
    return made


def _count(lengths: Iterable[int]) -> int:
    """Rows of all arrays together, of which some may have one for all."""
    return max({*lengths} - {1}, default=1)


def _rows(name: str, values: Numbers, unit: str = "") -> Array:
    """An argument with a row per chain."""
    try:
        array = np.atleast_2d(numbers(values, unit))
    except ValueError:
        raise _wrong(name, "is no array of real numbers in rows of one length", "S013") from None
    if np.isnan(array).any():
        row = int(np.isnan(array).any(axis=tuple(range(1, array.ndim))).argmax())
        raise _wrong(name, f"has a value that is not a number in row {row}", "S034", f"row {row}")
    if array.ndim > 2:
        raise _wrong(name, f"has the shape {array.shape}, but one or two dimensions are expected", "S024")
    return array


def _spread(name: str, array: Array, rows: int, length: int) -> Array:
    """Rows of this length; one row stays one."""
    if array.shape[0] not in (1, rows) or array.shape[1] not in (1, length):
        raise _wrong(name, f"has the shape {array.shape}, but {(rows, length)} is expected, or 1 in place of either: "
                     "rows are chains, (chains, balls) of mass and velocity, (chains, contacts) of all others", "S024")
    return np.ascontiguousarray(np.broadcast_to(array, (array.shape[0], length)))


def _wrong(name: str, why: str, code: str, place: str = "") -> InvalidParameter:
    return InvalidParameter(f"{name} {why}", code, name, place)


def _workers(threads: Optional[int]) -> int:
    if threads is not None:
        return min(whole(threads, "threads"), 10**6)  # so that it is a number in C++, too, which refuses it
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _axes(scene: Scene[Any], axes: Axes) -> List[Tuple[str, List[Any], bool]]:
    listed = []
    for keys, values in axes.items():
        if not isinstance(keys, (str, tuple)):
            raise TypeError(f"an axis is a key, or a tuple of keys that move together, not {keys!r}")
        together = (keys,) if isinstance(keys, str) else keys
        columns = (values,) if isinstance(keys, str) else values
        if len(together) != len(columns):
            raise ValueError(f"{len(together)} keys move together, by {len(columns)} rows of values: {keys}")
        for place, (key, column) in enumerate(zip(together, columns)):
            listed.append((whole_key(scene._box.kind, key), _values(key, column), place > 0))
    return listed


def _values(key: str, values: Any) -> List[Any]:
    values = plain(values)
    if isinstance(values, str) or getattr(values, "ndim", 1) != 1 or not hasattr(values, "__iter__"):
        raise ValueError(f"the values of {key} are not one row: {values!r}")
    listed: List[Any] = values.tolist() if hasattr(values, "tolist") else list(values)
    return [_value(one) for one in listed]


def _value(one: Any) -> Any:
    one = plain(one)
    if isinstance(one, np.floating):  # however long
        return float(one)
    return one.item() if hasattr(one, "item") else one
