# SPDX-License-Identifier: GPL-3.0-or-later
"""The example notebooks run, and pictures in them show themselves."""

import pathlib
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "examples" / "python"


class Notebooks(unittest.TestCase):
    def test_each_notebook_runs(self):
        try:
            import ipykernel  # noqa: F401
            import nbclient
            import nbformat
        except ImportError as missing:
            self.skipTest(f"{missing.name} is not installed")
        notebooks = sorted(FOLDER.glob("*.ipynb"))
        self.assertTrue(notebooks)
        for path in notebooks:
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder:
                notebook = nbformat.read(path, as_version=4)
                nbformat.validate(notebook)
                for cell in notebook.cells:
                    self.assertFalse(cell.get("outputs"), "notebooks are kept without what they printed")
                nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3",
                                        resources={"metadata": {"path": folder}}).execute()
                outputs = [out for cell in notebook.cells for out in cell.get("outputs", [])]
                self.assertTrue(any("image/png" in out.get("data", {}) for out in outputs))
                self.assertFalse([out for out in outputs if out.output_type == "error" or out.get("name") == "stderr"])


if __name__ == "__main__":
    unittest.main()
