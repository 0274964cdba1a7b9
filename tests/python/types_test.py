# SPDX-License-Identifier: GPL-3.0-or-later
"""The types that the package states hold for itself and for the examples, by mypy."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import candelabra

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"
WRONG = """import candelabra
candelabra.render("a.pov", width="wide")
candelabra.render("a.pov", widht=3)
"""


class Types(unittest.TestCase):
    def mypy(self, *files):
        with tempfile.TemporaryDirectory() as cache:
            package = pathlib.Path(candelabra.__file__).parent
            return subprocess.run([sys.executable, "-m", "mypy", "--cache-dir", cache, "--ignore-missing-imports",
                                   "--enable-incomplete-feature=Unpack", *files],
                                  env={**os.environ, "MYPYPATH": str(package.parent)}, cwd=cache, capture_output=True, text=True)

    def setUp(self):
        if subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode:
            self.skipTest("mypy is not installed")

    def test_the_package_and_its_examples_have_the_types_that_they_state(self):
        told = self.mypy("-p", "candelabra")
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)
        told = self.mypy(*sorted(EXAMPLES.glob("*.py")))
        self.assertEqual(told.returncode, 0, told.stdout + told.stderr)

    def test_wrong_options_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            wrong = pathlib.Path(folder) / "wrong.py"
            wrong.write_text(WRONG)
            told = self.mypy(wrong)
        self.assertEqual(told.stdout.count("error:"), 2, told.stdout)


if __name__ == "__main__":
    unittest.main()
