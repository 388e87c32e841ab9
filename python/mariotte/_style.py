"""How new figures look: like those of the command, as wide as a column of a journal."""

from __future__ import annotations

import re
import textwrap
from typing import Any

from . import _core

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


def labelled(name: str, unit: str) -> str:
    """What stands beside an axis: a name in gnuplot's enhanced text, and its unit, for matplotlib."""
    return mathtext(_core.with_unit(name, unit)).replace("\u00a0", " ")


def mathtext(enhanced: str) -> str:
    """Indices, exponents and marks of gnuplot's enhanced text as matplotlib writes them."""
    def mark(found: "re.Match[str]") -> str:
        plain, above, below, sign, braced, letter = found.groups()
        if below:
            return f"$_{{{below}}}^{{{above}}}$"
        return str(plain) if plain else f"${sign}{{{braced or letter}}}$"

    return re.sub(r"\\(.)|@\^\{([^}]*)\}_\{([^}]*)\}|([_^])(?:\{([^}]*)\}|(\w))", mark, enhanced)
