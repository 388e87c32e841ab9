"""Results: the bits of the command, without copies, computed when they are asked for."""

import copy
import gc
import math
import multiprocessing
import pickle
import re
import signal
import threading
import time
import warnings

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES
from mariotte._columns import _members

QUICK = ["bernoulli", "big_ball", "captured_sphere", "decorated_chain", "microdumbbell_spinning", "microrod",
         "microsphere", "mixed_laws", "newton_cradle_5", "rack_of_fifteen", "rocking_block", "rod_tilt", "triplet",
         "viscoelastic", "wall_bounce", "y_chain"]


@pytest.mark.parametrize("name", QUICK)
def test_results_are_those_of_the_command_to_the_last_bit(name, command_json):
    file = SCENES / f"{name}.toml"
    expected = command_json("run", file)
    for of_the_command in ("scene", "scene_text", "provenance"):
        expected.pop(of_the_command)
    hit = mt.simulate(mt.load(file))
    found = hit.json()
    found.pop("provenance")
    assert found == expected
    assert hit.velocity.tolist() == expected["final"]["velocity"]
    assert hit.time == expected["final"]["time"]


@pytest.mark.parametrize("accuracy", [1e-6, 1e-12])
def test_options_are_those_of_the_command(accuracy, command_json):
    file = SCENES / "newton_cradle_5.toml"
    expected = command_json("run", file, "--set", f"run.accuracy={accuracy}")
    hit = mt.simulate(mt.load(file), accuracy=accuracy)
    assert hit.velocity.tolist() == expected["final"]["velocity"]
    assert hit.impulse.tolist() == [one["impulse"] for one in expected["contacts"]]
    assert hit.icr.tolist() == expected["icr"]


@pytest.mark.parametrize("name", ["newton_cradle_5", "rocking_block", "microsphere", "throw"])
def test_the_error_is_estimated_if_asked_for_as_by_the_command(name, command_json):
    file = SCENES / f"{name}.toml"
    scene = mt.load(file)
    plain, hit = mt.simulate(scene), mt.simulate(scene, estimate=True)
    assert 0 <= hit.estimated_accuracy < 1e-10 and np.isnan(plain.estimated_accuracy)
    assert hit.json()["accuracy"] == command_json("run", file, "--estimate")["accuracy"]
    assert hit.velocity.tolist() == plain.velocity.tolist()
    assert pickle.loads(pickle.dumps(hit)).estimated_accuracy == hit.estimated_accuracy


def test_quick_numbers_are_those_of_the_whole(triplet):
    chains = [triplet, triplet.replace({"chain.velocity": [1, -0.5, -2]}), mt.load(SCENES / "mixed_laws.toml")]
    for chain in chains:
        hit = mt.simulate(chain)
        whole = hit.json()
        assert whole["ending"] == hit.ending.name
        assert whole["final"]["time"] == hit.time
        assert whole["final"]["velocity"] == hit.velocity.tolist()
        assert [one["impulse"] for one in whole["contacts"]] == hit.impulse.tolist()
        assert [math.nan if one is None else one for one in whole["icr"]] == pytest.approx(hit.icr, abs=0, nan_ok=True)


def address(array):
    return array.__array_interface__["data"][0]


@pytest.mark.parametrize("name", ["velocity", "impulse", "icr", "gap", "peak_force", "peak_indentation", "stored",
                                  "dissipated", "impulse_direction"])
def test_arrays_share_the_memory_of_the_result(name, triplet):
    hit = mt.simulate(triplet)
    one, other = getattr(hit, name), getattr(hit, name)
    assert address(one) == address(other) and np.shares_memory(one, other)
    assert not one.flags.writeable and not one.flags.owndata and one.dtype == np.float64
    with pytest.raises(ValueError):
        one[0] = 1


