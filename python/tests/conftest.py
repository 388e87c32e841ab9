"""What tests share: the command beside the module, and scenes."""

import json
import os
import pathlib
import subprocess

import pytest

import mariotte as mt

ROOT = pathlib.Path(os.environ["MARIOTTE_ROOT"])
SCENES = ROOT / "apps" / "scenes"


def pytest_configure(config):
    """Balls of steel yield at 1 m/s; tests of warnings record them."""
    config.addinivalue_line("filterwarnings", "ignore::mariotte.ModelWarning")


@pytest.fixture
def finished():
    """Runs the command with these arguments, to an exit code; skips where it was not built."""
    program = os.environ.get("MARIOTTE_COMMAND")
    if not program:
        pytest.skip("the command was not built")

    def run(*arguments, code=0):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == code, done.stderr
        return done

    return run


@pytest.fixture
def command(finished):
    """What the command prints, or why it does not."""

    def run(*arguments, code=0):
        done = finished(*arguments, code=code)
        return done.stderr if code else done.stdout

    return run


@pytest.fixture
def command_json(finished):
    return lambda *arguments, code=0: json.loads(finished(*arguments, "--json", code=code).stdout)


@pytest.fixture
def triplet():
    return mt.Chain(balls=3, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0])
