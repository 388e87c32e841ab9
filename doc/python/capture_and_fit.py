# %% [markdown]
# # A capture curve, and a fit
# Below a certain speed a microsphere does not come off a surface again. Its damping is not known: it is found from
# measured restitution first.

# %%
import matplotlib.pyplot as plt
import numpy as np

import mariotte as mt

sphere = mt.Body(title="Microsphere", shape="sphere", radius="2.45 um", density="1350 kg/m^3",
                 surface={"stiffness": "1.74 GPa", "work_of_adhesion": "0.38 J/m^2", "zeta_hertz": 1,
                          "zeta_adhesion": 1}, incidence={"normal_speed": "5 m/s"})
truth = sphere.replace({"surface.zeta_hertz": 1.5, "surface.zeta_adhesion": 0.5})
speeds = np.geomspace(2.5, 20, 15)
clean = mt.sweep(truth, {"incidence.normal_speed": speeds}, columns=["restitution.tip"])["restitution.tip"]
measured = clean + np.random.default_rng(3).normal(0, 0.005, speeds.size)
fit = mt.fit(sphere, {"speed": speeds, "restitution": measured})
fit

# %%
fitted = sphere.replace(fit.values)
captured_below = mt.capture_velocity(fitted).value
fine = np.geomspace(0.8 * captured_below, 20, 200)
curve = mt.sweep(fitted, {"incidence.normal_speed": fine}, columns=["restitution.tip"])
figure, ax = plt.subplots(layout="constrained")
ax.semilogx(speeds, measured, "o", label="measured")
ax.semilogx(fine, np.nan_to_num(curve["restitution.tip"]), label="fitted")
ax.axvline(captured_below, color="0.7")
ax.set(xlabel="normal speed [m/s]", ylabel="restitution")
ax.legend()
print(f"capture velocity {captured_below:.4f} m/s")
