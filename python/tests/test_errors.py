"""What is wrong with a call is told by its option, its row or its file."""

import errno
import os
import pickle
import re

import numpy as np
import pytest

import mariotte as mt


@pytest.mark.parametrize("options, key", [({"accuracy": 0}, "accuracy"), ({"max_events": 0}, "max_events"),
                                          ({"max_time": "1 kg"}, "max_time"), ({"until": -1}, "until"),
                                          ({"flow": "magic"}, "flow"), ({"flow": "ballistic"}, "flow")])
def test_an_option_is_named(options, key, triplet):
    with pytest.raises(mt.SceneError) as caught:
        mt.simulate(triplet, **options)
    assert isinstance(caught.value, mt.InvalidParameter) and (caught.value.key, caught.value.place) == (key, "")


def test_columns_rows_and_laws_are_named(triplet):
    cases = [(lambda: mt.sweep(triplet, {"velocity[0]": [1]}, columns="colour"), ("columns", "")),
             (lambda: mt.solve([[1, 1], [1, -1]], 1, [1, 0]), ("", "row 1")),
             (lambda: mt.solve(1, 1, [1, 0], law="magic"), ("law", "")),
             (lambda: mt.solve(1, 1, [1, 0], accuracy=2), ("accuracy", "")),
             (lambda: mt.solve(1, 1, [1, 0], threads=0), ("threads", ""))]
    for call, expected in cases:
        with pytest.raises(mt.SceneError) as caught:
            call()
        assert (caught.value.key, caught.value.place) == expected


@pytest.mark.parametrize("options, key", [(dict(law="hertz", damping=1), "damping"),
                                          (dict(law="linear", damping=[[0], [1]]), "damping"),
                                          (dict(law="hertz", exponent=2), "exponent"),
                                          (dict(law="tsuji", exponent=1), "exponent")])
def test_solve_refuses_what_the_law_does_not_have_as_a_chain_does(options, key):
    with pytest.raises(mt.InvalidParameter) as caught:
        mt.solve(1, 1, [1, 0], **options)
    own = {**options, key: 2, **({"damping": 1} if options["law"] == "tsuji" else {})}
    with pytest.raises(mt.SceneError) as of_chain:
        mt.Chain(mass=[1, 1], velocity=[1, 0], stiffness=1, **own)
    assert caught.value.key == key and (caught.value.code, of_chain.value.code) == ("S016", "S016")
    assert of_chain.value.args[0].endswith(caught.value.args[0])


def test_solve_names_the_laws_that_it_takes():
    for name in ("magic", "jkr", "walton-braun", "tabulated"):
        with pytest.raises(mt.InvalidParameter, match=f"no law '{name}'") as caught:
            mt.solve(1, 1, [1, 0], law=name)
    known = re.search(r"\((.*)\)", caught.value.args[0]).group(1).split(", ")
    assert len(known) == 7
    for law in known:
        assert f"``{law}``" in mt.solve.__doc__
        assert mt.solve(1, 1, [1, 0], law=law).ending.tolist() == [mt.Ending.separated]


@pytest.mark.parametrize("arrays, key, shapes",
                         [(dict(mass=np.ones((2, 3)), velocity=np.ones((2, 4))), "mass", "(2, 3), but (2, 4)"),
                          (dict(mass=1, velocity=[1, 0, 0], stiffness=[1, 1, 1]), "stiffness", "(1, 3), but (1, 2)"),
                          (dict(mass=1, velocity=[[1, 0]] * 3, gap=np.zeros((2, 1))), "gap", "(2, 1), but (3, 1)"),
                          (dict(mass=1, velocity=[1, 0], damping=[]), "damping", "(1, 0), but (1, 1)"),
                          (dict(mass=1, velocity=np.ones((2, 2, 2))), "velocity", "(2, 2, 2), but one or two"),
                          (dict(mass=1, velocity=[[1, 0], [1]]), "velocity", "no array of real numbers"),
                          (dict(mass="1 kg", velocity=[1, 0]), "mass", "no array of real numbers"),
                          (dict(mass=1, velocity=np.array([1j, 0])), "velocity", "no array of real numbers"),
                          (dict(mass=[1, 1, 1], velocity=np.ones((3, 9))), "mass", "rows are chains, (chains, balls)"),
                          (dict(mass=[[1, 1], [1, np.nan]], velocity=[1, 0]), "mass", "not a number in row 1"),
                          (dict(mass=1, velocity=[1, 0], gap=np.nan), "gap", "not a number in row 0")])
