# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel of `pip install .`: with nothing else of the program, it renders with the library and with pictures."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = """
import candelabra, os, sys
assert candelabra.__file__.startswith(sys.argv[1]), candelabra.__file__
picture = candelabra.render_text('#include "colors.inc" camera {} background { Red }', width=4, height=4)
assert picture.pixels[0, 0].tolist() == [255, 0, 0]
picture.save(os.path.join(sys.argv[1], "a.webp"))
"""


class Wheel(unittest.TestCase):
    def test_a_wheel_is_complete(self):
        if subprocess.run([sys.executable, "-m", "pip", "--version"], capture_output=True).returncode:
            self.skipTest("pip is not installed")
        with tempfile.TemporaryDirectory() as folder:
            pip = [sys.executable, "-m", "pip", "install", "--no-deps", "--no-index", "--target", folder, str(ROOT)]
            made = subprocess.run(pip, capture_output=True, text=True)
            self.assertEqual(made.returncode, 0, made.stderr)
            own = {name: value for name, value in os.environ.items() if not name.startswith("CANDELABRA")}
            ran = subprocess.run([sys.executable, "-c", SCENE, folder], env={**own, "PYTHONPATH": folder}, cwd="/",
                                 capture_output=True, text=True)
            self.assertEqual(ran.returncode, 0, ran.stderr)


if __name__ == "__main__":
    unittest.main()
