"""Scenes of Python are those of files: the same values, the same errors."""

import copy
import pickle

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES

PAIR = dict(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness="1e9 N/m^1.5")


def test_keywords_make_the_scene_that_a_file_makes():
    made = mt.Chain(title="Five steel balls", balls=5, radius="10 mm", law="hertz", velocity=["1 m/s", 0, 0, 0, 0],
                    material={"young": "210 GPa", "poisson": 0.3, "density": "7800 kg/m^3"}, gap=0)
    of_file = mt.load(SCENES / "newton_cradle_5.toml").json()
    assert {**made.json(), "provenance": None} == {**of_file, "provenance": None}


def test_a_file_is_loaded_as_what_it_is():
    kinds = {"triplet": mt.Chain, "rocking_block": mt.Network, "microsphere": mt.Body,
             "oblique_sphere": mt.Bodies}
    assert {name: type(mt.load(SCENES / f"{name}.toml")) for name in kinds} == kinds


@pytest.mark.parametrize("speed", [0.1, 1 / 3, 1e-30, 123456789.123456789, 2.5e17, np.float64(0.1), 3])
def test_numbers_keep_every_bit(speed):
    assert mt.Chain(**{**PAIR, "velocity": [speed, 0]}).velocity[0] == speed


def test_arrays_of_numpy_are_numbers():
    velocity = np.random.default_rng(1).normal(size=7)
    chain = mt.Chain(balls=7, mass=1, law="hertz", stiffness=1, velocity=velocity)
    assert np.array_equal(chain.velocity, velocity)
    assert np.array_equal(chain.mass, np.ones(7))


def test_single_contacts_and_balls_are_tables():
    chain = mt.Chain(balls=3, mass=1, velocity=[1, 0, 0],
                     contact=[{"law": "hertz", "stiffness": 1}, {"law": "linear", "stiffness": "2 N/m"}],
                     ball=[{"number": 3, "mass": "2 kg"}])
    assert chain.mass.tolist() == [1, 1, 2]
    assert [one["law"] for one in chain.json()["chain"]["contact"]] == ["hertz", "linear"]


def test_errors_name_code_key_and_place():
    with pytest.raises(mt.SceneError) as caught:
        mt.Chain(**{**PAIR, "stiffness": "3 kg"})
    error = caught.value
    assert (error.code, error.key, error.place) == ("S022", "chain.stiffness", "<Chain>:5:13")
    assert "expected a stiffness" in str(error) or "N/m" in str(error)
    assert str(error).endswith("[S022]")
    assert isinstance(error, ValueError) and isinstance(error, mt.Error)


def test_all_that_is_wrong_is_told():
    with pytest.raises(mt.SceneError) as caught:
        mt.Chain(**PAIR, nosuch=1, run={"accuracy": -1})
    errors = [caught.value, *caught.value.more]
    assert {(one.code, one.key) for one in errors} == {("S010", "chain.nosuch"), ("S023", "run.accuracy")}


def test_errors_are_those_of_the_command(command, tmp_path):
    file = tmp_path / "bad.toml"
    file.write_text('[chain]\nballs = 2\nradius = "10 kg"\nmaterial = "steel"\nlaw = "hertz"\nvelocity = [1, 0]\n')
    with pytest.raises(mt.SceneError) as caught:
        mt.load(file)
    assert str(caught.value) in command("check", file, code=3)
    assert caught.value.place == f"{file}:3:10"


def test_a_misspelt_key_is_told_the_nearest():
    with pytest.raises(mt.SceneError, match="did you mean 'stiffness'"):
        mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffnes=1)


def test_a_file_that_is_not_there_is_a_file_error(tmp_path):
    with pytest.raises(mt.FileError, match="none.toml") as caught:
        mt.load(tmp_path / "none.toml")
    assert isinstance(caught.value, OSError) and caught.value.code == "F001"


@pytest.mark.parametrize("value", [float("nan"), object(), 1j, b"1"])
def test_what_is_no_value_is_refused(value):
    with pytest.raises((mt.SceneError, TypeError)):
        mt.Chain(**{**PAIR, "velocity": [value, 0]})


@pytest.mark.parametrize("key, value, kind", [("mass", [1, None], "None"), ("ball", [{"number": None}], "None"),
                                              ("velocity", [1, 1j], "complex")])
