"""Bodies with friction: scenes, results, sweeps and processes as of the other models."""

import pickle

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES

SCENES_OF_BODIES = ["cradle_with_friction", "dropped_rod", "oblique_sphere", "painleve_rod", "rack_break",
                    "rocking_with_friction"]
SPHERE = dict(dimension=3, law="hertz", tangential="rigid", friction=0.3, stiffness=1e9, share=0,
              body=[{"mass": 1, "radius": 0.1, "position": [0, 0, 0.1], "velocity": [0, 0, -1], "spin": [0, 5, 0]}],
              plane=[{"normal": [0, 0, 1]}])


@pytest.fixture
def ball():
    return mt.load(SCENES / "oblique_sphere.toml")


def body_lists(expected, name):
    return [one[name] for one in expected["final"]["bodies"]]


@pytest.mark.parametrize("name", SCENES_OF_BODIES)
def test_results_are_those_of_the_command_to_the_last_bit(name, command_json):
    expected = command_json("run", SCENES / f"{name}.toml")
    for of_the_command in ("scene", "scene_text", "provenance"):
        expected.pop(of_the_command)
    hit = mt.simulate(mt.load(SCENES / f"{name}.toml"))
    found = hit.json()
    found.pop("provenance")
    assert type(hit) is mt.BodiesImpact and found == expected
    for member in ("position", "velocity", "spin", "angle"):
        assert getattr(hit, member).tolist() == body_lists(expected, member)
    contacts = expected["contacts"]
    for member in ("normal_impulse", "tangential_impulse", "peak_force", "peak_friction", "peak_indentation", "stored"):
        assert getattr(hit, member).tolist() == [one[member] for one in contacts]
    assert [list(one) for one in hit.between] == [one["between"] for one in contacts]
    for name, lost in zip(hit.losses._fields, hit.losses):
        assert lost.tolist() == [one["losses"][name] for one in contacts]
    assert [len(one) for one in hit.periods] == [len(one["periods"]) for one in contacts]


def test_in_space_vectors_have_three_components():
    scene = mt.Bodies(**SPHERE)
    assert scene.dimension == 3 and scene.mass.tolist() == [1]
    assert scene.position.tolist() == [[0, 0, 0.1]] and scene.velocity.tolist() == [[0, 0, -1]]
    assert scene.spin.tolist() == [[0, 5, 0]]
    hit = mt.simulate(scene)
    # rigid stick of a solid sphere: m v = p, 2/5 m r (ω⁻ − ω⁺) = p, v = r ω⁺
    assert hit.velocity == pytest.approx(np.array([[1 / 7, 0, 1]]), abs=1e-9)
    assert hit.spin == pytest.approx(np.array([[0, 10 / 7, 0]]), abs=1e-9)
    assert hit.tangential_impulse.shape == (1, 3) and hit.position.shape == (1, 3)
    assert np.linalg.norm(hit.quaternion, axis=1) == pytest.approx([1], rel=1e-12)


def test_arrays_share_the_memory_of_the_result(ball):
    hit = mt.simulate(ball)
    for name in ("position", "velocity", "spin", "angle", "quaternion", "normal_impulse", "tangential_impulse",
                 "peak_force", "peak_friction"):
        one, other = getattr(hit, name), getattr(hit, name)
        assert np.shares_memory(one, other) and not one.flags.owndata and not one.flags.writeable


def test_events_and_the_inside_of_a_run(ball):
    hit = mt.simulate(ball)
    kinds = {name for event in hit.events for name in event._fields[1:] if getattr(event, name)}
    assert kinds == {kind for one in hit.json()["events"] for kind in one if kind != "time" and one[kind]}
    assert {"close", "open", "unload"} <= kinds
    ends = hit.trajectory.velocity([0, hit.time])
    assert ends.shape == (2, 1, 2) and ends[0].tolist() == ball.velocity.tolist()
    assert ends[1] == pytest.approx(hit.velocity, abs=1e-9)
    assert hit.force(np.linspace(0, hit.time, 500)).max() == pytest.approx(hit.peak_force[0], rel=1e-4)


