"""The scripts of the documentation run, and say what their texts say."""

import os
import runpy

import numpy as np
import pytest

pytest.importorskip("matplotlib")
ROOT = os.environ["MARIOTTE_ROOT"]


def run(name):
    return runpy.run_path(f"{ROOT}/doc/python/{name}.py")


def test_a_script_of_a_user_runs():
    made = runpy.run_path(os.path.join(os.path.dirname(__file__), "user_script.py"))
    assert made["speeds"].shape == (20, 20, 5) and made["slopes"].shape == (5, 5)
    assert made["same"].velocity.tolist() == made["law"].velocity.tolist()


def test_all_balls_of_the_cradle_move():
    made = run("newtons_cradle")
    assert made["hit"].velocity == pytest.approx([-0.0710850, -0.0302738, -0.0144636, 0.1270450, 0.9887774], abs=1e-6)
    far = made["grid"]["velocity"][-1]
    assert far == pytest.approx([0, 0, 0, 0, 1], abs=1e-9)  # one collision after the other


def test_the_map_passes_through_the_known_ratio():
    made = run("correlation_ratio_map")
    assert made["grid"]["icr[0]"].shape == (60, 60) and np.isfinite(made["grid"]["icr[0]"]).all()
    assert made["ratio"].mean() == pytest.approx(1.0768217704, abs=1e-3)


def test_the_wave_has_the_speed_of_theory():
    made = run("granular_wave")
    force = made["force"][:, 100].max()
    stiffness, mass = made["row"].json()["chain"]["contact"][0]["stiffness"], made["row"].mass[0]
    # Nesterenko: V = (16/25)^{1/5} 2R (k/m)^{2/5} v^{1/5} with v the peak velocity of the balls, and f = k δ^{3/2}
    peak = made["hit"].trajectory.velocity(made["t"])[:, 100].max()
    theory = (16 / 25) ** 0.2 * 0.01 * (stiffness / mass) ** 0.4 * peak**0.2
    assert made["speed"] == pytest.approx(theory, rel=0.02)  # of a long-wave limit
    assert force > 0


def test_the_fit_finds_the_truth():
    made = run("capture_and_fit")
    for key, value in (("surface.zeta_hertz", 1.5), ("surface.zeta_adhesion", 0.5)):
        assert abs(made["fit"].values[key] - value) < 4 * made["fit"].estimates[key].standard_error
    curve, below = made["curve"], made["fine"] < made["captured_below"]
    assert (curve.ending[below] == 1).all() and (curve.ending[~below] == 0).all()


def test_the_law_with_the_ratio_of_the_chain_answers_as_the_chain():
    made = run("impact_laws")
    assert made["answers"]["multiple impact"] == pytest.approx(made["chain"].velocity, abs=1e-9)
    assert made["answers"]["by-event"] == pytest.approx([0, 0, 1], abs=1e-12)
