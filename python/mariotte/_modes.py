"""Small vibrations of rows and networks about their static equilibrium."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, NamedTuple, Optional

import numpy as np

from . import _core
from ._numbers import Array, Numbers, numbers
from ._scene import Scene, box_of


class Rest(NamedTuple):
    """Contacts in static equilibrium, one value per contact."""

    force: Array  #: F [N]
    indentation: Array  #: δ [m]
    stiffness: Array  #: ∂F/∂δ there [N/m]


class BandEdges(NamedTuple):
    """Angular frequencies [rad/s] between which an endless row passes waves; nan where there is no second band."""

    acoustic_top: float
    optical_bottom: float = math.nan
    optical_top: float = math.nan


class Modes:
    """Natural modes without dampers, the slowest first; Jupyter shows the report."""

    def __init__(self, report: Dict[str, Any], table: str, shape: Array) -> None:
        self._report = report
        self._table = table
        #: Displacements by mode and degree of freedom, of shape (k, n); the largest of each mode is ±1
        self.shape = shape

    @property
    def rest(self) -> Rest:
        """What the contacts carry at rest."""
        return Rest(**{name: np.array(values) for name, values in self._report["rest"].items()})

    @property
    def angular_frequency(self) -> Array:
        """ω of each mode, of shape (k,) [rad/s]."""
        return np.array(self._report["angular_frequency"], dtype=np.float64)

    @property
    def frequency(self) -> Array:
        """ω/2π of each mode, of shape (k,) [Hz]."""
        return self.angular_frequency / (2 * math.pi)

    @property
    def rigid_motions(self) -> int:
        """How many modes have no frequency, since they press no contact; they are not listed."""
        return int(self._report["rigid_motions"])

    @property
    def band_edges(self) -> Optional[BandEdges]:
        """Of a row that repeats one ball, or two in turn; None for any other."""
        edges = self._report.get("band_edges")
        return BandEdges(**edges) if edges else None

    def json(self) -> Dict[str, Any]:
        """All of it, as `mariotte modes --json --shapes` prints it, without the title."""
        return {**self._report, "shape": self.shape.tolist()}

    def __str__(self) -> str:
        return self._table

    def __repr__(self) -> str:
        return f"<mariotte.Modes: {len(self.shape)} of {self.shape.shape[1]} degrees of freedom>"

    def _repr_html_(self) -> str:
        import html

        return f"<pre>{html.escape(self._table)}</pre>"


def modes(scene: Scene[Any], *, force: Optional[Numbers] = None) -> Modes:
    """Find the small vibrations of a row or a network about its static equilibrium.

    Parameters
    ----------
    scene : Chain or Network
        Walls, gravity or precompression hold a row; as for a run, what is at rest needs ``run={"max_time": …}``. It
        is looked at without dampers.
    force : float
        Presses the ends of a row [N], where nothing else does.

    Raises
    ------
    InvalidParameter
        Where a contact is open at rest, carries no force or would yield.

    Examples
    --------
    >>> import mariotte as mt
    >>> row = mt.Chain(balls=3, mass=1, law="linear", stiffness=1, velocity=[1, 0, 0])
    >>> (mt.modes(row, force=1).angular_frequency ** 2).round(12)
    array([1., 3.])
    """
    pressed = None if force is None else float(numbers(force, "N"))
    report, table, shape = _core.modes(box_of(scene), pressed)
    return Modes(json.loads(report), table, shape)
