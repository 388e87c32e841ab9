"""The Python of the pages runs, block after block."""

import importlib.util
import re
import shutil

import numpy as np
import pytest

from conftest import ROOT, SCENES


def blocks(page):
    return re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("page", ["README.md", "doc/python.md"])
def test_the_blocks_of_a_page_run(page, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    shutil.copy(SCENES / "sphere_fit.toml", "microsphere.toml")
    shutil.copy(SCENES / "sphere_fit.csv", "measured.csv")
    for name in ("steel_pair.toml", "pressed_row.toml"):
        shutil.copy(SCENES / name, name)
    random = np.random.default_rng(1)
    names = {"stiffness": random.uniform(1, 2, (100, 2)), "velocity": random.normal(size=(100, 3))}
    found = blocks(page)
    assert found
    for block in found:
        if "numba" in block and not importlib.util.find_spec("numba"):
            continue
        exec(compile(block, page, "exec"), names)
    assert names["hit"].ending == names["mt"].Ending.separated
