"""Capture, modes, laws and slopes: what the command answers."""

import ctypes
import gc
import json
import math
import shutil
import signal
import subprocess
import time
import weakref

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES


def test_capture_velocity_is_that_of_the_command(command_json):
    expected = command_json("capture", SCENES / "microsphere.toml")
    found = mt.capture_velocity(mt.load(SCENES / "microsphere.toml"))
    assert (found.value, found.captured, found.separated) == tuple(
        expected[key] for key in ("capture_velocity", "captured", "separated"))
    assert float(found) == found.value


@pytest.mark.parametrize("tolerance", [math.nan, math.inf, -1, 0, 1, 1e-300])
def test_a_tolerance_of_a_capture_velocity_is_between_rounding_and_a_half(tolerance):
    with pytest.raises(mt.InvalidParameter, match="lies between 1e-15 and 0.5"):
        mt.capture_velocity(mt.load(SCENES / "microsphere.toml"), tolerance=tolerance)


def test_two_balls_that_adhere_have_a_capture_velocity(tmp_path, command_json):
    pair = tmp_path / "pair.toml"
    pair.write_text("[chain]\nmass = [1, 2]\nvelocity = [1, 0]\nlaw = 'jkr'\neffective_modulus = 1e5\n"
                    "effective_radius = 0.01\nwork_of_adhesion = 0.1\n")
    assert mt.capture_velocity(mt.load(pair)).value == command_json("capture", pair)["capture_velocity"]


def test_modes_are_those_of_the_command(command_json):
    expected = command_json("modes", SCENES / "pressed_row.toml", "--shapes")
    found = mt.modes(mt.load(SCENES / "pressed_row.toml"))
    assert {"title": expected["title"], **found.json()} == expected
    assert found.shape.shape == (len(found.frequency), len(expected["shape"][0]))
    assert found.band_edges.optical_top == expected["band_edges"]["optical_top"]
    assert np.array_equal(found.rest.force, expected["rest"]["force"])


def test_the_table_of_modes_is_that_of_the_command(command):
    assert str(mt.modes(mt.load(SCENES / "pressed_row.toml"))) == command("modes", SCENES / "pressed_row.toml")


def test_a_force_presses_the_ends_of_a_row():
    row = mt.Chain(balls=3, mass=1, law="hertz", stiffness=1, velocity=[1, 0, 0])
    found = mt.modes(row, force=1e-3)
    assert found.angular_frequency ** 2 == pytest.approx([0.15, 0.45], rel=1e-13)
    assert found.rigid_motions == 1 and math.isnan(found.band_edges.optical_top)
    for force in (0, -1, math.nan):
        with pytest.raises(mt.InvalidParameter, match="force at the ends must be positive"):
            mt.modes(row, force=force)
    with pytest.raises(mt.InvalidParameter, match="pressed by nothing"):
        mt.modes(row)


def test_bodies_have_no_modes():
    with pytest.raises(mt.SceneError, match=r"only a \[chain\] or a \[network\] has modes"):
        mt.modes(mt.load(SCENES / "microsphere.toml"))


def test_a_curve_of_restitution_is_that_of_the_command(command_json):
    pair = SCENES / "steel_pair.toml"
    expected = command_json("restitution", pair, "--from", 0.1, "--to", 10, "--count", 3)["curve"]
    found = mt.restitution(mt.load(pair), [point["speed"] for point in expected])
    assert found.restitution.tolist() == [point["restitution"] for point in expected]
    assert found.closed_form.tolist() == [point["closed_form"] for point in expected]


def test_a_curve_of_restitution_tells_what_is_doubtful():
    with pytest.warns(mt.ModelWarning, match="strains are too large"):
        mt.restitution(mt.load(SCENES / "steel_pair.toml"), 10)


@pytest.mark.parametrize("speed", [0, -1, math.nan, [1, math.inf]])
def test_a_restitution_needs_a_speed(speed):
    with pytest.raises(mt.InvalidParameter, match="speed must be positive"):
        mt.restitution(mt.load(SCENES / "steel_pair.toml"), speed)


def test_weights_of_a_long_row_are_one_per_ball():
    row = mt.Chain(mass=[1.0] * 200, velocity=[1.0] + [0.0] * 199, law="hertz", stiffness=1)
    with pytest.raises(ValueError, match="weights of velocity are one per ball"):
        mt.vjp(row, {"velocity": 3})


def test_a_body_that_is_never_captured_is_an_error():
    ball = mt.Body(shape="sphere", radius=1e-6, density=1000, surface={"stiffness": 1e9},
                   incidence={"normal_speed": 1})
    with pytest.raises(mt.Error) as caught:
        mt.capture_velocity(ball)
    assert caught.value.code == "R003"