def test_what_is_no_value_is_named_with_its_key(key, value, kind):
    with pytest.raises(TypeError, match=f"^{key}: a scene has no place for {kind}$"):
        mt.Chain(**{**PAIR, key: value})


def test_options_are_keywords_only(triplet):
    with pytest.raises(TypeError):
        mt.Chain(5)
    with pytest.raises(TypeError):
        mt.simulate(triplet, 1e-8)


def test_values_can_be_replaced():
    chain = mt.Chain(**PAIR)
    other = chain.replace({"chain.velocity[1]": "-2 m/s", "run.accuracy": 1e-6})
    assert (chain.velocity[1], other.velocity[1]) == (0, -2)
    with pytest.raises(mt.SceneError) as caught:
        chain.replace({"chain.velocity[9]": 1})
    assert caught.value.place == "replace chain.velocity[9]" and caught.value.code == "S017"


@pytest.mark.parametrize("scene, short, whole",
                         [("triplet", "velocity[0]", "chain.velocity[0]"), ("microsphere", "radius", "body.radius"),
                          ("microsphere", "surface.friction", "surface.friction"), ("triplet", "law", "chain.law"),
                          ("thrown_rod", "body[0].velocity[0]", "bodies.body[0].velocity[0]"),
                          ("rocking_block", "velocity[0]", "network.velocity[0]"),
                          ("triplet", "run.accuracy", "run.accuracy")])
def test_the_model_may_be_left_out_of_a_key_or_not(scene, short, whole):
    scene = mt.load(SCENES / f"{scene}.toml")
    value = "hertz" if short == "law" else 2e-6
    assert scene.replace({short: value}).sha256 == scene.replace({whole: value}).sha256
    for key in (short, whole):
        assert list(mt.sweep(scene, {key: [value]}, columns="time").axes) == [whole]


def test_the_title_and_the_law_are_no_keys_of_the_model():
    scene = mt.Chain(**PAIR).replace({"title": "Two balls", "law.energy_ratio": 0.5, "law": "linear", "stiffness": 1})
    assert scene.title == "Two balls" and scene.overrides[1:3] == ["law.energy_ratio=0.5", 'chain.law="linear"']


def test_tables_of_a_text_are_beside_its_name(tmp_path):
    (tmp_path / "push.csv").write_text("time [s],force [N]\n0,0\n1,1\n")
    text = mt.Chain(**PAIR).text + """[run]
until = 1
[chain.drive]
end = "left"
quantity = "force"
signal = "table"
table = "push.csv"
"""
    assert mt.simulate(mt.parse(text, name=str(tmp_path / "scene.toml"))).ending == mt.Ending.time_limit
    with pytest.raises(FileNotFoundError, match="push.csv"):
        mt.parse(text)


@pytest.mark.parametrize("again", [lambda scene: pickle.loads(pickle.dumps(scene)), copy.copy, copy.deepcopy])
def test_scenes_are_pickled_as_text(again):
    scene = mt.load(SCENES / "triplet.toml", replace={"chain.velocity[0]": 2.0})
    other = again(scene)
    assert type(other) is mt.Chain
    assert (other.text, other.sha256, other.velocity.tolist()) == (scene.text, scene.sha256, [2, 0, 0])


def test_quantities_of_pint_carry_their_unit():
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    speeds = np.array([10, 0]) * unit.cm / unit.s
    chain = mt.Chain(**{**PAIR, "mass": 2 * unit.gram, "velocity": speeds})
    assert np.allclose(chain.velocity, [0.1, 0], rtol=1e-15) and np.allclose(chain.mass, 2e-3, rtol=1e-15)
    assert mt.simulate(chain, until=1e-3 * unit.microsecond).time == pytest.approx(1e-9, rel=1e-15)
    with pytest.raises(mt.SceneError) as caught:
        mt.Chain(**{**PAIR, "mass": 2 * unit.second})
    assert caught.value.code == "S022"


def test_warnings_are_kept():
    still = mt.Chain(**{**PAIR, "velocity": [0, 0]})
    assert len(still.warnings) == 1 and "<Chain>:" in still.warnings[0]


def test_arrays_of_a_scene_share_its_memory():
    chain = mt.Chain(**PAIR)
    for name in ("mass", "velocity", "gap"):
        one, other = getattr(chain, name), getattr(chain, name)
        assert one.__array_interface__["data"] == other.__array_interface__["data"]
        assert not one.flags.writeable and not one.flags.owndata
