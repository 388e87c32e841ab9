"""How new figures look: like those of the command, as wide as a column of a journal."""

from __future__ import annotations

import re
import textwrap
from typing import Any

import numpy as np

from . import _core
from ._numbers import Array

_INCH = 2.54  # [cm]
_STYLE = {"figure.figsize": (8.6 / _INCH, 6.1 / _INCH), "figure.dpi": 200, "font.size": 7, "axes.linewidth": 0.5,
          "lines.linewidth": 0.9, "xtick.major.width": 0.5, "ytick.major.width": 0.5, "xtick.major.size": 2.5,
          "ytick.major.size": 2.5}


def style_of(ax: Any) -> Any:
    """A context in which figures are drawn; axes that are given keep the style of their maker."""
    import matplotlib.pyplot as plt  # type: ignore[import]

    plt.draw_if_interactive()  # loads the backend; parameters that it sets would not outlive the context
    return plt.rc_context({} if ax is not None else _STYLE)


def text_size(share: float = 1.0) -> float:
    """Of the usual text [points]."""
    import matplotlib.pyplot as plt

    return share * float(plt.rcParams["font.size"])


def wrapped(title: str) -> str:
    """A title in lines that fit a figure of one column, beside a colour bar as well."""
    return textwrap.fill(title, 36, max_lines=3, placeholder=" …")


def make_logarithmic(ax: Any, axis: str, values: Array) -> None:
    """With numbers at 1, 2, 5, … where an axis has few decades, and evenly spaced ones where it has less than one."""
    from matplotlib import ticker  # type: ignore[attr-defined]

    getattr(ax, f"set_{axis}scale")("log")
    decades = float(np.log10(values.max() / values.min()))
    if decades > 3:
        return
    one = getattr(ax, f"{axis}axis")
    one.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)) if decades > 0.7 else ticker.MaxNLocator(5))
    one.set_major_formatter(ticker.FormatStrFormatter("%g"))
    one.set_minor_formatter(ticker.NullFormatter())


def labelled(name: str, unit: str) -> str:
    """What stands beside an axis: a name in gnuplot's enhanced text, and its unit, for matplotlib."""
    return beside_axis(_core.with_unit(name, unit))


def beside_axis(enhanced: str) -> str:
    """The same of a name that has its unit already."""
    return mathtext(enhanced).replace("\u00a0", " ")


def mathtext(enhanced: str) -> str:
    """Indices, exponents and marks of gnuplot's enhanced text as matplotlib writes them."""
    def mark(found: "re.Match[str]") -> str:
        plain, below, above, sign, braced, letter = found.groups()
        if below:
            return f"$_{{{below}}}^{{{above}}}$"
        return str(plain) if plain else f"${sign}{{{braced or letter}}}$"

    return re.sub(r"\\(.)|_\{([^}]*)\}\^\{([^}]*)\}|([_^])(?:\{([^}]*)\}|(\w))", mark, enhanced)
