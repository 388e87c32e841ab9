# %% [markdown]
# # A wave through a row of balls
# A struck row of equal Hertz balls carries a solitary wave, about five contacts wide, whose speed depends on its
# height.

# %%
import numpy as np

import mariotte as mt

row = mt.Chain(title="Solitary wave", balls=200, radius="5 mm", material="steel", law="hertz",
               ball=[{"number": 1, "velocity": "1 m/s"}])
hit = mt.simulate(row, until="3 ms")
ax = hit.plot.waves()

# %% [markdown]
# The wave is followed at one contact and the next: the delay is the time that it takes per ball.

# %%
t = np.linspace(0, 2.5e-3, 10_001)
force = hit.force(t)
passing = t[force[:, 50:150].argmax(axis=0)]
speed = 2 * 5e-3 / np.polyfit(np.arange(100), passing, 1)[0]
print(f"speed of the wave {speed:.1f} m/s, largest force {force[:, 100].max():.1f} N")
