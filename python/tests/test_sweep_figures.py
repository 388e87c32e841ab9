"""Figures of sweeps in memory."""

import numpy as np
import pytest

import mariotte as mt
from conftest import SCENES

plt = pytest.importorskip("matplotlib.pyplot")
ROW = {"mass": [1, 2, 1], "velocity": [1, 0, 0], "law": "hertz", "stiffness": 1e9}


@pytest.fixture(autouse=True)
def close_figures():
    yield
    plt.close("all")


@pytest.fixture
def sphere():
    return mt.Body(shape="sphere", radius="2.45 um", density="1350 kg/m^3", incidence={"normal_speed": "5 m/s"},
                   surface={"stiffness": "1.74 GPa", "work_of_adhesion": "0.38 J/m^2", "zeta_hertz": 1,
                            "zeta_adhesion": 1})


def lines_of(ax):
    return {line.get_label(): line for line in ax.lines}


def test_a_map_stands_in_order_whatever_the_order_of_the_values():
    second, first = [5, 0.1, 3, 0.5, 2, 1, 4, 6, 8], [3, 1, 2, 9, 8, 7, 5, 6]
    grid = mt.sweep(mt.Chain(**ROW), {"mass[1]": second, "mass[0]": first}, columns="velocity[2]")
    mesh = grid.plot("velocity[2]").collections[0]
    drawn = mesh.get_array().reshape(len(first), len(second))
    assert np.array_equal(drawn, grid["velocity[2]"][np.argsort(second)][:, np.argsort(first)].T)
    corners = mesh.get_coordinates()
    assert (np.diff(corners[:, :, 0], axis=1) > 0).all() and (np.diff(corners[:, :, 1], axis=0) > 0).all()


def test_a_curve_goes_from_small_to_large():
    grid = mt.sweep(mt.Chain(**ROW), {"mass[1]": [3, 1, 2]}, columns="velocity[2]")
    (line,) = grid.plot().lines
    assert line.get_xdata().tolist() == [1, 2, 3]
    assert line.get_ydata().tolist() == grid["velocity[2]"][[1, 2, 0]].tolist()


def test_keys_that_go_to_and_fro_together_are_points():
    grid = mt.sweep(mt.Chain(**ROW), {("mass[1]", "mass[0]"): ([3, 1, 2], [1, 2, 3])}, columns="velocity[2]")
    (line,) = grid.plot().lines
    assert line.get_linestyle() == "None" and line.get_marker() == "o"


def test_words_name_curves_or_stand_along_an_axis():
    words = {"law": ["hertz", "linear"]}
    grid = mt.sweep(mt.Chain(**ROW), {**words, "mass[1]": np.linspace(0.1, 5, 9)}, columns="velocity[2]")
    assert grid.axes["chain.law"].tolist() == ["hertz", "linear"]
    curves = lines_of(grid.plot())
    assert curves["linear"].get_ydata().tolist() == grid["velocity[2]"][1].tolist()
    ax = mt.sweep(mt.Chain(**ROW), words, columns="velocity").plot("velocity")
    assert [text.get_text() for text in ax.get_xticklabels()] == ["hertz", "linear"] and len(ax.lines) == 3


def test_a_point_between_two_gaps_is_a_dot(sphere):
    grid = mt.sweep(sphere, {"incidence.normal_speed": [5, 1, 9]}, columns="restitution.tip")
    assert grid.ending[1] == mt.Ending.captured
    (line,) = grid.plot().lines
    assert line.get_marker() == "o" and line.get_xdata()[line.get_markevery()].tolist() == [1]


def test_angles_are_in_degrees():
    rod = mt.load(SCENES / "microrod.toml")
    grid = mt.sweep(rod, {"incidence.angles[1]": np.radians([20, 30, 40])}, columns="restitution.tip")
    ax = grid.plot()
    assert ax.get_xlabel().endswith("[deg]") and ax.lines[0].get_xdata().round(9).tolist() == [20, 30, 40]


def test_a_column_has_to_be_named_where_there_are_several(triplet):
    grid = mt.sweep(triplet, {"velocity[0]": [1, 2]}, columns="velocity")
    with pytest.raises(ValueError, match="which column"):
        grid.plot()


def test_arrays_choose_curves(triplet):
    hit = mt.simulate(triplet)
    assert len(hit.plot.velocities(balls=np.arange(2)).lines) >= 2
    assert len(hit.plot.forces(contacts=np.array([0])).lines) >= 1
