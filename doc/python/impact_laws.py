# %% [markdown]
# # Impact laws beside the compliant chain
# Impact laws jump from the velocities before to those after. How far is each from the chain with contacts of Hertz?

# %%
import numpy as np

import mariotte as mt

mass, before = [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]
chain = mt.simulate(mt.Chain(mass=mass, velocity=before, law="hertz", stiffness=1))
answers = {name: law.velocity for name, law in mt.rival_laws(mass, before).items()}
answers["multiple impact"] = mt.multiple_impact_law(mass, before, icr=chain.icr).velocity
for name, velocity in answers.items():
    print(f"{name:20} {velocity.round(4)}  off by {np.abs(velocity - chain.velocity).max():.4f}")

# %% [markdown]
# The multiple-impact law needs the ratio of the impulses. With that of this chain it answers as the chain does, and
# it keeps doing so at any speed, since the ratio does not depend on it.

# %%
for speed in (0.01, 1.0, 100.0):
    compliant = mt.solve(mass, 1.0, [speed, 0, 0]).velocity[0]
    law = mt.multiple_impact_law(mass, [speed, 0, 0], icr=chain.icr).velocity
    print(f"{speed:6} m/s  {np.abs(law - compliant).max() / speed:.1e}")
