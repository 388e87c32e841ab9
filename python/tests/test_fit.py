"""Fits to measurements, and their figures."""

import pickle

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES


def test_a_fit_is_that_of_the_command(command_json):
    scene, data = SCENES / "sphere_fit.toml", SCENES / "sphere_fit.csv"
    expected = command_json("fit", scene, data)
    found = mt.fit(mt.load(scene), data)
    for of in (expected, found.json()):
        of.pop("data"), of.pop("provenance")
    assert found.json() == expected
    assert list(found.values) == ["surface.zeta_hertz", "surface.zeta_adhesion"]
    assert found.correlation.shape == (2, 2) and found.predicted.shape == found.measured.shape == (30,)
    low, high = (getattr(found.estimates["surface.zeta_hertz"], end) for end in ("lower", "upper"))
    assert low < found.values["surface.zeta_hertz"] < high


def test_arrays_are_measurements_too():
    scene, data = mt.load(SCENES / "sphere_fit.toml"), SCENES / "sphere_fit.csv"
    columns = np.loadtxt(data, delimiter=",", skiprows=3, usecols=(0, 1, 2, 3)).T
    names = ["diameter [um]", "speed [m/s]", "restitution", "deviation"]
    assert mt.fit(scene, dict(zip(names, columns))).values == mt.fit(scene, data).values


def test_a_fit_has_something_to_find_and_a_confidence():
    scene, data = mt.load(SCENES / "sphere_fit.toml"), SCENES / "sphere_fit.csv"
    with pytest.raises(mt.InvalidParameter, match="nothing to find"):
        mt.fit(scene, data, free=[])
    with pytest.raises(mt.InvalidParameter, match="confidence must be between 0 and 1, is 95"):
        mt.fit(scene, data, confidence=95)


def test_chains_are_fitted_too():
    pair = mt.load(SCENES / "measured_restitution.toml")
    truth = pair.replace({"chain.restitution": 0.8})
    speeds = np.array([0.5, 1.0, 2.0])
    measured = mt.sweep(truth, {"velocity[0]": speeds}, columns="velocity")["velocity"][:, -1]
    found = mt.fit(pair, {"chain.velocity[0]": speeds, "final.velocity[1]": measured}, free="chain.restitution")
    assert found.values["chain.restitution"] == pytest.approx(0.8, rel=1e-6)
    assert found.measured.tolist() == measured.tolist()


def test_the_model_may_be_left_out_of_a_key_that_is_fitted():
    pair = mt.load(SCENES / "measured_restitution.toml")
    data = {"chain.velocity[0]": [0.5, 1.0], "final.velocity[1]": [0.45, 0.9]}
    assert mt.fit(pair, data, free="restitution").values == mt.fit(pair, data, free="chain.restitution").values


@pytest.mark.parametrize("short", ["velocity[0]", "velocity[0] [mm/s]"])
def test_the_model_may_be_left_out_of_a_key_that_was_set(short):
    pair = mt.load(SCENES / "measured_restitution.toml")
    data = {short: [0.5, 1.0], "restitution": [0.9, 0.85]}
    assert list(mt.fit(pair, data, free="restitution").json()["measurements"][0]["settings"]) == ["chain.velocity[0]"]
    for wrong, why in (("velocty[0]", r"did you mean 'velocity'\?"), ("chain.velocity[0]", "set by another column")):
        with pytest.raises(mt.SceneError, match=why):
            mt.fit(pair, {**data, wrong: [0.5, 1.0]}, free="restitution")


def test_quantities_are_measurements_too():
    unit = pytest.importorskip("pint").UnitRegistry()
    sphere = mt.load(SCENES / "sphere_fit.toml")
    speeds, e = [2.0, 4.0, 8.0], [0.6, 0.8, 0.85]
    there = mt.fit(sphere, {"speed [m/s]": 100 * np.array(speeds) * unit.cm / unit.s, "restitution": e},
                   free="surface.zeta_hertz")
    assert there.values == pytest.approx(mt.fit(sphere, {"speed": speeds, "restitution": e},
                                                free="surface.zeta_hertz").values, rel=1e-9)


@pytest.mark.parametrize("columns", [{"speed": [1, 2, 3], "restitution": [0.8, 0.9]}, {"speed": 1, "restitution": 0.8},
                                     {"speed": "123", "restitution": "456"}])
def test_columns_are_rows_of_one_length(columns):
    with pytest.raises(ValueError, match="lengths|not one row"):
        mt.fit(mt.load(SCENES / "sphere_fit.toml"), columns)


def test_measurements_that_say_nothing_are_a_fit_error():
    sphere = mt.load(SCENES / "sphere_fit.toml")
    with pytest.raises((mt.FitError, mt.SceneError)):
        mt.fit(sphere, {"speed": [5.0, 5.0, 5.0], "restitution": [0.8, 0.8, 0.8]})


def test_a_value_that_may_be_zero_has_a_warning():
    pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="kuwabara-kono", stiffness=1000, damping=1)
    with pytest.warns(mt.ModelWarning, match="chain.damping is not told from zero"):
        found = mt.fit(pair, {"speed": [1, 2, 3], "restitution": [1, 1, 1]}, free="damping")
    assert len(found.warnings) == 1


@pytest.fixture
def spheres():
    return mt.fit(mt.load(SCENES / "sphere_fit.toml"), SCENES / "sphere_fit.csv")


def test_a_figure_shows_measurements_and_the_fitted_curves(spheres):
    pytest.importorskip("matplotlib")
    ax = spheres.plot()
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("incident normal speed v$_{n}$ [m/s]", "tip restitution e$_{n}$")
    assert [line.get_text() for line in ax.get_legend().get_texts()] == ["diameter 4.90 µm", "diameter 6.89 µm"]
    assert ax.get_xscale() == "log"
    drawn = [line for line in ax.lines if line.get_marker() == "o"]
    assert np.concatenate([line.get_ydata() for line in drawn]) == pytest.approx(
        np.concatenate([spheres.measured[:15], spheres.measured[15:]]))
    speed, curve = ax.lines[0].get_data()
    assert np.interp(5, speed, curve) == pytest.approx(np.interp(5, spheres.setting("incidence.normal_speed")[:15],
                                                                 spheres.predicted[:15]), abs=3e-3)


def test_a_pickled_fit_can_be_drawn(spheres):
    pytest.importorskip("matplotlib")
    again = pickle.loads(pickle.dumps(spheres))
    assert str(again) == str(spheres)
    assert np.array_equal(again.plot().lines[0].get_ydata(), spheres.plot().lines[0].get_ydata())


def test_measurements_without_a_number_to_draw_over_have_no_figure():
    pytest.importorskip("matplotlib")
    pair = mt.Chain(mass=[1, 1], velocity=[1, 0], law="kelvin-voigt", stiffness=1e6, damping=100)
    fit = mt.fit(pair, {"law": ["kelvin-voigt"] * 2, "restitution": [0.7, 0.8]}, free="damping")
    with pytest.raises(ValueError, match="no setting is a number"):
        fit.plot()
