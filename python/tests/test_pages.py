"""The scripts of the documentation become pages that show their figures and need no network."""

import os
import re
import subprocess
import sys

import pytest

from conftest import ROOT

for needed in ("nbconvert", "ipykernel", "matplotlib"):
    pytest.importorskip(needed)

FIGURES = {"capture_and_fit": 1, "correlation_ratio_map": 1, "granular_wave": 1, "impact_laws": 0, "newtons_cradle": 3}


def test_every_script_is_a_page_with_its_figures(tmp_path):
    made = subprocess.run([sys.executable, ROOT / "python" / "notebooks.py", tmp_path], capture_output=True, text=True,
                          env={**os.environ, "HOME": str(tmp_path), "JUPYTER_RUNTIME_DIR": str(tmp_path / "jupyter")})
    assert made.returncode == 0, made.stderr
    assert sorted(file.stem for file in tmp_path.glob("*.html")) == sorted(FIGURES)
    for name, figures in FIGURES.items():
        page = (tmp_path / f"{name}.html").read_text()
        assert page.count('src="data:image/png;base64,') == figures, name
        assert not re.search(r'<(script|link|img)[^>]*(src|href)="(?!data:)', page), name
        assert f"<title>{(ROOT / 'doc' / 'python' / name).with_suffix('.py').read_text().splitlines()[1][4:]}" in page
