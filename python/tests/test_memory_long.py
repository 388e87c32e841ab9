"""A million calls leave no memory behind."""

import ctypes
import gc
import os
import pathlib

import pytest

import mariotte as mt
from conftest import SCENES

pytestmark = [pytest.mark.skipif(not pathlib.Path("/proc/self/statm").exists(), reason="no /proc"),
              pytest.mark.skipif(hasattr(ctypes.CDLL(None), "__asan_init"), reason="memory is kept to be checked")]

TRIPLET = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
PAIR = mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness=1)


def resident():
    """Memory of this process [MiB]."""
    gc.collect()
    return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def refused():
    with pytest.raises(mt.SceneError):
        mt.simulate(TRIPLET, accuracy=0)


CALLS = {"quick": (1_000_000, lambda: mt.simulate(TRIPLET).velocity),
         "whole": (100_000, lambda: mt.simulate(PAIR).peak_force),
         "scene": (100_000, lambda: TRIPLET.replace({"chain.velocity[0]": 2.0})),
         "events": (100_000, lambda: mt.simulate(PAIR).events),
         "trajectory": (50_000, lambda: mt.simulate(PAIR).force([0.1, 0.2])),
         "sweep": (20_000, lambda: mt.sweep(PAIR, {"velocity[0]": [1, 2]}, columns="velocity")["velocity"]),
         "solve": (20_000, lambda: mt.solve(1, [1, 1], [[1, 0, 0], [2, 0, 0]], threads=1)),
         "slopes": (20_000, lambda: mt.sensitivity(PAIR, to="velocity")),
         "bodies": (2_000, lambda: mt.simulate(mt.load(SCENES / "oblique_sphere.toml")).losses),
         "error": (50_000, refused)}


def is_flat(count, call):
    """Less than four bytes per call, and room for what the allocator holds back."""
    for _ in range(count // 20):
        call()
    before = resident()
    for _ in range(count):
        call()
    return resident() - before < 1 + 4 * count / 2**20


@pytest.mark.parametrize("name", CALLS)
def test_memory_is_flat(name):
    assert is_flat(*CALLS[name])


def test_what_is_kept_is_seen():
    kept = []
    assert not is_flat(100_000, lambda: kept.append(bytes(32)))
