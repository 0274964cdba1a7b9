#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The price of radiosity: radiosity.py PROGRAM SCENE...

Each scene is rendered at 160x120 by POV-Ray with +A0.1, as a draft, and with 16 samples, which stand for the limit. The table
has the CPU seconds of one thread; the mean step between neighbours, in 255ths of what a display shows, where the limit is
even; and the mean light of both pictures over that of the limit.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from relight import light_in

WIDTH, HEIGHT = 160, 120
EVEN = 0.7 / 255  # the largest step of the limit, which is denoised, in an even place


def linear(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def mean_light(picture):
    return sum(map(linear, picture)) / len(picture)


def steps(picture):
    """Differences of each value to the pixel on its right."""
    row = WIDTH * 3
    return [abs(picture[i] - picture[i + 3]) for i in range(len(picture)) if i % row < row - 3]


def cpu_of(scene, *words):
    before = os.times()
    subprocess.run([*map(str, words), scene.name, f"+W{WIDTH}", f"+H{HEIGHT}", "+FN16", "+WT1"], cwd=scene.parent,
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def main():
    program = Path(sys.argv[1]).resolve()
    print("| scene | POV-Ray | draft | ratio | step of POV-Ray | of the draft | light of POV-Ray | of the draft |")
    print("|---|---|---|---|---|---|---|---|")
    for name in sys.argv[2:]:
        scene = Path(name).resolve()
        with tempfile.TemporaryDirectory() as made:
            theirs = cpu_of(scene, "povray", "-D", "+A0.1", f"+O{made}/theirs.png")
            ours = cpu_of(scene, program, "-V", "-A", "--draft", f"+O{made}/ours.png")
            cpu_of(scene, program, "-V", "-A", "--samples", 16, "--denoise", f"+O{made}/limit.png")
            pov, draft, limit, smooth = (light_in(Path(made) / file) for file in (
                "theirs.png", "ours.draft.png", "limit.png", "limit.denoised.png"))
        even = [i for i, step in enumerate(steps(smooth)) if step < EVEN]
        pov_steps, draft_steps = steps(pov), steps(draft)
        light = mean_light(limit)
        print(f"| {scene.stem} | {theirs:.2f} | {ours:.2f} | {ours / theirs:.1f} | "
              f"{255 * sum(pov_steps[i] for i in even) / len(even):.2f} | "
              f"{255 * sum(draft_steps[i] for i in even) / len(even):.2f} | "
              f"{mean_light(pov) / light:.3f} | {mean_light(draft) / light:.3f} |", flush=True)


if __name__ == "__main__":
    main()
