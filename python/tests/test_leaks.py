"""Under the address sanitizer: no memory that the module allocated is lost."""

import ctypes
import os
import re
import subprocess
import sys

import pytest

import mariotte
from conftest import SCENES

pytestmark = pytest.mark.skipif(not hasattr(ctypes.CDLL(None), "__lsan_do_recoverable_leak_check"),
                                reason="built without the address sanitizer")

USE = f"""
import ctypes, gc, os, pickle, tempfile
import numpy as np
import mariotte as mt

SCENES = {str(SCENES)!r}
Force = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
Energy = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)
def law():
    @Force
    def cone(depth, rate, out):
        out[0], out[1], out[2] = 1e9 * depth**2, 2e9 * depth, 0
    return dict(force=cone, stored_energy=Energy(lambda depth: 1e9 * depth**3 / 3))

def save(*results):
    with tempfile.TemporaryDirectory() as folder:
        for one in results:
            for ending in ("csv", "h5"):
                try:
                    one.save(f"{{folder}}/saved.{{ending}}")
                except mt.Error:  # built without HDF5
                    pass

def use():
    triplet = mt.Chain(balls=3, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0])
    hit = pickle.loads(pickle.dumps(mt.simulate(triplet)))
    hit.velocity, hit.icr, hit.peak_force, hit.periods, hit.events, str(hit), hit.force(np.linspace(0, hit.time, 9))
    for name in ("rack_of_fifteen", "microrod", "viscoelastic"):
        mt.simulate(mt.load(SCENES + f"/{{name}}.toml")).json()
    grid = mt.sweep(triplet, {{"velocity[0]": [1, 2], "gap[0]": [0, 1e-6]}}, columns=["velocity", "peak_force"])
    save(hit, grid)
    own = mt.with_law(mt.with_law(triplet, **law(), contacts=[0]), **law(), contacts=[1])
    mt.simulate(own).velocity, hit.sensitivity(to="velocity").slopes("velocity"), grid["velocity"]
    ball = mt.simulate(mt.load(SCENES + "/oblique_sphere.toml"))
    ball.velocity, ball.spin, ball.losses, ball.periods, ball.events
    mt.fit(mt.load(SCENES + "/sphere_fit.toml"), SCENES + "/sphere_fit.csv", free="surface.zeta_hertz")
    mt.solve(1, [1, 1], [[1, 0, 0], [2, 0, 0]])
    mt.capture_velocity(mt.load(SCENES + "/microsphere.toml"), tolerance=1e-2)
    mt.multiple_impact_law([1, 1, 1], [1, 0, 0], icr=[1.08]), mt.rival_laws([1, 1, 1], [1, 0, 0])
    for wrong in (lambda: mt.parse("x"), lambda: mt.simulate(triplet, accuracy=0), lambda: hit["no.key"],
                  lambda: mt.solve(-1, 1, [1, 0]), lambda: mt.sweep(triplet, {{"colour": [1]}}),
                  lambda: mt.load("none.toml")):
        try:
            wrong()
        except (mt.Error, KeyError):
            pass
"""
LOSE = """
libc = ctypes.CDLL(None)
libc.malloc.restype = ctypes.c_size_t
[libc.malloc(ctypes.c_size_t(54321)) for _ in range(100)]
"""
CHECK = """
gc.collect()
ctypes.CDLL(None).__lsan_do_recoverable_leak_check()
os._exit(0)  # what the interpreter leaves behind at its end is its own
"""


def report(program):
    """What the sanitizer says of this program in an interpreter of its own."""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True,
                          env={**os.environ, "ASAN_OPTIONS": "detect_leaks=1", "PYTHONMALLOC": "malloc"})
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_what_is_lost_is_seen():
    assert re.search(r"of 5[34]\d{5} byte\(s\) in (99|100) object", report(USE + LOSE + CHECK))


def test_the_module_loses_nothing():
    blocks = report(USE + "use(); use()" + CHECK).split("\n\n")
    assert [block for block in blocks if os.path.basename(mariotte._core.__file__) in block] == []