def test_an_array_of_the_wrong_shape_is_named(arrays, key, shapes):
    with pytest.raises(mt.InvalidParameter) as caught:
        mt.solve(**{"stiffness": 1, **arrays})
    assert caught.value.key == key and str(caught.value).startswith(key) and shapes in str(caught.value)


def test_errors_travel_to_other_processes(triplet):
    with pytest.raises(mt.SceneError) as caught:
        mt.simulate(triplet, accuracy=0)
    again = pickle.loads(pickle.dumps(caught.value))
    assert type(again) is mt.InvalidParameter and (str(again), again.key) == (str(caught.value), "accuracy")


def test_text_is_no_number(triplet):
    for call in (lambda: mt.simulate(triplet, accuracy="1e-9"), lambda: mt.solve(1, 1, [1, 0], accuracy="1e-9"),
                 lambda: mt.sweep(triplet, {"velocity[0]": [1]}, accuracy="1e-9")):
        with pytest.raises(TypeError, match="accuracy is a number, not '1e-9'"):
            call()


@pytest.mark.parametrize("call", [mt.simulate, mt.modes, mt.sensitivity, mt.capture_velocity, mt.sweep,
                                  lambda one: mt.restitution(one, [1]), lambda one: mt.vjp(one, {"velocity": [1]}),
                                  lambda one: mt.fit(one, {"speed": [1], "restitution": [1]}),
                                  lambda one: mt.with_law(one, force=1, stored_energy=1)])
def test_a_path_is_no_scene(call):
    with pytest.raises(TypeError, match="a scene is needed, not 'cradle.toml': load reads"):
        call("cradle.toml")


def test_what_is_no_mapping_has_no_keys(triplet):
    for call in (mt.sweep, mt.vjp):
        with pytest.raises(TypeError, match="by .* are needed, not"):
            call(triplet, [1, 2])


def test_a_law_of_ones_own_is_compiled_and_has_its_prototype(triplet):
    import ctypes

    real, pointer = ctypes.c_double, ctypes.POINTER(ctypes.c_double)
    force = ctypes.CFUNCTYPE(None, real, real, pointer)(lambda depth, rate, out: None)
    energy = ctypes.CFUNCTYPE(real, real)(lambda depth: depth)
    for wrong in ("1e9*depth**1.5", b"1e9", True, lambda depth: depth):
        with pytest.raises(TypeError, match="needs compiled functions"):
            mt.with_law(triplet, force=wrong, stored_energy=energy)
    for swapped in (dict(force=energy, stored_energy=force), dict(force=force, stored_energy=force)):
        with pytest.raises(TypeError, match="another prototype"):
            mt.with_law(triplet, **swapped)
    with pytest.raises(ValueError, match="contacts is empty"):
        mt.with_law(triplet, force=force, stored_energy=energy, contacts=[])


def test_what_is_no_word_and_no_value_is_said_to_be_none(triplet):
    with pytest.raises(TypeError, match="flow is a word, such as 'taylor', not 3"):
        mt.simulate(triplet, flow=3)
    with pytest.raises(TypeError, match="values by key are needed, not None"):
        triplet.replace(None)
    with pytest.raises(TypeError, match="law: a scene has no place for bytes"):
        mt.Chain(mass=[1, 1], velocity=[1, 0], law=b"hertz", stiffness=1)


def test_an_end_is_wanted_or_a_limit(triplet):
    with pytest.raises(TypeError, match="until.*max_time"):
        mt.simulate(triplet, until=1e-3, max_time=1e-4)
    for name in ("until", "max_time"):
        with pytest.raises(mt.InvalidParameter, match=f"{name} must be positive"):
            mt.simulate(triplet, **{name: 0})


@pytest.mark.parametrize("call, said", [
    (lambda one: mt.simulate(one)[3], "a key is text, .* not 3"),
    (lambda one: mt.sweep(one, {"mass[0]": [1]}, columns=[None]), "a key is text, .* not None"),
    (lambda one: one.replace({0: 1}), "a key is text, .* not 0"),
    (lambda one: mt.sensitivity(one, to=[5]), "a key is text, .* not 5"),
    (lambda one: mt.sweep(one, {0: [1]}), "an axis is a key, or a tuple"),
    (lambda one: mt.sweep(one, {"mass[0]": [1]}, threads="2"), "threads is a whole number, not '2'"),
    (lambda one: mt.simulate(one, max_events=2.5), "max_events is a whole number, not 2.5"),
    (lambda one: mt.simulate(one, estimate="no"), "estimate is True or False, not 'no'"),
    (lambda one: mt.Chain(mass=1, balls=2, law="hertz", stiffness=1, run=5), "run is a table, a dict .* not 5"),
    (lambda one: mt.parse(None), "the text of a scene is needed, not None"),
    (lambda one: mt.sensitivity(one).jvp(None), "changes by parameter are needed, not None")])