def test_arrays_outlive_the_result(triplet):
    velocity = mt.simulate(triplet).velocity
    expected = velocity.tolist()
    gc.collect()
    [mt.simulate(triplet.replace({"chain.velocity[0]": float(v)})) for v in range(1, 50)]
    assert velocity.tolist() == expected


def test_members_of_contacts_lie_side_by_side(triplet):
    hit = mt.simulate(triplet)
    forces, indentations = hit.peak_force, hit.peak_indentation
    assert forces.strides == indentations.strides and address(indentations) - address(forces) == 8


def test_balances_close(triplet):
    hit = mt.simulate(triplet)
    energy, momentum = hit.energy, hit.momentum
    assert energy.final + energy.stored + energy.dissipated - energy.initial - energy.work == energy.residual
    assert abs(energy.residual) < 1e-9 * energy.initial
    assert momentum.final - momentum.initial == pytest.approx(momentum.residual, abs=1e-18)


def test_a_pair_of_equal_balls_swaps_velocities():
    hit = mt.simulate(mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness=1), accuracy=1e-12)
    assert hit.velocity == pytest.approx([0, 1], abs=1e-12)
    depth = (5 / 8) ** 0.4  # ½ m* v² = 2/5 k δ^{5/2} with m* = 1/2
    assert hit.peak_indentation == pytest.approx([depth], rel=1e-9)
    assert hit.peak_force == pytest.approx([depth**1.5], rel=1e-9)


def test_contacts_of_events_count_from_zero(triplet):
    events = mt.simulate(triplet).events
    assert events[0].close == (0, 1) and [event.open for event in events] == [(), (0,), (1,)]
    periods = mt.simulate(triplet).periods
    assert [one.shape for one in periods] == [(1, 2), (1, 2)]
    assert periods[1][0, 1] == events[2].time


def test_contacts_that_yield_say_so_in_events():
    hit = mt.simulate(mt.load(SCENES / "steel_pair.toml"))
    assert [one.yields for one in hit.events] == [(), (0,), (), ()] and [one.unload for one in hit.events][2] == (0,)


def test_contacts_tell_what_has_yielded():
    hit = mt.simulate(mt.load(SCENES / "steel_pair.toml"))
    assert hit.plastic_work == pytest.approx(hit.dissipated) and hit.permanent_indentation[0] > 0
    assert hit.adhesion_loss.tolist() == [0]


def test_an_impact_that_does_not_end_has_an_empty_end():
    (one,) = mt.simulate(mt.load(SCENES / "captured_sphere.toml")).impacts
    assert one.tip == 0 and one.start == 0 and one.peak_force > 0 and one.normal_velocity_in < 0
    assert np.isnan([one.end, one.normal_velocity_out, one.centre_velocity_out, *one.slip_out]).all()


def test_a_ratio_without_impulse_is_nan():
    hit = mt.simulate(mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 5], law="hertz", stiffness=1, gap=[0, 1]))
    assert np.isnan(hit.icr).all() and hit["icr[0]"] != hit["icr[0]"]


def test_endings_are_an_enum(triplet):
    assert mt.simulate(triplet).ending is mt.Ending.separated
    assert mt.simulate(triplet, until="1 us").ending is mt.Ending.time_limit
    assert mt.simulate(triplet, max_events=1).ending is mt.Ending.event_limit
    captured = mt.simulate(mt.load(SCENES / "captured_sphere.toml"))
    assert captured.ending is mt.Ending.captured


def test_a_limit_is_the_message_of_its_run(triplet):
    assert mt.simulate(triplet, max_events=1).message == "max_events = 1 was reached before the end"
    assert mt.simulate(triplet, max_time="1 us").message == "max_time = 1e-06 s was reached before the end"
    assert mt.simulate(triplet, until="1 us").message == "" == mt.simulate(triplet).message
    assert mt.sweep(triplet, {"run.max_events": [1]}, columns=["velocity"]).reasons == {
        0: "max_events = 1 was reached before the end"}