def test_the_law_is_that_of_the_command(command_json):
    expected = command_json("law", "--mass", "1,1,1", "--velocity", "1,0,0", "--icr", "1.5", "--energy-ratio", "0.9")
    found = mt.multiple_impact_law([1, 1, 1], [1, 0, 0], icr=[1.5], energy_ratio=0.9)
    assert found.velocity.tolist() == expected["final"]["velocity"]
    assert found.status == expected["status"] == "admissible" and found.ratio_lab == pytest.approx(0.9, rel=1e-14)


def test_laws_take_arrays_and_quantities():
    unit = pytest.importorskip("pint").UnitRegistry()
    mass, velocity = [1, 2, 1] * unit.gram, np.array([100, 0, 0]) * unit.cm / unit.s
    law = mt.multiple_impact_law(np.array([1e-3, 2e-3, 1e-3]), np.array([1, 0, 0]), icr=np.array([1.1]))
    assert mt.multiple_impact_law(mass, velocity, icr=[1.1]).velocity == pytest.approx(law.velocity, rel=1e-12)
    rivals = mt.rival_laws([1e-3, 2e-3, 1e-3], [1, 0, 0])
    for name, one in mt.rival_laws(mass, velocity).items():
        assert one.velocity == pytest.approx(rivals[name].velocity, rel=1e-12, abs=1e-15)
    with pytest.raises(TypeError, match="convert"):
        mt.rival_laws(mass, mass)


def test_a_table_of_numbers_is_no_row():
    with pytest.raises(ValueError, match="one row"):
        mt.multiple_impact_law([[1, 1]], [1, 0], direction=[1])


def test_an_outcome_that_is_not_real_is_told():
    found = mt.multiple_impact_law([1, 1], [1, 0], direction=[1], energy_ratio=0.1)
    assert found.status == "complex" and found.reason and found.velocity.size == 0
    assert found.least_energy_ratio == pytest.approx(0.5)


def test_rivals_keep_momentum():
    for outcome in mt.rival_laws([1, 2, 3], [1, 0, 0], restitution=0.5).values():
        assert outcome.velocity @ [1, 2, 3] == pytest.approx(1, abs=1e-12)


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    """f = k δ² + c δ δ̇, compiled by the C compiler."""
    compiler = shutil.which("cc")
    if not compiler:
        pytest.skip("no C compiler")
    folder = tmp_path_factory.mktemp("law")
    (folder / "law.c").write_text("""
        void force(double d, double r, double* out) {
          out[0] = 1e9 * d * d + 1e4 * d * r, out[1] = 2e9 * d + 1e4 * r, out[2] = 1e4 * d; }
        void cone(double d, double r, double* out) { out[0] = 1e9 * d * d, out[1] = 2e9 * d, out[2] = 0 * r; }
        void hertz(double d, double r, double* out) {
          out[0] = 1e9 * d * __builtin_sqrt(d), out[1] = 1.5e9 * __builtin_sqrt(d), out[2] = 0 * r; }
        double of_hertz(double d) { return 0.4e9 * d * d * __builtin_sqrt(d); }
        double energy(double d) { return 1e9 * d * d * d / 3; }""")
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "-o", folder / "law.so", folder / "law.c", "-lm"], check=True)
    return ctypes.CDLL(str(folder / "law.so"))


def test_a_law_in_c_does_what_the_same_law_of_the_library_does(compiled):
    chain = mt.Chain(mass=[1, 2, 1], velocity=[1, 0, 0], law="hertz", stiffness=1e9)
    own = mt.with_law(chain, force=compiled.hertz, stored_energy=compiled.of_hertz, name="mine")
    assert mt.simulate(own).velocity == pytest.approx(mt.simulate(chain).velocity, abs=1e-9)


def test_a_law_in_c_keeps_its_balances(compiled):
    pair = mt.Chain(mass=[1, math.inf], velocity=[1, 0], law="linear", stiffness=1)
    elastic = mt.simulate(mt.with_law(pair, force=compiled.cone, stored_energy=compiled.energy))
    assert elastic.velocity[0] == pytest.approx(-1, abs=1e-9)
    assert elastic.peak_indentation == pytest.approx([(1.5e-9) ** (1 / 3)], rel=1e-6)  # ½ m v² = k δ³/3
    damped = mt.simulate(mt.with_law(pair, force=compiled.force, stored_energy=compiled.energy, dissipates=True))
    assert -1 < damped.velocity[0] < 0 and damped.dissipated[0] > 0
    assert damped.energy.residual == pytest.approx(0, abs=1e-8)


