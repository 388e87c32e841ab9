"""What Python counts as numbers: arrays, and quantities of pint, which become SI."""

from __future__ import annotations

from typing import Any, List, Protocol, Sequence, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class Quantity(Protocol):
    """A number or an array with a unit, as those of pint."""

    def to(self, unit: str) -> Any: ...
    def to_base_units(self) -> Any: ...


#: What an array can be made of.
Numbers = Union[npt.ArrayLike, Quantity, Sequence[Quantity]]


def numbers(values: Numbers, unit: str = "") -> Array:
    """An array in SI units. `unit` says what quantities are converted to, where only one dimension makes sense."""
    array = np.asarray(_magnitude(values, unit))
    if np.iscomplexobj(array):
        raise ValueError("real numbers are expected, not complex ones")
    return array.astype(np.float64, copy=False)


def listed(values: Numbers, unit: str = "") -> List[float]:
    """The same of one dimension, as a list."""
    row = numbers(values, unit)
    if row.ndim != 1:
        raise ValueError(f"one row of numbers is expected, not an array of shape {row.shape}")
    made: List[float] = row.tolist()
    return made


def number(value: Any, what: str) -> float:
    """One number; text is none."""
    if isinstance(value, (str, bytes)):
        raise TypeError(f"{what} is a number, not {value!r}")
    return float(value)


def whole(value: Any, what: str) -> int:
    """One whole number; what has a fraction is none. It is cut to what a number of C++ can hold."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{what} is a whole number, not {value!r}")
    return max(-(10**18), min(int(value), 10**18))


def counted(count: int, thing: str) -> str:
    """``1 outcome``, ``2 outcomes``."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"


def _magnitude(values: Any, unit: str) -> Any:
    if hasattr(values, "to_base_units"):
        return (values.to(unit) if unit else values.to_base_units()).magnitude
    if isinstance(values, (list, tuple)):
        return [_magnitude(one, unit) for one in values]
    return values
