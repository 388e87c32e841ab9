"""What the module costs beside C++ and the command: PYTHONPATH=build/python python3 python/measure/measure.py build

Names of functions after the build folder choose measurements.
Times are processor time; they are of one machine and noisy. Each is the least of several, taken in
turn with what it is compared to.
"""

import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import mariotte as mt

BUILD = pathlib.Path(sys.argv[1])
TRIPLET = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
MAP = """columns = ["icr[0]"]
[chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
law = "hertz"
stiffness = [1, 1]
[run]
accuracy = 1e-6
[[sweep]]
key = "chain.stiffness[1]"
from = 0.1
to = 10
count = 1000
scale = "log"
[[sweep]]
key = "chain.velocity[2]"
from = -1
to = 0
count = 1000
"""


def microseconds(run, count=20_000):
    start = time.process_time()
    for _ in range(count):
        run()
    return (time.process_time() - start) / count * 1e6


def of_children():
    times = os.times()
    return times.children_user + times.children_system


def one_triplet():
    here, there = [], []
    for _ in range(5):
        there.append([float(word) for word in subprocess.check_output([BUILD / "python" / "measure_triplet"]).split()])
        here.append(microseconds(lambda: mt.simulate(TRIPLET)))
    solver, whole = (min(column) for column in zip(*there))
    print(f"simulate of a triplet: {min(here):.1f} µs; in C++ the solver {solver:.1f} µs, simulate {whole:.1f} µs")


def million_points():
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "map.toml"
        scene.write_text(MAP)
        command, here = [], []
        for turn in range(3):
            start = of_children()
            subprocess.check_call([BUILD / "apps/mariotte/mariotte", "sweep", scene, "--out", f"{folder}/{turn}", "-q",
                                   "--no-figures"], stdout=subprocess.DEVNULL)
            command.append(of_children() - start)
            start = time.process_time()
            grid = mt.sweep(mt.load(scene))
            here.append(time.process_time() - start)
    assert grid["icr[0]"].size == 1_000_000
    print(f"sweep of 10⁶ triplets: {min(here):.2f} s, the command {min(command):.2f} s, "
          f"ratio {min(here) / min(command):.2f}")


def copies():
    hit = mt.simulate(TRIPLET)
    addresses = {hit.velocity.__array_interface__["data"][0] for _ in range(3)}
    print(f"velocity is at {', '.join(map(hex, addresses))} each of three times, and owns its memory: "
          f"{hit.velocity.flags.owndata}")


def memory():
    def resident():
        return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20

    for _ in range(10_000):
        mt.simulate(TRIPLET).velocity
    before = resident()
    for _ in range(1_000_000):
        mt.simulate(TRIPLET).velocity
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"memory before and after 10⁶ calls: {before:.1f} MiB, {resident():.1f} MiB (peak {peak:.1f} MiB)")


FIRST = """import numpy as np
import matplotlib
matplotlib.use("Agg")
import mariotte as mt

cradle = mt.Chain(balls=5, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0, 0, 0])
hit = mt.simulate(cradle)
print(hit.ending.name, hit.velocity, hit.icr)
t = np.linspace(0, hit.time, 500)
print(hit.force(t).max(axis=0), hit.energy.residual)
ax = hit.plot.forces()
ax.set_title("Five steel balls")
ax.figure.savefig("forces.png")
hit.save("cradle.json")
print(hit.cite().splitlines()[0])
"""


def first_script():
    with tempfile.TemporaryDirectory() as folder:
        package = str(pathlib.Path(mt.__file__).absolute().parent.parent)
        taken = []
        for _ in range(5):
            start = of_children()
            subprocess.check_call([sys.executable, "-c", FIRST], cwd=folder, stdout=subprocess.DEVNULL,
                                  env={**os.environ, "PYTHONPATH": package})
            taken.append(of_children() - start)
        assert (pathlib.Path(folder) / "forces.png").stat().st_size > 0
    print(f"{len(FIRST.splitlines())} lines from nothing to a figure: {min(taken):.1f} s")


for measure in (one_triplet, copies, million_points, first_script, memory):
    if measure.__name__ in sys.argv[2:] or len(sys.argv) == 2:
        measure()
