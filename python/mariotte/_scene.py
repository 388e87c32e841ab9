"""Scenes: what collides, and how well the answer must be known."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, ClassVar, Dict, Generic, List, Mapping, Optional, Tuple, Type, TypeVar, Union

from . import _core
from ._errors import in_python
from ._keys import whole_key
from ._numbers import Array
from ._toml import table, toml

if TYPE_CHECKING:
    from ._bodies import BodiesImpact
    from ._impact import ChainImpact, MicrobodyImpact, NetworkImpact

Path = Union[str, "os.PathLike[str]"]
S = TypeVar("S", bound="Scene[Any]")
Result = TypeVar("Result")


class Scene(Generic[Result]):
    """What was written, resolved to SI values and checked; it does not change.

    Made by :class:`Chain`, :class:`Network`, :class:`Body`, :class:`Bodies`, :func:`load` and :func:`parse`. Scenes are
    pickled as their text, so that other processes can simulate them.
    """

    __slots__ = ("_box",)
    _kinds: ClassVar[Dict[str, Type["Scene[Any]"]]] = {}
    _box: _core.Scene

    def __init_subclass__(cls, *, kind: str = "") -> None:
        if kind:
            Scene._kinds[kind] = cls

    @staticmethod
    def _of(core: _core.Scene) -> "Scene[Any]":
        made = object.__new__(Scene._kinds.get(core.kind, Scene))
        made._box = core
        return made

    @property
    def title(self) -> str:
        """Heads tables and figures."""
        return self._box.title

    @property
    def text(self) -> str:
        """The scene as TOML, which the command can run, but for what was replaced in it: see `overrides`.

        Examples
        --------
        >>> import mariotte as mt
        >>> print(mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness="1 N/m").text)
        [chain]
        mass = [1, 1]
        velocity = [1, 0]
        law = "linear"
        stiffness = "1 N/m"
        <BLANKLINE>
        """
        return self._box.text

    @property
    def overrides(self) -> List[str]:
        """What was replaced in the text, each as ``--set`` of the command takes it.

        Examples
        --------
        >>> import mariotte as mt
        >>> chain = mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness="1 N/m")
        >>> chain.replace({"chain.velocity[0]": "2 m/s"}).overrides
        ['chain.velocity[0]="2 m/s"']
        """
        return self._box.overrides

    @property
    def warnings(self) -> List[str]:
        """Values that are possible but look like a mistake, each with its place."""
        return [in_python(text) for text in self._box.warnings]

    @property
    def sha256(self) -> str:
        """Of the text and what was replaced in it; results of the command record the same. Empty if a contact law of
        your own is part of the scene."""
        return self._box.sha256

    def json(self) -> Dict[str, Any]:
        """The scene as it was understood, in SI units, as `mariotte check --json` prints it."""
        made: Dict[str, Any] = json.loads(self._box.json())
        return made

    def replace(self: S, values: Mapping[str, Any]) -> S:
        """The scene with other values.

        Parameters
        ----------
        values : dict
            Values by key; indices count from 0. The name of the model may be left out, as in a sweep: ``velocity[0]``
            is ``chain.velocity[0]``. Keys that are missing are made, elements of arrays are not.

        Examples
        --------
        >>> import mariotte as mt
        >>> chain = mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness="1 N/m")
        >>> chain.replace({"chain.velocity[0]": "2 m/s"}).velocity
        array([2., 0.])
        """
        if not isinstance(values, Mapping):
            raise TypeError(f"values by key are needed, not {values!r}")
        self._expect_text()
        whole = {whole_key(self._box.kind, key): value for key, value in values.items()}
        made = Scene._of(_core.scene(self._box.text, self._box.name, self._box.overrides + _overrides(whole)))
        assert isinstance(made, type(self))
        return made

    def __reduce__(self) -> Tuple[Any, ...]:
        self._expect_text()
        return _restored, (self._box.text, self._box.name, self._box.overrides)

    def _expect_text(self) -> None:
        if self._box.foreign:
            raise TypeError("no text says what a contact law of your own is: this scene cannot be changed, "
                            "swept, fitted or sent to other processes")

    def __eq__(self, other: object) -> bool:
        """The same text with the same replaced; contact laws of your own make a scene equal to itself alone."""
        if not isinstance(other, Scene):
            return NotImplemented
        own_laws = self._box.foreign or other._box.foreign
        return self is other or (not own_laws and self._identity() == other._identity())

    def __hash__(self) -> int:
        return hash(self._identity())

    def _identity(self) -> Tuple[Any, ...]:
        return self._box.text, self._box.name, tuple(self._box.overrides)

    def __repr__(self) -> str:
        return f"<mariotte.{type(self).__name__} {self.title or self._box.name!r}>"


def box_of(scene: Any) -> Any:
    """What computes. Whatever is no scene is refused."""
    if not isinstance(scene, Scene):
        raise TypeError(f"a scene is needed, not {scene!r}: load reads a file, parse a text")
    return scene._box


def box_of_text(scene: Any) -> Any:
    """The same of a scene that a text can say."""
    box = box_of(scene)
    scene._expect_text()
    return box


class _OfContacts(Scene[Result]):
    """What chains and networks have in common."""

    __slots__ = ()

    @property
    def velocity(self) -> Array:
        """Before the impact: of n balls [m/s], or of n degrees of freedom [SI]. Read-only."""
        return self._box.velocity

    @property
    def gap(self) -> Array:
        """Of m contacts at the start [m]. Read-only."""
        return self._box.gap


def _set_text(scene: Scene[Any], name: str, tables: Mapping[str, Mapping[str, Any]], top: Mapping[str, Any]) -> None:
    head = "".join(f"{key} = {toml(value)}\n" for key, value in top.items() if value is not None)
    parts = [table(key, entries) for key, entries in tables.items() if entries]
    scene._box = _core.scene(head + "\n".join(parts), f"<{name}>", [])


class Chain(_OfContacts["ChainImpact"], kind="chain"):
    """Balls on a line and their contacts.

    Parameters
    ----------
    title : str, optional
        Heads tables and figures.
    run : dict, optional
        Keys of ``[run]``, such as ``accuracy``.
    **keys
        Keys of ``[chain]`` in a scene file: ``balls``, ``mass``, ``radius``, ``diameter``, ``material``, ``velocity``,
        ``law``, ``stiffness``, ``damping``, ``restitution``, ``exponent``, ``gap``, ``gravity``, ``wall``, … Each is a
        number in SI units, text with a unit, a quantity of pint, or an array of these; `contact` and `ball` are lists
        of tables.

    Raises
    ------
    SceneError
        For keys and values that make no sense.

    Examples
    --------
    >>> import mariotte as mt
    >>> cradle = mt.Chain(balls=5, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0, 0, 0])
    >>> cradle.mass.round(6)
    array([0.032798, 0.032798, 0.032798, 0.032798, 0.032798])
    """

    __slots__ = ()

    def __init__(self, *, title: Optional[str] = None, run: Optional[Mapping[str, Any]] = None, **keys: Any) -> None:
        _set_text(self, "Chain", {"chain": keys, "run": run or {}}, {"title": title})

    @property
    def mass(self) -> Array:
        """Of n balls [kg]; ``inf`` is a wall. Read-only."""
        return self._box.mass


class Network(_OfContacts["NetworkImpact"], kind="network"):
    """Balls in the plane or in space, or anything with a mass matrix and contact directions.

    Parameters
    ----------
    title : str, optional
        Heads tables and figures.
    run : dict, optional
        Keys of ``[run]``, such as ``accuracy``.
    **keys
        Keys of ``[network]`` in a scene file; `ball` and `contact` are lists of tables.

    Raises
    ------
    SceneError
        For keys and values that make no sense.

    Examples
    --------
    >>> import mariotte as mt
    >>> block = mt.Network(mass=[5, 0.0208], velocity=[-0.1, 1], law="linear", stiffness="1e9 N/m",
    ...                    contact=[{"direction": [1, -0.1]}, {"direction": [1, 0.1]}])
    >>> mt.simulate(block).ending
    <Ending.separated: 0>
    """

    __slots__ = ()

    def __init__(self, *, title: Optional[str] = None, run: Optional[Mapping[str, Any]] = None, **keys: Any) -> None:
        _set_text(self, "Network", {"network": keys, "run": run or {}}, {"title": title})


class Body(Scene["MicrobodyImpact"], kind="microbody"):
    """A microbody that strikes a plane.

    Parameters
    ----------
    surface, incidence : dict
        Keys of ``[surface]`` and ``[incidence]`` in a scene file.
    title : str, optional
        Heads tables and figures.
    run : dict, optional
        Keys of ``[run]``, such as ``impacts``.
    **keys
        Keys of ``[body]``: ``shape``, ``radius``, ``density``, …

    Raises
    ------
    SceneError
        For keys and values that make no sense.

    Examples
    --------
    >>> import mariotte as mt
    >>> sphere = mt.Body(shape="sphere", radius="2.45 um", density="1350 kg/m^3",
    ...                  surface={"stiffness": "1.74 GPa", "friction": 0.15}, incidence={"normal_speed": "5 m/s"})
    >>> round(mt.simulate(sphere).restitution.tip, 9)
    1.0
    """

    __slots__ = ()

    def __init__(self, *, surface: Mapping[str, Any], incidence: Mapping[str, Any], title: Optional[str] = None,
                 run: Optional[Mapping[str, Any]] = None, **keys: Any) -> None:
        tables = {"body": keys, "surface": surface, "incidence": incidence, "run": run or {}}
        _set_text(self, "Body", tables, {"title": title})


class Bodies(Scene["BodiesImpact"], kind="bodies"):
    """n bodies and planes that touch with friction, in the plane or in space.

    Parameters
    ----------
    title : str, optional
        Heads tables and figures.
    run : dict, optional
        Keys of ``[run]``, such as ``accuracy``.
    **keys
        Keys of ``[bodies]`` in a scene file; `body`, `plane` and `contact` are lists of tables.

    Raises
    ------
    SceneError
        For keys and values that make no sense.

    Examples
    --------
    >>> import mariotte as mt
    >>> pair = mt.Bodies(dimension=2, radius="10 mm", material="steel", law="hertz", tangential="mindlin", friction=0.2,
    ...                  body=[{"position": [0, 0], "velocity": [1, 0], "spin": 50}, {"position": ["2 cm", 0]}])
    >>> mt.simulate(pair).velocity.round(4)
    array([[ 0.    , -0.0897],
           [ 1.    ,  0.0897]])
    """

    __slots__ = ()

    def __init__(self, *, title: Optional[str] = None, run: Optional[Mapping[str, Any]] = None, **keys: Any) -> None:
        _set_text(self, "Bodies", {"bodies": keys, "run": run or {}}, {"title": title})

    @property
    def dimension(self) -> int:
        """2 in the plane, 3 in space."""
        return self._box.dimension

    @property
    def mass(self) -> Array:
        """Of n bodies [kg]. Read-only."""
        return self._box.mass

    @property
    def position(self) -> Array:
        """Of the mass centres at the start, of shape (n, 2) or (n, 3) [m]. Read-only."""
        return self._box.position

    @property
    def velocity(self) -> Array:
        """Of the mass centres before the impact, of shape (n, 2) or (n, 3) [m/s]. Read-only."""
        return self._box.velocity

    @property
    def spin(self) -> Array:
        """Before the impact, of shape (n,) in the plane, or (n, 3), space axes [rad/s]. Read-only."""
        return self._box.spin


def load(path: Path, *, replace: Optional[Mapping[str, Any]] = None) -> Scene[Any]:
    """Read a scene file.

    Parameters
    ----------
    path : path
        Of a TOML file, as the command reads it.
    replace : dict, optional
        Values by key that go before those of the file, as ``--set`` of the command.

    Returns
    -------
    Scene
        A :class:`Chain`, :class:`Network`, :class:`Body` or :class:`Bodies`.

    Raises
    ------
    FileError, SceneError
        For files that cannot be read, and scenes that make no sense.
    """
    return Scene._of(_core.load(os.fspath(path), _overrides(replace or {})))


def parse(text: str, *, name: str = "<text>", replace: Optional[Mapping[str, Any]] = None) -> Scene[Any]:
    """Read a scene from TOML text; `name` stands for the file, in messages and where tables are looked for beside it.

    Examples
    --------
    >>> import mariotte as mt
    >>> mt.parse('''
    ... [chain]
    ... mass = [1, 1]
    ... velocity = [1, 0]
    ... law = "linear"
    ... stiffness = 1
    ... ''')
    <mariotte.Chain '<text>'>
    """
    if not isinstance(text, str):
        raise TypeError(f"the text of a scene is needed, not {text!r}")
    return Scene._of(_core.scene(text, name, _overrides(replace or {})))


def _overrides(values: Mapping[str, Any]) -> List[str]:
    return [f"{key}={toml(value)}" for key, value in values.items()]


def _restored(text: str, name: str, overrides: List[str]) -> Scene[Any]:
    return Scene._of(_core.scene(text, name, overrides))