def test_a_run_beyond_every_law_ends_as_that_of_the_command(command_json, tmp_path):
    balls = dict(radius="5 mm", material="polystyrene", law="hertz")
    endings = {}
    for speed in (10, 650, 5000):
        scene = mt.Chain(**balls, velocity=[speed, 0])
        (tmp_path / "balls.toml").write_text(scene.text)
        expected = command_json("run", tmp_path / "balls.toml", code=4 if speed == 5000 else 0)
        hit = mt.simulate(scene)
        assert (hit.ending.name, hit.message) == (expected["ending"], expected.get("message") or "")
        grid = mt.sweep(scene, {"velocity[0]": [speed]}, columns=["velocity"])
        assert grid.ending.tolist() == [hit.ending]
        endings[speed] = hit.ending
    assert endings == {10: mt.Ending.separated, 650: mt.Ending.separated, 5000: mt.Ending.invalid}


@pytest.mark.parametrize("options", [{"accuracy": 0}, {"accuracy": math.nan}, {"max_time": "1 kg"}, {"max_events": 0},
                                     {"flow": "magic"}, {"until": -1}])
def test_options_without_sense_are_refused(options, triplet):
    with pytest.raises(mt.InvalidParameter):
        mt.simulate(triplet, **options)


def test_a_flow_can_be_asked_for(triplet):
    hit = mt.simulate(triplet, flow="cvode-adams", accuracy=1e-8)
    assert "cvode-adams" in [flow.name for flow in hit.flows]
    assert hit.velocity == pytest.approx(mt.simulate(triplet).velocity, abs=1e-8)


def test_a_number_of_a_member_is_found_by_its_index(triplet):
    hit = mt.simulate(triplet)
    assert hit["velocity[1]"] == hit.velocity[1] and hit["peak_force[0]"] == hit.peak_force[0]
    grid = mt.sweep(triplet, {"velocity[0]": [1, 2]}, columns=["velocity[1]", "impulse[0]"])
    assert list(grid) == ["final.velocity[1]", "contacts[0].impulse"]
    assert grid["velocity[1]"].shape == (2,)


def test_a_key_that_no_result_has_is_a_key_error(triplet):
    hit = mt.simulate(triplet)
    assert hit["contacts[1].peak_force"] == hit.peak_force[1] and hit["events.count"] == 3
    with pytest.raises(KeyError):
        hit["contacts[1].colour"]
    with pytest.raises(KeyError, match=r"no result has 'velocitty' \(did you mean 'final.velocity\[0\]'\?\)"):
        hit["velocitty"]


@pytest.mark.parametrize("key, count", [("contacts[9].peak_force", "2 of contacts[]"), ("icr[1]", "1 of icr[]"),
                                        ("final.velocity[3]", "3 of final.velocity[]"),
                                        ("events[3].time", "3 of events[]"),
                                        ("contacts[9].periods[*][0]", "2 of contacts[]"),
                                        ("contacts[0].periods[1][0]", "1 of contacts[].periods[]")])
def test_an_index_that_a_result_does_not_have_is_a_key_error(key, count, triplet):
    with pytest.raises(KeyError) as caught:
        mt.simulate(triplet)[key]
    assert caught.value.args[0].startswith(key) and f"it has {count}, counted from 0" in caught.value.args[0]


def test_keys_with_stars_are_arrays(triplet):
    hit = mt.simulate(triplet)
    assert np.array_equal(hit["contacts[*].impulse"], hit.impulse)
    assert hit["events[*].time"].tolist() == [one.time for one in hit.events]
    assert np.array_equal(hit["contacts[*].periods[*][0]"], [periods[:, 0] for periods in hit.periods])
    ball = mt.simulate(mt.load(SCENES / "thrown_rod.toml"))
    assert np.array_equal(ball["final.bodies[*].velocity[*]"], ball.velocity)
    with pytest.raises(KeyError, match="no result has 'contacts"):
        hit["contacts[*].colour"]


