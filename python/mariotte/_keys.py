"""Keys of scenes: the name of the first table, that of the model, may be left out."""

from __future__ import annotations

import re

#: Tables of a model; the first is the one whose name may be left out.
_OF_MODEL = {"chain": ("chain",), "network": ("network",), "bodies": ("bodies",), "law": ("law",),
             "microbody": ("body", "surface", "incidence")}
#: What any scene may have beside them.
_OF_ANY = ("title", "columns", "run", "sweep", "figure", "law")


def expect_key(key: object) -> None:
    """Keys are text."""
    if not isinstance(key, str):
        raise TypeError(f"a key is text, such as 'velocity[0]', not {key!r}")


def whole_key(kind: str, key: str) -> str:
    """``velocity[0]`` of a chain is ``chain.velocity[0]``; ``law`` is that of its contacts, ``law.icr`` of [law]."""
    expect_key(key)
    tables = _OF_MODEL[kind]
    first = re.split(r"[.\[]", key)[0]
    stands_alone = key == "law" and tables[0] != "law"
    return key if first in (*tables, *_OF_ANY) and not stands_alone else f"{tables[0]}.{key}"