def test_a_scene_with_a_law_of_c_stays_here(compiled, triplet):
    own = mt.with_law(triplet, force=compiled.cone, stored_energy=compiled.energy, contacts=[1])
    for use in (own.__reduce__, lambda: own.replace({"chain.velocity[0]": 2}), lambda: mt.sweep(own, {"radius": [1]}),
                lambda: mt.capture_velocity(own), lambda: mt.fit(own, {"speed": [1], "restitution": [1]})):
        with pytest.raises(TypeError, match="contact law of your own"):
            use()
    with pytest.raises(IndexError):
        mt.with_law(triplet, force=compiled.cone, stored_energy=compiled.energy, contacts=[2])


def test_files_name_a_law_of_ones_own(compiled, triplet, tmp_path):
    own = mt.with_law(triplet, force=compiled.cone, stored_energy=compiled.energy, name="cone", contacts=[1])
    hit = mt.simulate(own)
    for name in ("hit.json", "hit.csv"):
        hit.save(tmp_path / name)
    origin = json.loads((tmp_path / "hit.json").read_text())["provenance"]
    assert origin["own_laws"] == ["cone at contact 2"] and origin["scene_sha256"] is None and own.sha256 == ""
    beside = json.loads((tmp_path / "hit.csv-metadata.json").read_text())["notes"][0]
    assert beside["own_laws"] == "cone at contact 2" and "scene_sha256" not in beside
    assert "scene with the law cone at contact 2" in hit.cite() and triplet.sha256 not in hit.cite()


def test_laws_of_a_scene_outlive_the_scenes_it_was_made_from():
    force_of = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_double, ctypes.POINTER(ctypes.c_double))
    energy_of = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)
    alive = []

    def functions():
        @force_of
        def force(depth, rate, out):
            out[0], out[1], out[2] = 1e9 * depth**2, 2e9 * depth, 0

        alive.append(weakref.ref(force))
        return dict(force=force, stored_energy=energy_of(lambda depth: 1e9 * depth**3 / 3))

    triplet = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="linear", stiffness=1)
    both = mt.with_law(mt.with_law(triplet, **functions(), contacts=[0]), **functions(), contacts=[1])
    gc.collect()
    assert all(one() for one in alive)
    hit = mt.simulate(both)
    assert hit.velocity.sum() == pytest.approx(1, abs=1e-9)
    del both, hit
    mt.simulate(triplet)  # the solver of short chains holds the last one
    gc.collect()
    assert not any(one() for one in alive)


@pytest.mark.parametrize("function", [0, None, lambda depth, rate, out: None])
def test_what_is_not_compiled_is_no_law(function, triplet):
    with pytest.raises(TypeError, match="compiled"):
        mt.with_law(triplet, force=function, stored_energy=function)


def test_bodies_take_no_law():
    with pytest.raises(TypeError, match="has none"):
        mt.with_law(mt.load(SCENES / "microsphere.toml"), force=1, stored_energy=1)


def test_numba_compiles_laws():
    numba = pytest.importorskip("numba")

    @numba.cfunc("void(float64, float64, CPointer(float64))")
    def force(depth, rate, out):
        out[0], out[1], out[2] = 1e9 * depth**2, 2e9 * depth, 0.0

    @numba.cfunc("float64(float64)")
    def energy(depth):
        return 1e9 * depth**3 / 3

    pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="linear", stiffness=1)
    assert mt.simulate(mt.with_law(pair, force=force, stored_energy=energy)).velocity == pytest.approx([0, 1], abs=1e-9)


def test_slopes_are_those_of_the_command(command_json):
    expected = command_json("sensitivity", SCENES / "triplet.toml")
    hit = mt.simulate(mt.load(SCENES / "triplet.toml"))
    found = hit.sensitivity()
    assert found.parameters == expected["parameters"] and found.notes == expected["notes"]
    for outcome in found.outcomes:
        np.testing.assert_array_equal(found.slopes(outcome), np.array(expected["derivative"][outcome]))
    assert np.abs(found.value("velocity") - hit.velocity).max() < 1e-9


def test_products_with_slopes_are_consistent():
    found = mt.sensitivity(mt.load(SCENES / "triplet.toml"), to=["mass", "velocity", "contact"])
    change, weights = {"mass[1]": 1e-3, "velocity[0]": 0.1}, {"velocity": [1, -2, 0.5], "time": 3.0}
    forward, backward = found.jvp(change), found.vjp(weights)
    left = float(np.dot(weights["velocity"], forward["velocity"]) + weights["time"] * forward["time"])
    right = sum(backward[name] * amount for name, amount in change.items())
    assert abs(left - right) <= 1e-12 * abs(left)