def test_rows_of_different_lengths_are_no_array():
    hit = mt.simulate(mt.load(SCENES / "microrod.toml"))
    with pytest.raises(KeyError, match="rows of different lengths"):
        hit["events[*].close[*]"]


@pytest.mark.parametrize("name", ["ending", "message", "events", "energy"])
def test_a_member_that_is_no_number_is_named(name, triplet):
    with pytest.raises(KeyError, match=f"{name} is no number but a member of results, as in hit.{name}"):
        mt.simulate(triplet)[name]


@pytest.mark.parametrize("name, hint", [("velocities", "did you mean velocity?"), ("periode", "did you mean periods?"),
                                        ("contacts", "it has adhesion_loss, cite, ")])
def test_a_member_that_is_not_there_is_told_with_the_nearest(name, hint, triplet):
    hit = mt.simulate(triplet)
    with pytest.raises(AttributeError, match=f"^ChainImpact has no {name}: {re.escape(hint)}"):
        getattr(hit, name)
    assert not hasattr(hit, "__array__") and copy.copy(hit).time == hit.time


def test_a_column_that_is_not_there_is_told_with_the_nearest(triplet):
    with pytest.raises(mt.InvalidParameter, match=r"no result has 'velocty' \(did you mean 'final.velocity\[0\]'\?\)"):
        mt.sweep(triplet, {"velocity[0]": [1]}, columns=["velocty"])


@pytest.mark.parametrize("name", ["triplet", "y_chain", "microsphere", "rocking_with_friction"])
def test_a_result_has_the_names_of_columns(name):
    scene = mt.load(SCENES / f"{name}.toml")
    hit = mt.simulate(scene)
    for column in ["time", *_members(scene)]:
        np.testing.assert_array_equal(hit[column], getattr(hit, column))


def test_contacts_and_bodies_have_their_own_members(triplet):
    with pytest.raises(AttributeError):
        mt.simulate(triplet).restitution
    with pytest.raises(AttributeError):
        mt.simulate(mt.load(SCENES / "microsphere.toml")).icr


def test_jupyter_shows_the_report(triplet):
    hit = mt.simulate(triplet)
    assert "Impulse correlation ratios" in str(hit) and hit._repr_html_().startswith("<pre>")
    assert "count from 1" in hit._repr_html_()


def test_warnings_are_those_of_the_command_and_are_told(command_json):
    file = SCENES / "microsphere.toml"
    expected = command_json("run", file)["warnings"]
    with pytest.warns(mt.ModelWarning) as told:
        hit = mt.simulate(mt.load(file))
    assert hit.warnings == expected == [str(one.message) for one in told] and len(expected) == 2
    assert {one.filename for one in told} == {__file__}
    assert repr(hit).endswith(", 2 warnings>")
    assert str(hit).endswith(f"\nwarning: {expected[1]}") and "warning: tip 1: max a/R" in hit._repr_html_()


BALLS = dict(radius="10 mm", law="hertz", velocity=[100, 0])
PLAIN = dict(mass=1, law="hertz", stiffness=1)


@pytest.mark.parametrize("chain, flow, words", [
    (dict(BALLS, material="steel"), None, ["contact 1: max a/R = "]), (dict(PLAIN, velocity=[1, 0]), None, []),
    (dict(PLAIN, velocity=[0, 1]), None, ["nothing collides"]), (dict(PLAIN, velocity=[1, 0]), "modal", ["no contact"]),
    (dict(PLAIN, velocity=[0, 0]), None, ["<Chain>:1:1: chain: nothing moves", "nothing collides"])])
def test_short_chains_have_all_warnings(chain, flow, words):
    chain = mt.Chain(balls=2, **chain)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        hit = mt.simulate(chain, flow=flow)
    texts = [str(one.message) for one in told]
    assert texts == hit.warnings == hit.json().get("warnings", []) and ("warning" in repr(hit)) == bool(words)
    assert len(texts) >= len(words) and all(text.startswith(word) for text, word in zip(texts, words))


