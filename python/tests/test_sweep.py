"""Sweeps in memory: the numbers of the command, as views of one table."""

import copy
import csv
import pickle
import signal

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES

AXES = {"velocity[0]": np.linspace(0.1, 2, 4), "gap[1]": np.geomspace(1e-7, 2e-5, 3)}


def test_columns_have_the_shape_of_the_grid(triplet):
    grid = mt.sweep(triplet, AXES, columns=["velocity", "contacts[1].peak_force", "events.count"])
    assert grid.shape == (4, 3)
    assert grid["velocity"].shape == (4, 3, 3) and grid["contacts[1].peak_force"].shape == (4, 3)
    assert np.array_equal(grid.axes["chain.gap[1]"], AXES["gap[1]"])
    assert (grid.ending == mt.Ending.separated).all()
    assert grid.units["contacts[1].peak_force"] == "N" and grid.symbols["contacts[1].peak_force"] == "max f_j"
    assert grid.units["chain.velocity[0]"] == "m/s" and grid.units["chain.gap[1]"] == "m"
    assert grid.keys_of("velocity") == [f"final.velocity[{i}]" for i in range(3)]


def test_the_last_ball_has_a_column_whatever_the_number():
    row = mt.Chain(balls=3, mass=1, stiffness=1, law="hertz", ball=[{"number": 1, "velocity": 1}])
    grid = mt.sweep(row, {"balls": [2, 5]}, columns=["final.velocity[-1]"])
    for balls, last in zip((2, 5), grid["final.velocity[-1]"]):
        hit = mt.simulate(row.replace({"balls": balls}))
        assert last == pytest.approx(hit.velocity[-1], abs=1e-12) and hit["final.velocity[-1]"] == hit.velocity[-1]
    with pytest.raises(KeyError, match="it has 5 of final.velocity"):
        hit["final.velocity[-6]"]


def test_columns_are_found_from_the_end(triplet):
    grid = mt.sweep(triplet, AXES, columns=["velocity", "icr"])
    assert np.array_equal(grid["velocity[-1]"], grid["velocity"][..., -1])
    assert np.array_equal(grid["final.velocity[-3]"], grid["velocity[0]"])
    assert grid.keys_of("icr[-1]") == ["icr[0]"]
    with pytest.raises(KeyError, match="no column"):
        grid["velocity[-4]"]


def test_equal_scenes_have_equal_sweeps(triplet):
    grid = mt.sweep(triplet, AXES, columns=["velocity", "icr"])
    again = mt.sweep(pickle.loads(pickle.dumps(triplet)), AXES, columns=["velocity", "icr"])
    assert grid == again and grid == pickle.loads(pickle.dumps(grid))
    assert grid != mt.sweep(triplet, AXES, columns=["velocity"]) and grid != 1
    assert triplet == copy.copy(triplet) and triplet != triplet.replace({"velocity[0]": 7})
    assert len({triplet, pickle.loads(pickle.dumps(triplet))}) == 1


def test_runs_of_a_sweep_end_when_asked(triplet):
    grid = mt.sweep(triplet, {"velocity[0]": [0.1, 1]}, columns="time", until="1 us")
    assert grid["time"] == pytest.approx([1e-6, 1e-6]) and (grid.ending == mt.Ending.time_limit).all()


def test_every_point_is_that_of_a_single_run(triplet):
    grid = mt.sweep(triplet, AXES, columns=["velocity", "time"])
    for i, speed in enumerate(AXES["velocity[0]"]):
        for j, gap in enumerate(AXES["gap[1]"]):
            hit = mt.simulate(triplet.replace({"chain.velocity[0]": speed, "chain.gap": [0, gap]}))
            assert grid["velocity"][i, j] == pytest.approx(hit.velocity, abs=1e-10 * speed)
            assert grid["time"][i, j] == pytest.approx(hit.time, rel=1e-9)


def test_columns_are_views_of_one_table(triplet):
    grid = mt.sweep(triplet, AXES, columns=["velocity", "icr[0]"])
    start = grid.table.__array_interface__["data"][0]
    for name, offset in (("velocity", 0), ("icr[0]", 24)):
        assert grid[name].__array_interface__["data"][0] == start + offset
        assert not grid[name].flags.writeable


