"""Figures and files."""

import json
import sys

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES


def test_files_are_those_of_the_command(command, tmp_path, triplet):
    command("run", SCENES / "triplet.toml", "--out", tmp_path / "there")
    hit = mt.simulate(mt.load(SCENES / "triplet.toml"))
    hit.save(tmp_path / "trace.csv")
    hit.save(tmp_path / "result.json")
    assert (tmp_path / "trace.csv").read_text() == (tmp_path / "there" / "trace.csv").read_text()
    saved, there = (json.loads(path.read_text()) for path in (tmp_path / "result.json", tmp_path / "there/result.json"))
    assert saved.pop("scene_text") == there["scene_text"] and saved == hit.json()


def test_json_says_what_it_takes_to_run_again(tmp_path, triplet):
    moved = triplet.replace({"velocity[0]": 2.0})
    mt.simulate(moved, accuracy=1e-7).save(tmp_path / "hit.json")
    saved = json.loads((tmp_path / "hit.json").read_text())
    origin = saved["provenance"]
    assert (origin["scene"], origin["overrides"], origin["scene_sha256"]) == ("<Chain>", moved.overrides, moved.sha256)
    assert saved["scene_text"] == moved.text and origin["run"]["accuracy"] == 1e-7


def test_a_trace_as_csv_has_its_units_and_origin_beside_it(tmp_path, triplet):
    moved = triplet.replace({"chain.velocity[0]": 2.0})
    mt.simulate(moved, accuracy=1e-7).save(tmp_path / "trace.csv")
    about = json.loads((tmp_path / "trace.csv-metadata.json").read_text())
    columns = {column["name"]: column for column in about["tableSchema"]["columns"]}
    assert list(columns)[:2] == ["time", "v1"] and about["url"] == "trace.csv"
    assert (columns["v3"]["schema:unitText"], columns["v3"]["dc:description"]) == ("m/s", "velocity of the ball")
    (origin,) = about["notes"]
    assert origin["scene_sha256"] == moved.sha256 and "chain.velocity[0]=2.0" in origin["overrides"]
    assert json.loads(origin["run"])["accuracy"] == 1e-7 and origin["scene_text"] == moved.text


def test_columns_of_a_body_have_units(tmp_path):
    mt.simulate(mt.load(SCENES / "microsphere.toml")).save(tmp_path / "trace.csv")
    columns = json.loads((tmp_path / "trace.csv-metadata.json").read_text())["tableSchema"]["columns"]
    units = {column["name"]: column.get("schema:unitText") for column in columns}
    assert (units["time"], units["spin1"], units["qw"], units["normal_force1"]) == ("s", "rad/s", None, "N")
    assert [column for column in columns if "dc:description" in column] == []


