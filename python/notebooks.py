"""Renders the scripts of doc/python to HTML, with what they show: python3 python/notebooks.py FOLDER.

Needs jupyter-nbconvert and python3-ipykernel, and the module where Python finds it.
"""

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


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for script in sorted(SCRIPTS.glob("*.py")):
        cells = notebook(script.read_text())
        cells.cells.insert(0, nbformat.v4.new_code_cell("%matplotlib inline", metadata={"tags": ["hidden"]}))
        ExecutePreprocessor(timeout=600, kernel_name="python3").preprocess(cells)
        del cells.cells[0]
        page = folder / f"{script.stem}.html"
        page.write_text(nbconvert.HTMLExporter().from_notebook_node(cells)[0])
        print(page)


main(pathlib.Path(sys.argv[1]))