def test_a_sweep_warns_once_of_its_scene():
    cradle = mt.Chain(balls=3, mass=1, radius="10 m", law="hertz", stiffness=1, velocity=[1, 0, 0])
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        grid = mt.sweep(cradle, {"velocity[0]": np.linspace(1, 2, 50)}, columns="velocity")
    assert [str(one.message) for one in told] == grid.warnings and len(grid.warnings) <= 2


def speed_after(scene):
    return mt.simulate(scene).velocity[-1]


def test_scenes_and_results_travel_to_other_processes(triplet):
    scenes = [triplet.replace({"chain.velocity[0]": speed}) for speed in (1.0, 2.0, 3.0)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        there = pool.map(speed_after, scenes)
        results = pool.map(mt.simulate, scenes)
    assert there == [speed_after(scene) for scene in scenes]
    assert [hit.velocity[-1] for hit in results] == there


def test_a_pickled_result_keeps_its_options(triplet):
    hit = mt.simulate(triplet, accuracy=1e-5)
    again = pickle.loads(pickle.dumps(hit))
    assert again.velocity.tolist() == hit.velocity.tolist()
    assert again.json()["accuracy"]["requested"] == 1e-5


def long_row(balls):
    return mt.Chain(balls=balls, mass=1, law="hertz", stiffness=1, ball=[{"number": 1, "velocity": 1}])


def test_other_threads_run_meanwhile():
    row, counted = long_row(100_000), 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    started = time.monotonic()
    mt.simulate(row, flow="taylor")
    elapsed = time.monotonic() - started
    done.set()
    thread.join()
    assert counted > 100 * elapsed  # one that waits for the lock counts nothing


def test_ctrl_c_ends_a_run():
    row = long_row(500_000)
    signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    with pytest.raises(KeyboardInterrupt):
        mt.simulate(row, flow="taylor")


def test_ctrl_c_ends_a_phase_without_events():
    cage = mt.Chain(mass=[math.inf, 1, math.inf], velocity=[0, 0.01, 0], law="hertz", stiffness=1, gap=-0.1,
                    precompressed=True)
    signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    started = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        mt.simulate(cage, until=1e9)
    assert time.monotonic() - started < 60


def test_threads_share_a_scene(triplet):
    expected = mt.simulate(triplet).velocity.tolist()
    found = []
    threads = [threading.Thread(target=lambda: found.extend(mt.simulate(triplet).velocity.tolist() for _ in range(100)))
               for _ in range(4)]
    [one.start() for one in threads]
    [one.join() for one in threads]
    assert found == [expected] * 400


def test_a_law_alone_cannot_be_simulated():
    law = mt.parse("[law]\nmass = [1, 1]\nvelocity = [1, 0]\ndirection = [1]\nenergy_ratio = 1\n")
    with pytest.raises(mt.SceneError):
        mt.simulate(law)



def test_panels_of_impacts_far_apart_count_from_their_first_event():
    pytest.importorskip("matplotlib")
    ball = mt.Chain(balls=1, radius="5 mm", material="steel", law="kuwabara-kono", restitution=0.7, at=0.4,
                    wall="left", gravity=9.81, gap="10 mm", run={"until": "0.15 s"})
    hit = mt.simulate(ball)
    ax = hit.plot.forces()
    first = next(event.time for event in hit.events if event.close)
    assert ax.get_xlabel() == f"$t_0$ = {1e3 * first:.6g} ms"
    assert [label.get_text() for label in ax.get_xticklabels()][0] == "0"
    assert ax.get_xticks()[0] == pytest.approx(first, rel=1e-12)
    assert ax.figure._supxlabel.get_text().startswith("time $t - t_0$ [µs]")
