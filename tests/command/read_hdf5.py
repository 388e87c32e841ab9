"""Reads a trace and a sweep that the command wrote, with every reader of HDF5 that is installed.

read_hdf5.py COMMAND SCENES: exit code 77 where there is none.
"""
import importlib
import pathlib
import subprocess
import sys
import tempfile


def words(values):
    return [one.decode() if isinstance(one, bytes) else str(one) for one in values]


def by_h5py(h5py, trace, sweep):
    with h5py.File(trace) as file:
        yield file["velocity"][0].tolist(), file["velocity"].attrs["units"]
    with h5py.File(sweep) as file:
        yield file["final.velocity[0]"][:].tolist(), words(file["ending"][:]), words(file["chain.wall"][:])


def by_netcdf4(netcdf4, trace, sweep):
    with netcdf4.Dataset(trace) as file:
        yield file["velocity"][0].tolist(), file["velocity"].units
    with netcdf4.Dataset(sweep) as file:
        yield file["final.velocity[0]"][:].tolist(), words(file["ending"][:]), words(file["chain.wall"][:])


def by_xarray(xarray, trace, sweep):
    with xarray.open_dataset(trace, engine="netcdf4") as data:
        yield data["velocity"].values[0].tolist(), data["velocity"].attrs["units"]
    with xarray.open_dataset(sweep, engine="netcdf4") as data:
        yield (data["final.velocity[0]"].values.tolist(), words(data["ending"].values),
               words(data["chain.wall"].values))


READERS = {"h5py": (by_h5py, ["h5py"]), "netCDF4": (by_netcdf4, ["netCDF4"]),
           "xarray": (by_xarray, ["xarray", "netCDF4"])}

SCENE = """[chain]
balls = 2
mass = 1
velocity = [1, 0]
law = "linear"
stiffness = 1
gap = 0.1
wall = "right"
[run]
max_time = 20
[[sweep]]
key = "chain.wall"
values = ["left", "right"]
"""


def has(modules):
    try:
        return all(importlib.import_module(one) for one in modules)
    except ImportError:
        return False


def main(command, folder):
    scene = folder / "scene.toml"
    scene.write_text(SCENE)
    run = lambda *words: subprocess.run([command, *words], cwd=folder, check=True)
    run("run", "scene.toml", "--trace", "trace.h5", "--every", "1", "-q")
    run("sweep", "scene.toml", "--out", "out", "--hdf5", "--no-figures", "--column", "final.velocity[0]", "-q")
    found = [name for name, (_, modules) in READERS.items() if has(modules)]
    for name in found:
        read, modules = READERS[name]
        (first, units), (velocities, endings, walls) = read(
            importlib.import_module(modules[0]), folder / "trace.h5", folder / "out" / "sweep.h5")
        assert first == [1, 0, 0] and units == "m/s", (name, first, units)
        assert len(velocities) == 2 and endings == ["separated", "separated"], (name, velocities, endings)
        assert walls == ["left", "right"], (name, walls)
        print(name, "reads both files")
    if not found:
        print("skipped: none of", ", ".join(READERS), "is installed")
    return 0 if found else 77


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        sys.exit(main(sys.argv[1], pathlib.Path(place)))
