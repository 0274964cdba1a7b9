# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of the Python module, at tiny sizes."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"
# Words of the command, and what it prints.
RUNS = {"sweep.py": (["2"], "1.60"), "led_table.py": (["32", "leds.png"], "Amber"),
        "contact_sheet.py": (["16", "trees.png"], "8 pictures, 64x32"),
        "show.py": (["32", "3", "."], "3 frames of 12 lamps")}


class Examples(unittest.TestCase):
    def test_each_example_runs(self):
        self.assertEqual({file.name for file in FOLDER.glob("*.py")}, set(RUNS))
        for name, (words, told) in RUNS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                made = subprocess.run([sys.executable, "-W", "error", FOLDER / name, *words], cwd=folder,
                                      capture_output=True, text=True)
                self.assertEqual(made.returncode, 0, made.stderr)
                self.assertIn(told, made.stdout)
                pictures = [file for file in os.listdir(folder) if file.endswith(".png")]
                self.assertEqual(len(pictures), {"sweep.py": 0, "show.py": 3}.get(name, 1))


if __name__ == "__main__":
    unittest.main()
