"""Under valgrind: the module reads and writes nothing that is not its own, and loses nothing."""

import ctypes
import os
import re
import shutil
import subprocess
import sys

import pytest

import mariotte
from test_leaks import USE


@pytest.mark.skipif(not shutil.which("valgrind"), reason="valgrind is not there")
@pytest.mark.skipif(hasattr(ctypes.CDLL(None), "__asan_init"), reason="built with another memory checker")
def test_valgrind_finds_nothing_in_the_module(tmp_path):
    log = tmp_path / "log"
    done = subprocess.run(["valgrind", "--leak-check=full", "--show-leak-kinds=definite", "--num-callers=40",
                           "--error-limit=no", f"--log-file={log}", sys.executable, "-c", USE + "use()\nprint('used')"],
                          capture_output=True, text=True, env={**os.environ, "PYTHONMALLOC": "malloc"})
    assert done.stdout == "used\n", done.stderr
    text = log.read_text()
    assert "ERROR SUMMARY" in text
    blocks = re.split(r"\n==\d+== \n", text)  # the interpreter and the dynamic linker have some of their own
    assert [block for block in blocks if os.path.basename(mariotte._core.__file__) in block] == []
