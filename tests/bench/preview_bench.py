#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long the preview lets one wait, for each scene of examples/lights at 640x480: until the first picture after the
start of the program, after a slider and after the camera has been moved, while a slider is dragged without rest, and
when a layer, a lamp or the exposure is chosen while the picture is being rendered. Milliseconds, of a clock and, behind
the first three, of processors: on a machine that does other things the latter tell what the former would be.
  preview_bench.py PROGRAM [SCENE ...]"""
import http.client
import json
import os
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
REPEATS = 7


class Preview:
    def __init__(self, program, scene, folder):
        self.begun = time.monotonic()
        self.run = subprocess.Popen([program, scene, "+W640", "+H480", "--samples", "1000", "--preview", "0",
                                     f"+L{folder}"], stderr=subprocess.PIPE, text=True, cwd=folder)
        said = ""
        while "preview: " not in said:
            said = self.run.stderr.readline()
        self.port = int(re.search(r":(\d+)/", said).group(1))
        self.token = re.search('content="([0-9a-f]{32})"', self.get("/").decode()).group(1)

    def get(self, path):
        connection = http.client.HTTPConnection("localhost", self.port, timeout=20)
        connection.request("GET", path)
        answer = connection.getresponse()
        bytes_ = answer.read()
        return bytes_ if answer.status == 200 else b""

    def post(self, path, form):
        connection = http.client.HTTPConnection("localhost", self.port, timeout=20)
        connection.request("POST", path, form, {"X-Token": self.token})
        connection.getresponse().read()

    def status(self, since=-1):
        return json.loads(self.get(f"/status?since={since}"))

    def cpu(self):
        """Seconds of processors up to now."""
        fields = Path(f"/proc/{self.run.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def until(self, test):
        """Seconds until the status is so and the picture is there, asked as the page does."""
        begun, version = time.monotonic(), -1
        while True:
            status = self.status(version)
            version = status["version"]
            if test(status):
                while not self.get("/picture"):
                    pass
                return time.monotonic() - begun
            if time.monotonic() - begun > 20:
                return float("inf")

    def end(self):
        self.run.terminate()
        self.run.wait(30)


def median_of(times):
    return 1000 * statistics.median(times)


def measure(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        wrapped = Path(folder) / "scene.pov"
        wrapped.write_text("#ifndef (Turn) #declare Turn = 0; #end  // 0 to 90 by 1: nothing\n"
                           f'#include "{scene.name}"\n')
        preview = Preview(program, str(wrapped), str(scene.parent))
        preview.until(lambda status: status["width"] > 0)
        row = [1000 * (time.monotonic() - preview.begun), 1000 * preview.cpu()]
        turned, moved, views, lamps, films = [], [], [], [], []
        turned_cpu, moved_cpu = [], []
        for i in range(REPEATS):
            preview.until(lambda status: status["samples"] > 0)
            before = preview.status()["generation"]
            cpu = preview.cpu()
            preview.post("/turn", f"name=Turn&value={i + 1}")
            turned.append(preview.until(lambda status: status["generation"] > before))
            turned_cpu.append(preview.cpu() - cpu)
        for i in range(REPEATS):
            preview.until(lambda status: status["samples"] > 0)
            before = preview.status()["generation"]
            cpu = preview.cpu()
            preview.post("/orbit", "by=turn&right=2&up=0")
            moved.append(preview.until(lambda status: status["generation"] > before))
            moved_cpu.append(preview.cpu() - cpu)
        # A hand that never rests: a move each 16 ms, for two seconds.
        preview.until(lambda status: status["samples"] > 0)
        first, begun = preview.status()["generation"], time.monotonic()
        while time.monotonic() - begun < 2:
            preview.post("/turn", f"name=Turn&value={int((time.monotonic() - begun) * 40)}")
            time.sleep(0.016)
        pictures = preview.status()["generation"] - first
        preview.until(lambda status: status["samples"] > 0)
        for name in ["albedo", "samples", "normal", "picture", "depth", "object", "picture"]:
            time.sleep(0.3)
            begun = time.monotonic()
            preview.post("/look", f"view={name}")
            preview.until(lambda status: status["shown_view"] == name)
            views.append(time.monotonic() - begun)
        has_lamps = preview.status()["lit_apart"]
        for i in range(REPEATS):
            for path, form, times in (("/dim", f"lamp=0&strength={0.5 + 0.1 * i}&red=1&green=1&blue=1", lamps),
                                      ("/develop", f"name=exposure&value={0.1 * i}", films)):
                time.sleep(0.2)
                before, begun = preview.status()["picture"], time.monotonic()
                preview.post(path, form)
                preview.until(lambda status: status["picture"] > before)
                times.append(time.monotonic() - begun)
        preview.end()
        return row + [median_of(turned), median_of(turned_cpu), median_of(moved), median_of(moved_cpu), 2000 / max(pictures, 1), median_of(views),
                      1000 * max(views), median_of(lamps) if has_lamps else float("nan"), median_of(films)]


def main():
    program = str(Path(sys.argv[1]).resolve())
    scenes = [Path(each).resolve() for each in sys.argv[2:]] or sorted((ROOT / "examples/lights").glob("*.pov"))
    print("| scene | from the start | CPU | slider | CPU | camera | CPU | between pictures of a drag | layer | slowest layer | lamp | "
          "exposure |\n" + "|---" * 12 + "|")
    for scene in scenes:
        print(f"| {scene.stem} | " + " | ".join(f"{value:.0f}" for value in measure(program, scene)) + " |", flush=True)


main()