def test_rows_are_those_of_the_command(command, tmp_path):
    scene = SCENES / "triplet_map.toml"
    few = {"sweep[0].count": 7, "sweep[1].count": 5}
    command("sweep", scene, "--out", tmp_path / "map", "--no-figures", "-q",
            *(f"--set={key}={value}" for key, value in few.items()))
    grid = mt.sweep(mt.load(scene, replace=few))
    grid.save(tmp_path / "here.csv")
    assert (tmp_path / "here.csv").read_bytes() == (tmp_path / "map" / "sweep.csv").read_bytes()
    rows = list(csv.DictReader((tmp_path / "here.csv").open()))
    assert [float(row["icr[0]"]) for row in rows] == grid["icr[0]"].ravel().tolist()


@pytest.mark.parametrize("again", [lambda grid: pickle.loads(pickle.dumps(grid)), copy.copy, copy.deepcopy])
def test_sweeps_are_pickled_with_their_numbers(again, triplet, tmp_path):
    axes = {("velocity[0]", "gap[1]"): ([1, 2], [0, 1e-6]), "law": ["hertz", "linear"]}
    grid = mt.sweep(triplet, axes, columns=["velocity", "half = icr[0] / 2"], accuracy=1e-6)
    other = again(grid)
    assert np.array_equal(other.table, grid.table, equal_nan=True) and np.array_equal(other.ending, grid.ending)
    assert other.reasons == grid.reasons != {} and list(other) == list(grid) and other.shape == grid.shape
    for one, name in ((grid, "grid.csv"), (other, "other.csv")):
        one.save(tmp_path / name)
    assert (tmp_path / "grid.csv").read_text() == (tmp_path / "other.csv").read_text()


def test_numbers_of_other_columns_are_no_sweep(triplet):
    make, (scene, asked, table, ending, reasons) = mt.sweep(triplet, {"velocity[0]": [1]}).__reduce__()
    with pytest.raises(ValueError, match="another version"):
        make(scene, asked, table[:, 1:], ending, reasons)


def test_columns_may_be_left_to_the_sweep(triplet):
    axes = {"velocity[0]": [1]}
    assert list(mt.sweep(triplet, axes, columns=None)) == list(mt.sweep(triplet, axes, columns=[]))


def test_keys_may_move_together(triplet):
    grid = mt.sweep(triplet, {("velocity[0]", "velocity[2]"): ([1, 2, 3], [0, -1, -2])}, columns=["velocity"])
    assert grid.shape == (3,) and grid.axis_of == {"chain.velocity[0]": 0, "chain.velocity[2]": 0}
    hit = mt.simulate(triplet.replace({"chain.velocity": [3, 0, -2]}))
    assert grid["velocity"][2] == pytest.approx(hit.velocity, abs=5e-10)


def test_a_sweep_says_how_large_it_is(triplet):
    sizes = {len(speeds): repr(mt.sweep(triplet, {"velocity[0]": speeds, "velocity[1]": [0]}, columns="time"))
             for speeds in ([1], [1, 2])}
    assert sizes == {1: "<mariotte.Sweep of 1 × 1 point: final.time>", 2: "<mariotte.Sweep of 2 × 1 points: final.time>"}


def test_words_and_units_are_values(triplet):
    grid = mt.sweep(triplet, {"material": ["steel", "glass"], "radius": ["10 mm", "2 cm"]}, columns=["time"])
    assert grid["time"].shape == (2, 2) and grid["time"][0, 1] > grid["time"][0, 0]


def test_axes_and_columns_replace_those_of_the_scene():
    scene = mt.load(SCENES / "throw.toml")  # whose columns are of its own variable
    grid = mt.sweep(scene, {"bodies.friction": [0.03, 0.06]}, columns=["final.bodies[1].spin"])
    alone = mt.simulate(scene.replace({"bodies.friction": 0.03}))
    assert grid["final.bodies[1].spin"][0] == alone["final.bodies[1].spin"]


def test_keys_of_a_body_need_no_table():
    grid = mt.sweep(mt.load(SCENES / "microsphere.toml"), {"radius": ["2 um", "3 um"]}, columns=["velocity", "spin"])
    assert list(grid.axes) == ["body.radius"] and grid["velocity"].shape == grid["spin"].shape == (2, 3)


def test_a_law_is_a_key_of_the_chain(triplet):
    grid = mt.sweep(mt.Chain(mass=[1, 1], velocity=[1, 0], law="hertz", stiffness=1), {"law": ["hertz"]},
                    columns=["time"])
    assert list(grid.axes) == ["chain.law"] and np.isfinite(grid["time"]).all()


