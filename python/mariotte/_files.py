"""Files that results are written to: the ending of a name says what they hold."""

from __future__ import annotations

import os
from typing import Callable, Mapping

from ._scene import Path


def save(path: Path, writers: Mapping[str, Callable[[str], None]]) -> None:
    """Call the writer of this ending with the name; an ending that has none is refused."""
    name = os.fspath(path)
    ending = os.path.splitext(name)[1].lower()
    if ending not in writers:
        *others, last = writers
        raise ValueError(f"{name}: the name must end in {', '.join(others)} or {last}")
    writers[ending](name)
