"""Lets pip build the compiled part by CMake: pip install --no-build-isolation ."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(mariotte VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildByCMake(build_ext):
    """Builds the target mariotte_python, and puts the module where setuptools wants it."""

    def build_extension(self, extension):
        folder = pathlib.Path(self.build_temp).resolve()
        options = ("APPS", "TESTS", "INSTALL")
        subprocess.check_call(["cmake", "-S", ROOT, "-B", folder, f"-DPython_EXECUTABLE={sys.executable}",
                               "-DCMAKE_BUILD_TYPE=Release", "-DMARIOTTE_PYTHON=ON",
                               *(f"-DMARIOTTE_{option}=OFF" for option in options)])
        subprocess.check_call(["cmake", "--build", folder, "--parallel", str(os.cpu_count() or 1), "--target", "mariotte_python"])
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(next((folder / "python" / "mariotte").glob("_core.*.so")), target)


setup(version=VERSION, ext_modules=[Extension("mariotte._core", [])], cmdclass={"build_ext": BuildByCMake},
      options={"build": {"build_base": "build-pip"}})