def test_gaps_of_a_row_in_equilibrium_are_the_given_ones():
    row = mt.Chain(mass=[1, 0.5, 2], velocity=[0, 0, 0], gap=[0, 0, 1e-3], law="hertz", stiffness=1e6, wall="left",
                   gravity=9.81, start="equilibrium", run={"until": 0.02})
    grid = mt.sweep(row, {"gap[2]": [1e-4, 1e-3]}, columns=["velocity"])
    assert np.array_equal(grid["velocity"][1], mt.simulate(row).velocity)


def test_points_without_sense_are_told(triplet):
    grid = mt.sweep(triplet, {"gap[0]": [0, -1e-9], "precompressed": [False, True]}, columns=["time"])
    assert (grid.ending == mt.Ending.rejected).tolist() == [[False, False], [True, False]]
    assert np.isnan(grid["time"]).tolist() == [[False, False], [True, False]]
    assert list(grid.reasons) == [2] and "gap" in grid.reasons[2]


@pytest.mark.parametrize("axes, columns", [({"colour": [1]}, ["time"]), ({"velocity[7]": [1]}, ["time"]),
                                           ({"velocity[0]": ["1 kg"]}, ["time"]), ({"velocity[0]": [1]}, ["colour"])])
def test_wrong_keys_values_and_columns_are_refused(axes, columns, triplet):
    with pytest.raises((mt.SceneError, mt.InvalidParameter)):
        mt.sweep(triplet, axes, columns=columns)


def test_threads_do_not_change_a_bit(triplet):
    one, four = (mt.sweep(triplet, AXES, columns=["velocity"], threads=count) for count in (1, 4))
    assert one.table.tobytes() == four.table.tobytes()


@pytest.mark.parametrize("threads, expected", [(0, "at least one thread"), (-1, "at least one thread"),
                                               (10**5, "at most 4096"), (10**12, "at most 4096")])
def test_work_needs_a_number_of_threads_that_can_be(threads, expected, triplet):
    with pytest.raises(mt.InvalidParameter, match=expected):
        mt.sweep(triplet, AXES, columns=["velocity"], threads=threads)
    with pytest.raises(mt.InvalidParameter, match=expected):
        mt.solve(1, [1, 1], [1, 0, 0], threads=threads)


def test_ctrl_c_ends_a_sweep(triplet):
    signal.signal(signal.SIGALRM, lambda *_: signal.raise_signal(signal.SIGINT))
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    with pytest.raises(KeyboardInterrupt):
        mt.sweep(triplet, {"velocity[0]": np.linspace(1, 2, 3000), "velocity[1]": np.linspace(-1, 0, 3000)},
                 columns=["peak_force"])


def test_many_chains_are_solved_as_single_ones():
    random = np.random.default_rng(7)
    mass, velocity = random.uniform(1, 2, (50, 4)), random.normal(size=(50, 4))
    stiffness = random.uniform(1e8, 1e9, (50, 3))
    accuracy = 1e-9
    many = mt.solve(mass, stiffness, velocity, accuracy=accuracy)
    assert (many.ending == mt.Ending.separated).all()
    for row in range(50):
        hit = mt.simulate(mt.Chain(mass=mass[row], velocity=velocity[row], law="hertz", stiffness=stiffness[row]),
                          accuracy=accuracy)
        allowed = accuracy * np.ptp(velocity[row])
        np.testing.assert_allclose(many.velocity[row], hit.velocity, rtol=0, atol=allowed)
        np.testing.assert_allclose(many.impulse[row], hit.impulse, rtol=0, atol=2 * allowed)
        np.testing.assert_allclose(many.icr[row], hit.icr, rtol=100 * accuracy)
        np.testing.assert_allclose(many.time[row], hit.time, rtol=100 * accuracy)


def test_momentum_is_kept_by_all_rows():
    velocity = np.random.default_rng(1).normal(size=(1000, 3))
    many = mt.solve([1, 2, 3], 1e9, velocity, law="viscoelastic", damping=1e3, gap=1e-6)
    assert many.velocity @ [1, 2, 3] == pytest.approx(velocity @ [1, 2, 3], abs=1e-12)


