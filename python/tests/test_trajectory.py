"""The inside of a run, against closed forms and balances."""

import math

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES


def test_a_linear_contact_is_half_a_sine():
    pair = mt.Chain(mass=[1, math.inf], velocity=[1, 0], law="linear", stiffness=4)
    hit = mt.simulate(pair, accuracy=1e-12)
    t = np.linspace(0, hit.time, 101)
    assert hit.time == pytest.approx(math.pi / 2, rel=1e-12)
    assert hit.force(t)[:, 0] == pytest.approx(2 * np.sin(2 * t), abs=1e-11)
    assert hit.trajectory.velocity(t)[:, 0] == pytest.approx(np.cos(2 * t), abs=1e-11)
    assert hit.trajectory.gap(t)[:, 0] == pytest.approx(-0.5 * np.sin(2 * t), abs=1e-11)


@pytest.mark.parametrize("name", ["newton_cradle_5", "viscoelastic", "rack_of_fifteen", "microsphere", "microrod"])
def test_ends_are_those_of_scene_and_result(name):
    hit = mt.simulate(mt.load(SCENES / f"{name}.toml"))
    velocity = hit.trajectory.velocity([0, hit.time])
    scale = np.abs(velocity).max()
    assert velocity[1] == pytest.approx(hit.velocity, abs=2e-10 * scale)
    if not isinstance(hit, mt.MicrobodyImpact):
        assert velocity[0].tolist() == hit.scene.velocity.tolist()


def test_the_integral_of_the_force_is_the_impulse(triplet):
    hit = mt.simulate(triplet, accuracy=1e-12)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    ends = [event.time for event in hit.events]
    impulse = sum(0.5 * (b - a) * weights @ hit.force(0.5 * (b - a) * nodes + 0.5 * (a + b))
                  for a, b in zip(ends, ends[1:]))
    assert impulse == pytest.approx(hit.impulse, rel=1e-6)  # forces of Hertz are not smooth at the ends


def test_times_may_have_any_shape_and_order(triplet):
    hit = mt.simulate(triplet)
    t = hit.time * np.array([[0.5, 0.1], [0.9, 0.5]])
    force = hit.force(t)
    assert force.shape == (2, 2, 2) and hit.force(t[0, 1]).shape == (2,)
    assert force[0, 0].tolist() == force[1, 1].tolist()
    assert force[0, 1] == pytest.approx(hit.force(t[0, 1]), rel=1e-9)
    assert hit.force([]).shape == (0, 2)


def test_one_run_tells_all_at_these_times(triplet):
    hit = mt.simulate(triplet)
    t = hit.time * np.array([[0.7], [0.2]])
    samples = hit.trajectory.at(t)
    assert samples.time.tolist() == t.tolist()
    assert samples.velocity.shape == (2, 1, 3) and samples.gap.shape == samples.force.shape == (2, 1, 2)
    for name in ("velocity", "gap", "force"):
        assert getattr(samples, name).tolist() == getattr(hit.trajectory, name)(t).tolist()


@pytest.mark.parametrize("t", [-1e-9, 1.0, math.nan])
def test_times_outside_the_run_are_refused(t, triplet):
    with pytest.raises(ValueError, match="times lie between"):
        mt.simulate(triplet).force(t)


def test_the_end_that_was_asked_for_is_inside(triplet):
    for end in np.linspace(1e-6, 9e-6, 40):
        assert mt.simulate(triplet, until=end).trajectory.force([0, end]).shape == (2, 2)


def test_the_largest_sample_is_the_peak(triplet):
    hit = mt.simulate(triplet)
    steps = hit.trajectory.steps()
    assert steps.force.shape == (len(steps.time), 2) and (np.diff(steps.time) >= 0).all()
    fine = hit.force(np.linspace(0, hit.time, 2000))
    assert fine.max(axis=0) == pytest.approx(hit.peak_force, rel=1e-5)
    assert (fine.max(axis=0) <= hit.peak_force * (1 + 1e-9)).all()


def test_times_may_be_quantities(triplet):
    unit = pytest.importorskip("pint").UnitRegistry()
    hit = mt.simulate(triplet)
    t = np.array([0.2, 0.5]) * hit.time
    assert hit.force(1e6 * t * unit.microsecond) == pytest.approx(hit.force(t), rel=1e-9)
