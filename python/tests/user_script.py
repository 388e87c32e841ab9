"""A script as users write it: mypy --strict has nothing to say of it."""

from typing import Dict, List

import numpy as np

import mariotte as mt

cradle = mt.Chain(balls=5, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0, 0, 0])
hit = mt.simulate(cradle, accuracy=1e-12, estimate=True)
ratios: mt.Array = hit.icr
t = np.linspace(0, hit.time, 500)
force = hit.force(t)
print(hit.ending, hit.velocity, ratios, hit.energy.residual, hit.estimated_accuracy, force.shape)

grid = mt.sweep(cradle, {"velocity[0]": np.linspace(0.1, 2, 20), "gap[1]": np.geomspace(1e-7, 2e-5, 20)},
                columns=["velocity", "contacts[1].peak_force"])
speeds: mt.Array = grid["velocity"]
many = mt.solve([1, 1], [1], np.array([[1.0, 0.0], [2.0, 0.0]]), gap=0)
slopes = hit.sensitivity(to="mass").slopes("velocity")

law = mt.multiple_impact_law([1, 1, 1], [1, 0, 0], icr=[1.08], energy_ratio=1)
same = mt.multiple_impact_law(np.ones(3), np.array([1.0, 0.0, 0.0]), icr=np.array([1.08]))
rivals: Dict[str, mt.LawOutcome] = mt.rival_laws(np.ones(3), (1, 0, 0))

ball = mt.Bodies(dimension=2, law="hertz", tangential="rigid", friction=0.3, stiffness=1e9,
                 body=[{"mass": 1, "radius": 0.1, "position": [0, 0.1], "velocity": [0, -1]}],
                 plane=[{"normal": [0, 1]}])
spin: mt.Array = mt.simulate(ball).spin
names: List[str] = [first for first, _ in mt.simulate(ball).between]


def of_files() -> None:
    body = mt.load("microsphere.toml")
    slowest: float = mt.capture_velocity(body).value
    found = mt.fit(body, "measured.csv", free=["surface.zeta_hertz"])
    again = mt.fit(cradle, {"chain.velocity[0]": np.ones(3), "final.velocity[4]": [0.9, 0.9, 0.8]},
                   free="chain.damping")
    fitted = body.replace(found.values)
    print(slowest, again, mt.simulate(fitted).velocity)
    mt.simulate(mt.load("row.toml")).save("row.h5")
