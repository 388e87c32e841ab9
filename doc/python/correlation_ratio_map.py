# %% [markdown]
# # A map of the impulse correlation ratio
# A ball strikes two. How the impulse divides depends on the ratio of the stiffnesses and on the masses, and not on
# the stiffness itself.

# %%
import numpy as np

import mariotte as mt

triplet = mt.Chain(title="Three Hertz balls", mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
grid = mt.sweep(triplet, {"stiffness[1]": np.geomspace(0.01, 100, 60), "mass[1]": np.geomspace(0.1, 10, 60)},
                columns=["icr[0]", "velocity"], accuracy=1e-8)
ax = grid.plot("icr[0]")

# %% [markdown]
# The same through plain arrays: a sample of random chains, for a Monte Carlo study of tolerances.

# %%
random = np.random.default_rng(1)
stiffness = random.normal(1, 0.02, size=(20_000, 2))
many = mt.solve([1, 1, 1], stiffness, [1, 0, 0], accuracy=1e-8)
ratio = many.impulse[:, 0] / many.impulse[:, 1]
print(f"ratio {ratio.mean():.5f} ± {ratio.std():.5f}")