def test_keys_of_bodies_are_swept(ball):
    friction = [0.05, 0.1, 0.2]
    grid = mt.sweep(ball, {"friction": friction, "body[0].spin": [0, 10.0]},
                    columns=["velocity", "spin", "tangential_impulse", "time"])
    assert grid["velocity"].shape == (3, 2, 1, 2) and grid["spin"].shape == (3, 2, 1)
    assert grid["tangential_impulse"].shape == (3, 2, 1) and grid["time"].shape == (3, 2)
    for i, mu in enumerate(friction):
        hit = mt.simulate(ball.replace({"bodies.friction": mu, "bodies.body[0].spin": 10.0}))
        assert grid["velocity"][i, 1].tolist() == hit.velocity.tolist()
        assert grid["spin"][i, 1].tolist() == hit.spin.tolist()
    both = mt.sweep(mt.Bodies(**SPHERE), {"friction": friction}, columns=["spin", "position"])
    assert both["spin"].shape == both["position"].shape == (3, 1, 3)


def test_they_travel_to_other_processes(ball):
    again = pickle.loads(pickle.dumps(mt.simulate(ball, accuracy=1e-8)))
    assert type(again.scene) is mt.Bodies
    assert again.velocity.tolist() == mt.simulate(ball, accuracy=1e-8).velocity.tolist()


def test_members_of_other_results_are_missing(ball):
    hit = mt.simulate(ball)
    for name in ("icr", "impulse", "restitution"):
        with pytest.raises(AttributeError):
            getattr(hit, name)


def test_friction_and_spins_have_figures(ball, triplet):
    pytest.importorskip("matplotlib")
    hit = mt.simulate(ball)
    pushed = max(np.abs(line.get_ydata()).max() for line in hit.plot.friction().lines if len(line.get_ydata()) > 9)
    assert pushed == pytest.approx(hit.peak_friction[0], rel=1e-2)
    ends = [line.get_ydata()[-1] for line in hit.plot.spins().lines if len(line.get_ydata()) > 9]
    assert ends[0] == pytest.approx(hit.spin.ravel()[np.abs(hit.spin.ravel()).argmax()], abs=1e-9)
    with pytest.raises(mt.Error, match="bodies alone"):
        mt.simulate(triplet).plot.friction()
    smooth = mt.simulate(ball.replace({"bodies.friction": 0.0}))
    with pytest.raises(ValueError, match="there is no friction"):
        smooth.plot.friction()


def test_images_name_contacts_by_their_numbers():
    pytest.importorskip("matplotlib")
    hit = mt.simulate(mt.load(SCENES / "rack_break.toml"))
    closed = [j + 1 for j, periods in enumerate(hit.periods) if len(periods)]
    for ax in (hit.plot.forces(), hit.plot.friction()):
        names = [int(label.get_text()) for label in ax.get_yticklabels()]
        assert names == closed[::2] and names != list(range(1, len(names) + 1))


def test_figures_have_a_curve_per_contact_and_component(ball):
    pytest.importorskip("matplotlib")
    hit = mt.simulate(ball)
    assert hit.plot.forces().lines[0].get_ydata().max() == pytest.approx(hit.peak_force[0], rel=1e-2)
    ends = [line.get_ydata()[-1] for line in hit.plot.velocities().lines[:2]]
    assert ends == pytest.approx(hit.velocity[0], abs=1e-9)


def test_curves_name_the_contacts_that_events_count_from_0_by_numbers_from_1():
    pytest.importorskip("matplotlib")
    hit = mt.simulate(mt.load(SCENES / "rocking_with_friction.toml"))
    labels = [line.get_label() for line in hit.plot.forces().figure.axes[0].lines]
    named = [label for label in labels if label.startswith("$f")]
    assert named == ["$f_{1}$ (floor–block.1)", "$f_{3}$ (floor–block.3)"]
    assert (2,) in [event.close for event in hit.events] and hit.between[2] == ("floor", "block.3")