def test_what_has_the_wrong_type_is_named(call, said, triplet):
    with pytest.raises(TypeError, match=said):
        call(triplet)


@pytest.mark.parametrize("values", [1.0, "1", np.ones((2, 2)), np.float64(1)])
def test_what_is_varied_is_one_row(values, triplet):
    with pytest.raises(ValueError, match=r"values of velocity\[0\] are not one row"):
        mt.sweep(triplet, {"velocity[0]": values}, columns="time")


def test_keys_that_move_together_have_a_row_each(triplet):
    with pytest.raises(ValueError, match="2 keys .* 1 rows"):
        mt.sweep(triplet, {("velocity[0]", "velocity[1]"): ([1, 2],)}, columns="time")


def test_one_name_needs_no_list(triplet):
    grid = mt.sweep(triplet, {"velocity[0]": [1]}, columns="time")
    assert list(grid) == ["final.time"]
    assert mt.sensitivity(triplet, to="mass").parameters == ["mass[0]", "mass[1]", "mass[2]"]
    with pytest.raises(TypeError):
        mt.sensitivity(triplet, "mass")


def test_long_numbers_of_numpy_are_numbers(triplet):
    mass = np.array([1, 2], dtype=np.longdouble)
    pair = mt.Chain(mass=mass, velocity=[np.longdouble(1), 0], law="hertz", stiffness=np.float32(4))
    assert pair.mass.tolist() == [1, 2] and pair.velocity.tolist() == [1, 0]
    assert mt.sweep(triplet, {"velocity[0]": mass}, columns="time")["time"].shape == (2,)


def test_endings_are_words():
    assert f"{mt.Ending.captured}" == str(mt.Ending.captured) == "captured"
    assert f"{mt.Ending.captured:>10}" == "  captured" and f"{mt.Ending.captured:d}" == "1"


def test_keys_of_run_have_the_form_of_python(tmp_path):
    drive = {"end": "left", "quantity": "force", "signal": "sine", "amplitude": "1 N", "frequency": 1}
    pair = dict(mass=[1, 1], velocity=[0, 0], law="hertz", stiffness=1)
    with pytest.raises(mt.SceneError, match=r"it needs run=\{'until': …\} or run=\{'max_time': …\}"):
        mt.Chain(**pair, drive=drive)
    text = mt.Chain(**pair, drive=drive, run={"until": "1 s"}).text.split("[run]")[0]
    with pytest.raises(mt.SceneError, match="it needs 'run.until' or 'run.max_time'"):
        mt.parse(text)


def test_options_have_the_names_of_python(triplet):
    for wrong in (lambda: triplet.replace({"velocty": 1}), lambda: mt.sensitivity(triplet, to="chain.law"),
                  lambda: mt.fit(triplet, {"velocity[0]": [1], "final.velocity[2]": [1]}, free="stiffness")):
        with pytest.raises(mt.SceneError) as caught:
            wrong()
        assert "--" not in str(caught.value) + caught.value.place
    finer = triplet.replace({"run.accuracy": 1e-15})
    assert finer.warnings[0].startswith("replace run.accuracy: ") and finer.warnings[0] in mt.simulate(finer).warnings


def test_a_missing_file_is_one_of_python(tmp_path, triplet):
    missing, folder = tmp_path / "none.toml", tmp_path / "none" / "hit.json"
    for call, path in ((lambda: mt.load(missing), missing), (lambda: mt.simulate(triplet).save(folder), folder)):
        with pytest.raises(FileNotFoundError) as caught:
            call()
        assert isinstance(caught.value, mt.FileError) and caught.value.code.startswith("F")
        assert (caught.value.errno, caught.value.filename) == (errno.ENOENT, str(path))
        assert str(path) in str(caught.value)
        again = pickle.loads(pickle.dumps(caught.value))
        assert (type(again), str(again), again.filename) == (type(caught.value), str(caught.value), str(path))


def test_a_folder_is_no_file(tmp_path):
    with pytest.raises(mt.FileError) as caught:
        mt.load(tmp_path)
    assert caught.value.errno == errno.EISDIR and not isinstance(caught.value, FileNotFoundError)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_file_that_may_not_be_read_says_so(tmp_path):
    (tmp_path / "hidden.toml").touch(mode=0)
    with pytest.raises(mt.FileError) as caught:
        mt.load(tmp_path / "hidden.toml")
    assert caught.value.errno == errno.EACCES
