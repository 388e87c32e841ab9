"""What mariotte raises. An expected end of a run is a value, :class:`mariotte.Ending`, never an exception."""

from __future__ import annotations

from typing import List


class Error(Exception):
    """Base of every exception of mariotte.

    Attributes
    ----------
    code : str
        Kind of error; ``mariotte explain CODE`` tells what it means and how it is mended.
    """

    def __init__(self, message: str, code: str) -> None:
        super().__init__(message, code)
        self.code = code

    def __str__(self) -> str:
        return f"{self.args[0]} [{self.code}]"


class SceneError(Error, ValueError):
    """A scene that was refused.

    Attributes
    ----------
    place : str
        Where it is wrong: ``file:line:column``, or ``--set KEY`` of a value that was replaced.
    key : str
        The key that is wrong, such as ``chain.radius``; empty if none is.
    more : list of SceneError
        What else is wrong with the scene.

    Examples
    --------
    >>> import mariotte as mt
    >>> try:
    ...     mt.Chain(balls=2, mass=1, velocity=[1, 0], law="hertz", stiffness="1 kg")
    ... except mt.SceneError as error:
    ...     print(error.code, error.key)
    S022 chain.stiffness
    """

    place: str = ""
    key: str = ""
    more: List["SceneError"] = []


class FileError(Error, OSError):
    """A file that could not be read or written."""


class InvalidParameter(Error, ValueError):
    """A parameter outside its domain, such as an accuracy of 0."""


class FitError(Error):
    """A search that found no minimum, or not the only one; the message names the keys."""
