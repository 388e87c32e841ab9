"""Names of what a sweep computes: shorter ones for keys of results."""

from __future__ import annotations

import re
from typing import Any, Dict, Iterable, List, Sequence, Tuple, Union

from ._keys import expect_key
from ._scene import Bodies, Scene

_OF_CONTACTS = {"velocity": "final.velocity[*]", "gap": "final.gap[*]", "icr": "icr[*]",
                "impulse_direction": "impulse_direction[*]",
                **{name: f"contacts[*].{name}"
                   for name in ("impulse", "peak_force", "peak_indentation", "stored", "dissipated", "plastic_work",
                                "adhesion_loss", "permanent_indentation")}}
_OF_MICROBODIES = {name: f"final.{name}[*]" for name in ("position", "velocity", "spin")}


def key_of_result(scene: Scene[Any], member: str) -> str:
    """``velocity`` of a chain is ``final.velocity[*]``, ``velocity[1]`` is ``final.velocity[1]``."""
    expect_key(member)
    if member == "time":
        return "final.time"
    name, *indices = re.split(r"(?=\[)", member)
    key = _members(scene).get(name)
    if key is None or key.count("[*]") < len(indices):
        return member
    given = iter(indices)
    return re.sub(r"\[\*\]", lambda star: next(given, star.group()), key)


def names(given: Union[str, Sequence[str]]) -> List[str]:
    """Several names; one alone needs no list."""
    listed = [given] if isinstance(given, str) else list(given)
    for one in listed:
        expect_key(one)
    return listed


def matches(pattern: str, keys: Iterable[str]) -> Dict[int, Tuple[int, ...]]:
    """What stands for the stars of a pattern, by the places of the keys that fit it."""
    form = re.compile(re.escape(pattern).replace(r"\*", r"(\d+)"))
    fits = ((place, form.fullmatch(key)) for place, key in enumerate(keys))
    return {place: tuple(map(int, one.groups())) for place, one in fits if one}


def from_start(pattern: str, keys: Sequence[str]) -> str:
    """Indices from the end, as those of lists of Python, by how many the keys have."""
    negative = re.search(r"\[-(\d+)\]", pattern)
    if not negative or pattern in keys:
        return pattern
    before, after = pattern[: negative.start()], pattern[negative.end():]
    places = [one[before.count("[*]")] for one in matches(from_start(f"{before}[*]{after}", keys), keys).values()]
    place = len(set(places)) - int(negative.group(1))
    return from_start(f"{before}[{place}]{after}", keys) if place >= 0 else pattern


def extents(indices: Iterable[Tuple[int, ...]]) -> List[int]:
    """How many values each index takes."""
    return [len(set(along)) for along in zip(*indices)]


def _members(scene: Scene[Any]) -> Dict[str, str]:
    if isinstance(scene, Bodies):
        return _of_bodies(components="[*]" if scene.dimension == 3 else "")
    return _OF_MICROBODIES if scene._box.kind == "microbody" else _OF_CONTACTS


def _of_bodies(components: str) -> Dict[str, str]:
    ends = ("position[*]", "velocity[*]", "angle", "quaternion[*]", f"spin{components}")
    contacts = ("normal_impulse", f"tangential_impulse{components}", "peak_force", "peak_friction", "peak_indentation",
                "stored")
    keys = [f"final.bodies[*].{name}" for name in ends] + [f"contacts[*].{name}" for name in contacts]
    return {key.rsplit(".", 1)[1].replace("[*]", ""): key for key in keys}
