"""What mariotte raises. An expected end of a run is a value, :class:`mariotte.Ending`, never an exception."""

from __future__ import annotations

import errno
import re
import warnings
from typing import Any, List, Sequence, Tuple


def in_python(text: str) -> str:
    """A message with options of the command by their names in Python: ``replace`` for ``--set``, and of a scene that
    was made by keywords ``run={'until': …}`` for ``'run.until'``."""
    if re.match(r"<[A-Z]", text):
        text = re.sub(r"'run\.(until|max_time)'", r"run={'\1': …}", text)
    return re.sub(r"--(set|to|free|flow)\b", lambda flag: flag[1].replace("set", "replace"), text)


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
    """A scene that was refused, or options with which it cannot be run.

    Attributes
    ----------
    place : str
        Where it is wrong: ``file:line:column``, ``replace KEY`` of a value that was replaced, or ``row 3`` of arrays.
    key : str
        The key or the option that is wrong, such as ``chain.radius``; empty if none is.
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

    def __init__(self, message: str, code: str, key: str = "", place: str = "") -> None:
        super().__init__(in_python(message), code)
        self.key = key
        self.place = in_python(place)
        self.more: List[SceneError] = []


class InvalidParameter(SceneError):
    """An option outside its domain, such as an accuracy of 0, a column that no result has, or a row of arrays."""


class FileError(Error, OSError):
    """A file that could not be read or written, with `errno` and `filename` as far as they are known.

    One that is not there is a :class:`FileNotFoundError`, too.
    """

    def __init__(self, message: str, code: str, number: int = 0, path: str = "") -> None:
        OSError.__init__(self, number or None, message, path or None)
        self.code = code

    def __str__(self) -> str:
        return f"{self.strerror} [{self.code}]"

    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self.strerror, self.code, self.errno or 0, self.filename or "")


class MissingFile(FileError, FileNotFoundError):
    """A file or a folder that is not there."""


def file_error(message: str, code: str, number: int, path: str) -> FileError:
    """The exception for this errno."""
    return (MissingFile if number == errno.ENOENT else FileError)(message, code, number, path)


class FitError(Error):
    """A search that found no minimum, or not the only one; the message names the keys."""


class ModelWarning(UserWarning):
    """What has to be said of a scene or a result whose numbers may not be what was wanted.

    Examples
    --------
    >>> import mariotte as mt, warnings
    >>> warnings.simplefilter("error", mt.ModelWarning)  # an exception; "ignore" silences it
    >>> mt.simulate(mt.Chain(mass=[1, 1], velocity=[0, 1], law="hertz", stiffness=1))
    Traceback (most recent call last):
        ...
    mariotte._errors.ModelWarning: nothing collides: no contact ever closes faster than a tenth of the accuracy
    """


def warn(texts: Sequence[str]) -> None:
    """One warning per text, at the line that has called the caller."""
    for text in texts:
        warnings.warn(text, ModelWarning, stacklevel=3)