@pytest.mark.parametrize("name", ["result.xyz", "result", "result.csv.gz"])
def test_an_ending_that_says_nothing_is_refused(name, tmp_path, triplet):
    grid = mt.sweep(triplet, {"velocity[0]": [1]}, columns="time")
    for result, known in ((mt.simulate(triplet), ".json, .csv, .h5 or .hdf5"), (grid, ".csv, .h5 or .hdf5")):
        with pytest.raises(ValueError, match=f"{name}: the name must end in {known}"):
            result.save(tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_hdf5_starts_like_hdf5(tmp_path, triplet):
    hit = mt.simulate(triplet)
    try:
        hit.save(tmp_path / "hit.h5")
        mt.sweep(triplet, {"velocity[0]": [1, 2]}, columns=["time"]).save(tmp_path / "sweep.h5")
    except mt.FileError as error:
        pytest.skip(str(error))
    for name in ("hit.h5", "sweep.h5"):
        assert (tmp_path / name).read_bytes()[:8] == b"\x89HDF\r\n\x1a\n"


@pytest.mark.parametrize("name", ["hit.h5", "hit.HDF5"])
def test_hdf5_says_where_it_comes_from(name, tmp_path, triplet):
    moved = triplet.replace({"chain.velocity[0]": 2.0})
    try:
        mt.simulate(moved, accuracy=1e-7).save(tmp_path / f"run_{name}")
        mt.sweep(moved, {"velocity[1]": [0, -1]}, columns="time").save(tmp_path / f"sweep_{name}")
    except mt.FileError as error:
        pytest.skip(str(error))
    words = ["scene_sha256", moved.sha256, "overrides", "chain.velocity[0]=2.0", "sundials", "compiler", mt.__version__,
             "scene_text", moved.text]
    for kind, more in (("run", ['"accuracy":1e-07']), ("sweep", [])):
        text = (tmp_path / f"{kind}_{name}").read_bytes()
        assert text.startswith(b"\x89HDF") and [word for word in words + more if word.encode() not in text] == []


@pytest.mark.parametrize("scene", ["coin", "microrod", "y_chain"])
def test_hdf5_of_more_than_rows_has_the_columns_of_the_csv(scene, tmp_path):
    h5py = pytest.importorskip("h5py")
    hit = mt.simulate(mt.load(SCENES / f"{scene}.toml"))
    hit.save(tmp_path / "hit.csv")
    hit.save(tmp_path / "hit.h5")
    heads = (tmp_path / "hit.csv").read_text().splitlines()[0].split(",")
    rows = np.loadtxt(tmp_path / "hit.csv", delimiter=",", skiprows=1)
    with h5py.File(tmp_path / "hit.h5") as file:
        assert len(file) == len(heads)
        for head, column in zip(heads, rows.T):
            name, _, unit = head.partition(" [")
            assert file[name].attrs.get("units", "1") == (unit.rstrip("]") or "1")
            assert file[name].dims[0].keys() == ["time"] or name == "time"
            np.testing.assert_array_equal(file[name], column)


def test_a_folder_that_is_not_there_is_a_file_error(tmp_path, triplet):
    with pytest.raises(mt.FileError):
        mt.simulate(triplet).save(tmp_path / "none" / "hit.json")


def test_what_to_cite_names_version_and_scene(triplet):
    text = mt.simulate(triplet).cite()
    assert mt.__version__ in text and triplet.sha256 in text and text.count("@") >= 2


def test_the_package_needs_no_matplotlib():
    import subprocess

    subprocess.run([sys.executable, "-c", "import sys; sys.modules['matplotlib'] = None; import mariotte"], check=True)


@pytest.fixture
def cradle():
    pytest.importorskip("matplotlib")
    return mt.simulate(mt.load(SCENES / "newton_cradle_5.toml"))


def test_forces_are_drawn_per_contact(cradle):
    ax = cradle.plot.forces()
    curves = [line for line in ax.lines if not line.get_label().startswith("_")]
    assert [line.get_label() for line in curves] == [f"$f_{{{j}}}$" for j in range(1, 5)]
    largest = [line.get_ydata().max() for line in curves]
    assert largest == pytest.approx(cradle.peak_force, rel=1e-2)
    assert ax.get_xlabel() == "time t [µs]" and ax.get_title() == "Five steel balls"


def test_colours_of_a_pressed_row_are_those_of_its_forces():
    hit = mt.simulate(mt.load(SCENES / "driven_row.toml"))
    least, most = hit.plot.forces().images[0].get_clim()
    forces = hit.trajectory.force(np.linspace(0, hit.time, 500))
    assert least == pytest.approx(forces.min(), rel=0.01) and most == pytest.approx(forces.max(), rel=0.01)


def test_some_contacts_of_a_long_row_are_curves():
    row = mt.load(SCENES / "struck_row.toml").replace({"chain.balls": 21, "figure.contacts": [1, 20]})
    labels = lambda ax: [line.get_label() for line in ax.lines if not line.get_label().startswith("_")]
    hit = mt.simulate(row)
    assert labels(hit.plot.forces()) == ["$f_{1}$", "$f_{20}$"]
    assert labels(hit.plot.forces(contacts=[4])) == ["$f_{5}$"]
    assert labels(hit.plot.velocities(balls=[0, 12])) == ["ball 1", "ball 13"]
    assert hit.plot.velocities().images
    for refused in (lambda: hit.plot.forces(contacts=[20]), lambda: hit.plot.velocities(balls=[-1])):
        with pytest.raises(IndexError, match="among those of the figure"):
            refused()


def test_long_titles_stay_in_their_figure(cradle):
    title = "Five steel balls that hang from threads on a cold morning in a laboratory far away from here"
    ax = mt.simulate(cradle.scene.replace({"title": title})).plot.forces()
    assert ax.get_title().replace("\n", " ") == title
    ax.figure.canvas.draw()
    box = ax.title.get_window_extent()
    assert box.x0 >= 0 and box.x1 <= ax.figure.bbox.width and box.y1 <= ax.figure.bbox.height


def test_velocities_and_energy_are_drawn(cradle):
    ends = [line.get_ydata()[-1] for line in cradle.plot.velocities().lines[:5]]
    assert ends == pytest.approx(cradle.velocity, abs=1e-9)
    kinetic, stored = cradle.plot.energy().lines[:2]
    assert kinetic.get_ydata()[0] == pytest.approx(1e3 * cradle.energy.initial)  # in mJ
    assert (stored.get_ydata() >= 0).all()


def test_energies_are_not_drawn_of_contacts_that_yield():
    hit = mt.simulate(mt.Chain(mass=[1, 1], velocity=[1, 0], law="walton-braun", loading_stiffness=1e4,
                               unloading_stiffness=2e4))
    with pytest.raises(ValueError, match="yield or adhere"):
        hit.plot.energy()


def test_lines_differ_without_colour(cradle):
    lines = cradle.plot.velocities().lines[:5]
    assert len({line.get_color() for line in lines}) == 5
    assert len({str(line.get_linestyle()) + str(line._unscaled_dash_pattern) for line in lines[:4]}) == 4


def drawn(name):
    pytest.importorskip("matplotlib.pyplot").close("all")
    return mt.simulate(mt.load(SCENES / f"{name}.toml"))


def words(ax):
    return [text.get_text() for text in ax.texts]


def shades(ax):
    return [tuple(one.get_facecolor()) for one in ax.patches if one.get_zorder() < 0]


def test_phases_are_shaded_and_named(cradle):
    ax = cradle.plot.forces()
    assert {"1–4 close", "1 opens", "2 opens", "3 opens"} <= set(words(ax))
    assert len(shades(ax)) == 4 and len(set(shades(ax))) == 3
    assert {"$f_{1}$", "$f_{4}$"} <= set(words(ax))
    assert {"ball 1", "ball 5"} <= set(words(cradle.plot.velocities()))


def test_contacts_of_bodies_close_where_they_are_pressed():
    assert "1–4 close" in words(drawn("cradle_with_friction").plot.velocities())


def test_long_flights_are_left_out():
    rod = drawn("microrod")
    first, second = rod.plot.forces().figure.axes
    assert first.get_xlim()[1] < second.get_xlim()[0]
    assert first.get_ylabel().startswith("force on a tip F") and second.get_xlabel() == "time t [µs]"
    import matplotlib.pyplot as plt

    one = plt.subplots()[1]
    assert rod.plot.forces(one) is one and len(one.figure.axes) == 1


def test_curves_of_a_microbody_say_what_they_are():
    rod = drawn("microrod")
    labels = [line.get_label() for line in rod.plot.forces().lines if not line.get_label().startswith("_")]
    assert sorted(labels) == sorted(f"tip {i} {way}" for i in (1, 2) for way in ("normal", "$e_2$", "$e_3$"))
    assert {"normal", "along $e_2$", "along $e_3$"} <= set(words(rod.plot.velocities().figure.axes[-1]))


def test_balls_of_a_network_have_axes():
    labels = {line.get_label() for line in drawn("y_chain").plot.velocities().lines}
    assert {"ball 1 x", "ball 1 y"} <= labels


def test_many_curves_are_an_image():
    rack = drawn("rack_of_fifteen")
    forces, velocities = rack.plot.forces(), rack.plot.velocities()
    assert forces.images[0].get_array().shape[0] == len(rack.impulse)
    assert forces.images[0].get_array().max() == pytest.approx(rack.peak_force.max(), rel=1e-2)
    assert forces.get_ylim() == (0.5, len(rack.impulse) + 0.5)
    speeds = np.asarray(velocities.images[0].get_array())
    assert speeds.shape[0] == len(rack.velocity) // 2
    assert speeds[:, -1] == pytest.approx(np.hypot(rack.velocity[::2], rack.velocity[1::2]), abs=1e-2)
    assert velocities.figure.axes[1].get_ylabel() == "speed v [m/s]"


def test_a_scene_says_what_its_figures_show():
    pytest.importorskip("matplotlib")
    text = (SCENES / "newton_cradle_5.toml").read_text()
    ax = mt.simulate(mt.parse(text + '\n[figure]\nwindow = ["10 us", "50 us"]\n')).plot.velocities()
    assert ax.get_xlim() == pytest.approx((10, 50))


def test_waves_are_an_image():
    pytest.importorskip("matplotlib")
    row = mt.Chain(balls=60, mass=1, law="hertz", stiffness=1, ball=[{"number": 1, "velocity": 1}])
    hit = mt.simulate(row, until=30)
    image = hit.plot.waves(rows=50).images[0].get_array()
    assert image.shape == (60, 50) and image[0, 0] == 1
    ax = hit.plot.waves()
    assert ax.get_ylim() == (0.5, 60.5) and (ax.get_xlabel(), ax.get_ylabel()) == ("time t [s]", "ball i")
    unit = pytest.importorskip("pint").UnitRegistry()
    assert hit.plot.waves(until=20_000 * unit.ms).get_xlim() == (0, 20)


def test_sweeps_are_curves_or_maps(triplet):
    pytest.importorskip("matplotlib")
    speeds = np.geomspace(0.1, 10, 5)
    curve = mt.sweep(triplet, {"velocity[0]": speeds}, columns=["time"])
    ax = curve.plot("time")
    assert ax.get_xscale() == "log" and ax.lines[0].get_ydata() == pytest.approx(1e6 * curve["time"])
    assert ax.get_xlabel() == "initial velocity v$_{1}^{−}$ [m/s]" and ax.get_ylabel() == "final time t [µs]"
    balls = mt.sweep(triplet, {"velocity[0]": speeds}, columns=["velocity"]).plot("velocity")
    assert [line.get_label() for line in balls.lines] == [f"v$_{{{i}}}$" for i in (1, 2, 3)]
    assert balls.get_ylabel() == "final velocity v$_{i}$ [m/s]"
    both = mt.sweep(triplet, {"velocity[0]": np.geomspace(0.1, 10, 8), "velocity[2]": np.linspace(-1, 0, 9)},
                    columns=["icr[0]", "velocity"])
    assert both.plot("icr[0]").collections[0].get_array().size == 72
    assert both.plot("icr[0]").get_xlabel() == "initial velocity v$_{1}^{−}$ [m/s]"
    assert both.plot("icr[0]").figure.axes[1].get_ylabel() == "impulse correlation ratio α$_{1}$"
    with pytest.raises(ValueError, match="shape"):
        both.plot("velocity")


def test_curves_of_sweeps_have_gaps_where_the_ending_changes():
    sphere = mt.load(SCENES / "microsphere.toml")
    grid = mt.sweep(sphere, {"incidence.normal_speed": [1, 1.2, 2, 3]}, columns=["restitution.tip"])
    drawn = grid.plot("restitution.tip").lines[0].get_ydata()
    assert np.isnan(drawn).tolist() == [False, False, True, False, False]
    one = mt.sweep(sphere, {"incidence.normal_speed": [2]}, columns=["restitution.tip"]).plot("restitution.tip")
    assert one.lines[0].get_marker() == "o"
    with pytest.raises(ValueError, match="balls of a chain"):
        mt.simulate(sphere).plot.waves()


@pytest.mark.parametrize("short_first", [True, False])
def test_sweeps_over_a_short_list_have_a_curve_per_value(triplet, short_first):
    pytest.importorskip("matplotlib")
    short, long = ("velocity[2]", [-1, 0, 0.0005]), ("velocity[0]", np.geomspace(0.1, 10, 9))
    grid = mt.sweep(triplet, dict([short, long] if short_first else [long, short]), columns=["icr[0]"])
    ax = grid.plot("icr[0]")
    rows = grid["icr[0]"] if short_first else grid["icr[0]"].T
    assert [line.get_ydata().tolist() for line in ax.lines] == rows.tolist()
    assert [line.get_label() for line in ax.lines] == ["-1", "0", "0.0005"]
    assert ax.get_legend().get_title().get_text() == "initial velocity v$_{3}^{−}$ [m/s]"
    assert (ax.get_xlabel(), ax.get_xscale()) == ("initial velocity v$_{1}^{−}$ [m/s]", "log")
    assert not ax.collections


def test_slopes_and_names_of_ones_own_are_labelled_as_by_the_command():
    pytest.importorskip("matplotlib")
    scene = mt.Chain(mass=[1, 1, 1], velocity=[1, 0, 0], law="hertz", stiffness=[1, 1])
    slope = "sensitivity.velocity[2].mass[0]"
    columns = [slope, "kappa_1 = icr[0] / 2", "contacts[0].peak_force"]
    grid = mt.sweep(scene, {"gap[1]": [0, 1e-6, 2e-6]}, columns=columns)
    labels = {name: grid.plot(name).get_ylabel() for name in grid}
    assert labels == {slope: "slope ∂v$_{3}$/∂m$_{1}$ [kg$^{-1}$ m s$^{-1}$]", "kappa_1": "κ$_{1}$",
                      "contacts[0].peak_force": "peak force max f$_{1}$ [N]"}
    assert grid.plot(slope).get_xlabel() == "gap g$_{2}$ [µm]"


def test_a_figure_of_forces_says_which_impacts_it_shows():
    row = mt.Chain(mass=[1, 1.3, 0.7, 1.1, 0.9, 1.2], velocity=[1, 0, -0.5, 0.2, 0, -1], law="hertz", stiffness=1e9,
                   gap=[0.1, 0.07, 0.13, 0.05, 0.09])
    assert mt.simulate(row).plot.forces().figure._supxlabel.get_text().endswith(": 3 strongest of 11 impacts")
    shot = mt.simulate(mt.load(SCENES / "draw_shot.toml")).plot.forces()
    assert shot.get_xlabel() == "time t [s]: where forces are strong"
    low, high = shot.get_xlim()
    assert 2 <= sum(low <= tick <= high for tick in shot.get_xticks()) <= 4  # of seven digits each


def test_new_figures_are_as_wide_as_those_of_the_command(cradle, triplet):
    import matplotlib.pyplot as plt

    grid = mt.sweep(triplet, {"velocity[0]": [1, 2]}, columns="time")
    for ax in (cradle.plot.forces(), cradle.plot.waves(rows=9), grid.plot("time")):
        assert 2.54 * ax.figure.get_figwidth() == pytest.approx(8.6) and ax.xaxis.label.get_size() == 7
    given = plt.subplots()[1]
    assert cradle.plot.velocities(given).xaxis.label.get_size() == plt.rcParams["font.size"] != 7


def test_values_that_are_near_have_the_digits_that_tell_them_apart(triplet):
    pytest.importorskip("matplotlib")
    near = mt.sweep(triplet, {"velocity[0]": np.linspace(1, 2, 8), "velocity[2]": [0.5, 0.50001]},
                    columns="time").plot("time")
    assert [line.get_label() for line in near.lines] == ["0.5", "0.50001"]
