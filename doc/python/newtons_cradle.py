# %% [markdown]
# # Newton's cradle
# One steel ball strikes four that touch. Sequential collisions would move the last one alone; the contacts of
# Hertz work at the same time, and all five fly apart.

# %%
import matplotlib.pyplot as plt
import numpy as np

import mariotte as mt

cradle = mt.Chain(title="Newton's cradle", balls=5, radius="10 mm", material="steel", law="hertz",
                  velocity=[1, 0, 0, 0, 0])
hit = mt.simulate(cradle, accuracy=1e-12)
hit

# %% [markdown]
# The forces overlap: while one contact lets go, others still push.

# %%
ax = hit.plot.forces()
ax = hit.plot.energy()

# %% [markdown]
# What does a small gap between the balls do? With microns between them the collisions come one after the other.

# %%
gaps = np.geomspace(1e-8, 1e-4, 60)
chains = cradle.replace({"chain.gap": [0, 0, 0, 0]})
same = tuple(f"gap[{j}]" for j in range(4))
grid = mt.sweep(chains, {same: (gaps,) * 4}, columns=["velocity"])
figure, ax = plt.subplots(layout="constrained")
lines = ax.semilogx(gaps * 1e6, grid["velocity"])
ax.legend(lines, [f"ball {i}" for i in range(5)])
ax.set(xlabel="gap [µm]", ylabel="velocity after [m/s]");
