"""What tests share: the command beside the module, and scenes."""

import json
import os
import pathlib
import subprocess

import pytest

import mariotte as mt

ROOT = pathlib.Path(os.environ["MARIOTTE_ROOT"])
SCENES = ROOT / "apps" / "scenes"


@pytest.fixture
def command():
    """Runs the command with these arguments; skips where it was not built."""
    program = os.environ.get("MARIOTTE_COMMAND")
    if not program:
        pytest.skip("the command was not built")

    def run(*arguments, code=0):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == code, done.stderr
        return done.stderr if code else done.stdout

    return run


@pytest.fixture
def command_json(command):
    return lambda *arguments: json.loads(command(*arguments, "--json"))


@pytest.fixture
def triplet():
    return mt.Chain(balls=3, radius="10 mm", material="steel", law="hertz", velocity=[1, 0, 0])
