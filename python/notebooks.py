"""Renders the scripts of doc/python to HTML, with what they show: python3 python/notebooks.py FOLDER.

Needs jupyter-nbconvert and python3-ipykernel, and the module where Python finds it.
"""

import os
import pathlib
import re
import sys

import nbconvert
import nbformat
from nbconvert.preprocessors import ExecutePreprocessor

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent / "doc" / "python"


def notebook(text):
    """The cells of a script in the percent format."""
    made = nbformat.v4.new_notebook()
    for kind, body in re.findall(r"^# %%( \[markdown\])?\n(.*?)(?=^# %%|\Z)", text, re.DOTALL | re.MULTILINE):
        if kind:
            made.cells.append(nbformat.v4.new_markdown_cell(re.sub("^# ?", "", body, flags=re.MULTILINE).strip()))
        else:
            made.cells.append(nbformat.v4.new_code_cell(body.strip()))
    return made


def page(cells, name):
    """HTML that needs no other file: scripts from elsewhere draw formulas and widgets, and there are none."""
    html = nbconvert.HTMLExporter().from_notebook_node(cells, {"metadata": {"name": name}})[0]
    return re.sub(r'<script[^>]*\ssrc="[^"]*"[^>]*>\s*</script>', "", html)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"
    for script in sorted(SCRIPTS.glob("*.py")):
        cells = notebook(script.read_text())
        ExecutePreprocessor(timeout=600, kernel_name="python3").preprocess(cells)
        file = folder / f"{script.stem}.html"
        file.write_text(page(cells, cells.cells[0].source.splitlines()[0].lstrip("# ")))
        print(file)


main(pathlib.Path(sys.argv[1]))
