# SPDX-License-Identifier: GPL-3.0-or-later
"""What the module of Python costs over the command: the least CPU time of several runs of each.

    PYTHONPATH=build/python python3 tests/bench/python.py build/candelabra [RUNS]
"""

import os
import pathlib
import subprocess
import sys
import tempfile


def spent():
    """CPU time of this process and of those that it has waited for, in milliseconds."""
    times = os.times()
    return 1000 * (times.user + times.system + times.children_user + times.children_system)


begun = spent()
import candelabra

imported = spent() - begun

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
plane { y, -1 pigment { rgb 0.7 } }
#for (I, 0, 99) sphere { <mod(I, 10) - 4.5, 0.1, div(I, 10)>, 0.1 pigment { rgb 1 } finish { emission 5 } } #end
"""


def least(work, runs):
    times = []
    for _ in range(runs):
        start = spent()
        work()
        times.append(spent() - start)
    return min(times)


program, runs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 7
print(f"import candelabra: {imported:.0f} ms, NumPy included")
with tempfile.TemporaryDirectory() as folder:
    scene = str(pathlib.Path(folder) / "a.pov")
    pathlib.Path(scene).write_text(SCENE)
    for width, height, samples in ((16, 12, 1), (640, 480, 1), (640, 480, 4)):
        words = [program, scene, f"+W{width}", f"+H{height}", "--samples", str(samples), "-V", "-o", f"{folder}/a.png"]
        command = least(lambda: subprocess.run(words, check=True), runs)
        module = least(lambda: candelabra.render(scene, width=width, height=height, samples=samples), runs)
        print(f"{width}x{height}, {samples} samples: command {command:.0f} ms, render() {module:.0f} ms, "
              f"{module - command:+.0f} ms")