def test_many_chains_are_told_in_a_line():
    velocity = np.zeros((1000, 3))
    velocity[:, 0] = 1
    many = mt.solve([1, 1, 1], 1e9, velocity)
    assert repr(many) == str(many) == "<mariotte.Solved of 1000 chains of 3 balls: 1000 separated>"
    two = many._replace(ending=np.where(np.arange(1000) < 2, mt.Ending.failed, many.ending))
    assert repr(two).endswith(": 998 separated, 2 failed>") and repr(mt.solve(1, 1, [1, 0])).count("chain ") == 1
    assert np.isnan(mt.solve(1, 1, [1, 0, 0], gap=[0, 1], law="linear").icr).tolist() == [[False]]
    assert np.isnan(mt.solve(1, 1, [-1, 0, 0]).icr).tolist() == [[True]]


def test_what_is_less_exact_than_was_asked_says_so():
    box = mt.Chain(mass=[1, 1.3, 0.7, 1.1], velocity=[1, 0, -0.5, 0.2], law="hertz", stiffness=1e6, wall="both",
                   gap=[0.1] * 5, run={"until": 100})
    with pytest.warns(mt.ModelWarning, match="velocities of 2 points may be less exact than was asked"):
        grid = mt.sweep(box, {"velocity[0]": [1, 1 + 1e-15]}, columns="velocity")
    assert all(reason.startswith("velocities may be wrong by") for reason in grid.reasons.values())
    row = np.array([[1e-3, 10, 1e-4, 20, 1e-3, 5, 1e-4, 30]])
    with pytest.warns(mt.ModelWarning, match="velocities of 1 chain may be less exact"):
        many = mt.solve(row, 1e9, [1, 0, 0, 0, 0, 0, 0, -1], gap=1e-3, accuracy=1e-14)
    assert many.estimated_accuracy[0] > 1e-14
    assert np.isnan(mt.solve([1, 1, 1], 1e9, [1, 0, 0]).estimated_accuracy).all()


def test_many_columns_have_a_short_name():
    grid = mt.sweep(mt.Chain(balls=20, mass=1, law="hertz", stiffness=1, velocity=[1] + 19 * [0]), {"mass": [1, 2]},
                    columns="velocity")
    assert repr(grid).endswith("final.velocity[7], … 20 columns>")
    with pytest.raises(KeyError, match=r"icr is no column of this sweep: .* 20 columns"):
        grid["icr"]


def test_no_chains_have_no_results():
    none = mt.solve([1, 1, 1], 1e9, np.empty((0, 3)))
    assert [one.shape for one in none] == [(0, 3), (0, 2), (0,), (0,), (0,)]
    with pytest.raises(mt.InvalidParameter, match=r"velocity has the shape \(0, 3\), but \(2, 3\)"):
        mt.solve(np.ones((2, 3)), 1e9, np.empty((0, 3)))


def test_a_row_without_sense_is_named():
    with pytest.raises(mt.InvalidParameter, match="row 1: .*mass"):
        mt.solve([[1, 1], [1, -1]], 1, [1, 0])
    with pytest.raises(mt.InvalidParameter, match="no law 'magic'"):
        mt.solve(1, 1, [1, 0], law="magic")
    with pytest.raises(ValueError):
        mt.solve(np.ones((2, 3)), 1, np.ones((2, 4)))


def test_quantities_are_converted():
    unit = pytest.importorskip("pint").UnitRegistry()
    mass, speed = [1000, 2000] * unit.gram, np.array([[100, 0], [200, 0]]) * unit.cm / unit.s
    k, gap = 1e9 * unit.newton / unit.meter**1.5, [1 * unit.mm]
    there = mt.solve(mass, k, speed, gap=gap)
    here = mt.solve([1, 2], 1e9, [[1, 0], [2, 0]], gap=1e-3)
    assert there.velocity == pytest.approx(here.velocity, rel=1e-12)
    assert there.time == pytest.approx(here.time, rel=1e-9)
    for wrong in (lambda: mt.solve([1, 2] * unit.second, k, speed), lambda: mt.solve(mass, k, mass)):
        with pytest.raises(TypeError, match="convert"):
            wrong()


@pytest.mark.parametrize("last, ticks", [(10, ["1", "2", "5", "10"]), (2, ["1", "1.25", "1.5", "1.75", "2"])])
def test_short_logarithmic_axes_have_numbers(triplet, last, ticks):
    pytest.importorskip("matplotlib")
    ax = mt.sweep(triplet, {"velocity[0]": np.geomspace(1, last, 20)}).plot("velocity")
    ax.figure.canvas.draw()
    low, high = ax.get_xlim()
    shown = [label.get_text() for label in ax.get_xticklabels() if low <= label.get_position()[0] <= high]
    assert ax.get_xscale() == "log" and shown == ticks