def test_a_change_of_all_elements_is_one_per_element(triplet):
    found = mt.sensitivity(triplet, to=["mass", "velocity"])
    at_once = found.jvp({"mass": [1e-3, 0, 2e-3], "velocity[0]": 0.1})
    one_by_one = found.jvp({"mass[0]": 1e-3, "mass[2]": 2e-3, "velocity[0]": 0.1})
    assert {name: one.tolist() for name, one in at_once.items()} == {
        name: one.tolist() for name, one in one_by_one.items()}
    for change, shapes in (({"mass": 1}, r"mass have the shape \(3,\), not \(\)"),
                           ({"mass[0]": [1]}, r"mass\[0\] have the shape \(\), not \(1,\)")):
        with pytest.raises(ValueError, match=shapes):
            found.jvp(change)


def test_bodies_have_slopes():
    pair = mt.load(SCENES / "cradle_with_friction.toml")
    weights, key = {"bodies[1].velocity": [1, 0]}, "body[0].mass"
    assert mt.vjp(pair, weights, to=key) == mt.sensitivity(pair, to=key).vjp(weights)
    for function in (mt.sensitivity, mt.vjp):
        assert "Chain, Network, Body or Bodies" in function.__doc__


def test_a_sweep_has_the_slopes_of_each_scene(triplet):
    masses = [1, 2]
    chain = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
    grid = mt.sweep(chain, {"mass[1]": masses}, columns=[f"sensitivity.velocity[2].mass[{j}]" for j in range(3)])
    for row, mass in enumerate(masses):
        slopes = mt.sensitivity(chain.replace({"mass[1]": mass}), to="mass").slopes("velocity")[2]
        assert grid["sensitivity.velocity[2].mass[*]"][row] == pytest.approx(slopes, rel=1e-9)


def test_slopes_of_a_sum_of_velocities_are_those_of_all_outcomes():
    row = mt.load(SCENES / "triplet.toml")
    keys, weights = ["mass", "gap", "chain.radius"], {"velocity": [1, -2, 0.5]}
    expected, found = mt.sensitivity(row, to=keys).vjp(weights), mt.vjp(row, weights, to=keys)
    assert list(found) == list(expected)
    size = max(map(abs, expected.values()))
    assert all(abs(found[name] - slope) < 1e-9 * size for name, slope in expected.items())


def test_slopes_of_a_very_long_row_are_swept_back():
    row = mt.Chain(balls=2000, mass=1, law="hertz", stiffness=1, ball=[{"number": 1, "velocity": 1}])
    slopes = mt.vjp(row, {"velocity": [0.0] * 1999 + [1.0]})
    assert len(slopes) == 7998
    assert abs(slopes["velocity[0]"] - mt.simulate(row).velocity[-1]) < 1e-9  # velocities are homogeneous in it


def test_slopes_of_other_sums_run_forward():
    row, weights = mt.load(SCENES / "triplet.toml"), {"velocity": [1, 0, 0], "time": 2.0}
    assert mt.vjp(row, weights, to="mass") == mt.sensitivity(row, to="mass").vjp(weights)
    body = mt.load(SCENES / "microsphere.toml")
    assert mt.vjp(body, {"e_n": 1}, to="zeta_hertz") == mt.sensitivity(body, to="zeta_hertz").vjp({"e_n": 1})


def test_slopes_by_what_is_no_number_are_refused():
    with pytest.raises(mt.SceneError, match="^to chain.law: "):
        mt.sensitivity(mt.load(SCENES / "triplet.toml"), to=["chain.law"])


@pytest.mark.parametrize("ask, message", [
    (lambda found: found.slopes("velocity[0]"), "velocity[0] is no outcome here: velocity, impulse, icr, time"),
    (lambda found: found.value("speed"), "speed is no outcome here: velocity, impulse, icr, time"),
    (lambda found: found.vjp({"speed": 1}), "speed is no outcome here: velocity, impulse, icr, time"),
    (lambda found: found.jvp({"mas[0]": 1}), "mas[0] is no parameter here: mass[0], mass[1], mass[2]")])
def test_an_outcome_or_parameter_that_is_not_there_is_a_key_error(ask, message, triplet):
    with pytest.raises(KeyError) as caught:
        ask(mt.sensitivity(triplet, to="mass"))
    assert caught.value.args == (message,)


@pytest.mark.parametrize("weights, message", [({"velocity": [1, 0]}, r"velocity have the shape \(3,\), not \(2,\)"),
                                              ({"time": [1]}, r"time have the shape \(\), not \(1,\)")])
def test_weights_of_another_shape_are_refused(weights, message, triplet):
    with pytest.raises(ValueError, match=message):
        mt.sensitivity(triplet, to="mass").vjp(weights)


def test_ctrl_c_ends_slopes():
    row = mt.Chain(balls=100, mass=1, law="hertz", stiffness=1, ball=[{"number": 1, "velocity": 1}])
    signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    started = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        mt.sensitivity(row)  # of some minutes
    assert time.monotonic() - started < 60
