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
    assert json.loads((tmp_path / "result.json").read_text()) == hit.json()


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
    words = ["scene_sha256", moved.sha256, "overrides", "chain.velocity[0]=2.0", "sundials", "compiler", mt.__version__]
    for kind, more in (("run", ['"accuracy":1e-07']), ("sweep", [])):
        text = (tmp_path / f"{kind}_{name}").read_bytes()
        assert text.startswith(b"\x89HDF") and [word for word in words + more if word.encode() not in text] == []


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
    assert [line.get_label() for line in curves] == [f"contact {j}" for j in range(4)]
    largest = [line.get_ydata().max() for line in curves]
    assert largest == pytest.approx(cradle.peak_force, rel=1e-2)
    assert ax.get_xlabel() == "time t [µs]" and ax.get_title() == "Five steel balls"


def test_velocities_and_energy_are_drawn(cradle):
    ends = [line.get_ydata()[-1] for line in cradle.plot.velocities().lines[:5]]
    assert ends == pytest.approx(cradle.velocity, abs=1e-9)
    kinetic, stored = cradle.plot.energy().lines[:2]
    assert kinetic.get_ydata()[0] == pytest.approx(1e3 * cradle.energy.initial)  # in mJ
    assert (stored.get_ydata() >= 0).all()


def test_lines_differ_without_colour(cradle):
    lines = cradle.plot.velocities().lines[:5]
    assert len({line.get_color() for line in lines}) == 5
    assert len({str(line.get_linestyle()) + str(line._unscaled_dash_pattern) for line in lines[:4]}) == 4


def test_waves_are_an_image():
    pytest.importorskip("matplotlib")
    row = mt.Chain(balls=60, mass=1, law="hertz", stiffness=1, ball=[{"number": 1, "velocity": 1}])
    hit = mt.simulate(row, until=30)
    image = hit.plot.waves(rows=50).images[0].get_array()
    assert image.shape == (50, 60) and image[0, 0] == 1


def test_sweeps_are_curves_or_maps(triplet):
    pytest.importorskip("matplotlib")
    speeds = np.geomspace(0.1, 10, 5)
    curve = mt.sweep(triplet, {"velocity[0]": speeds}, columns=["time"])
    ax = curve.plot("time")
    assert ax.get_xscale() == "log" and ax.lines[0].get_ydata().tolist() == curve["time"].tolist()
    assert ax.get_xlabel() == "chain.velocity[0] [m/s]" and ax.get_ylabel() == "final.time  t [s]"
    balls = mt.sweep(triplet, {"velocity[0]": speeds}, columns=["velocity"]).plot("velocity")
    assert [line.get_label() for line in balls.lines] == [f"final.velocity[{i}]" for i in range(3)]
    both = mt.sweep(triplet, {"velocity[0]": speeds, "velocity[2]": [-1, 0, 0.05]}, columns=["icr[0]", "velocity"])
    assert both.plot("icr[0]").collections[0].get_array().size == 15
    assert both.plot("icr[0]").get_ylabel() == "chain.velocity[0] [m/s]"
    with pytest.raises(ValueError, match="shape"):
        both.plot("velocity")
