"""Values of Python as TOML, in which scenes are written."""

from __future__ import annotations

import json
import numbers
from typing import Any, Mapping


def toml(value: Any) -> str:
    """One value: a number, text, true or false, a list, a table, an array of NumPy or a quantity of pint."""
    value = plain(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return repr(int(value))
    if isinstance(value, numbers.Real):  # of NumPy, too, however long
        return repr(float(value))
    if hasattr(value, "tolist"):  # arrays, and truth of NumPy
        return toml(value.tolist())
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{key} = {toml(one)}" for key, one in value.items()) + " }"
    try:
        if isinstance(value, (bytes, bytearray)):
            raise TypeError
        entries = list(value)
    except TypeError:
        kind = "None" if value is None else type(value).__name__
        raise TypeError(f"a scene has no place for {kind}") from None
    return "[" + ", ".join(map(toml, entries)) + "]"


def table(name: str, entries: Mapping[str, Any]) -> str:
    """A table with a line per key; keys that are None are left out."""
    if not isinstance(entries, Mapping):
        raise TypeError(f"{name} is a table, a dict of values by key, not {entries!r}")
    lines = [_line(key, value) for key, value in entries.items() if value is not None]
    return "\n".join([f"[{name}]", *lines, ""])


def _line(key: str, value: Any) -> str:
    try:
        return f"{key} = {toml(value)}"
    except TypeError as error:
        raise TypeError(f"{key}: {error}") from None


def plain(value: Any) -> Any:
    """A quantity of pint as text with its unit; anything else as it is."""
    return _with_unit(value) if hasattr(value, "to_base_units") else value


def _with_unit(quantity: Any) -> Any:
    """A number with its SI unit as text, so that the reader checks the dimension."""
    base = quantity.to_base_units()
    unit = f"{base.units:~C}".replace("**", "^")
    if hasattr(base.magnitude, "tolist"):
        return [f"{number!r} {unit}".strip() for number in base.magnitude.tolist()]
    return f"{float(base.magnitude)!r} {unit}".strip()
