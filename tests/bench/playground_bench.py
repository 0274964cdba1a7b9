#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long a newcomer with a browser waits for the playground, behind a server of this machine and as one file: from opening the
page to the first picture of examples/lights/ring.pov and to the first of its whole size, and from opening it to the first
picture of an own scene of 100 lamps, which is typed at a rate of eight keys per second. Each opening has a new profile, so
nothing has been kept from before. Seconds, of a clock and, behind, of processors (all processes of the browser, from the
opening on).
  playground_bench.py BUILD [TIMES]    BUILD: that of src/packaging/wasm/build.sh, with the playground made"""
import statistics
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/production"))
from chromium import Chromium  # noqa: E402
from playground import serve  # noqa: E402

KEYS_PER_SECOND = 8
OWN = """#include "light_arrays.inc"
camera { location <0, 3, -8> look_at <0, 1, 0> }
plane { y, 0 pigment { rgb 0.7 } }
sphere { <0, 1, 0>, 1 pigment { rgb 0.8 } }
#declare Lamp = sphere { 0, 0.06 finish { emission 8 } }
object { Light_Ring(Lamp, 100, 2.5) translate 0.5*y }
"""
# Notes when the picture is drawn, and at which passes.
WATCH = """window.drawn = [];
new MutationObserver(() => drawn.push([performance.now() / 1000, Number(document.body.dataset.passes)]))
  .observe(document, { subtree: true, attributeFilter: ["data-drawn"] });"""


class Opened:
    """A page in a browser of its own."""

    def __init__(self, address):
        self.place = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.browser = Chromium(self.place.name + "/profile")
        self.browser.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        time.sleep(1.5)  # the browser itself has started
        self.before = self.browser.cpu()
        self.browser.go(address)

    def picture(self, number):
        """Seconds from opening to the picture of this number, from 0, of the clock and of processors."""
        self.browser.until(f"window.drawn && drawn.length > {number}", 120)
        return self.browser.run(f"drawn[{number}][0]"), self.browser.cpu() - self.before

    def end(self):
        self.browser.end()
        self.place.cleanup()


def first_pictures(address):
    page = Opened(address)
    try:
        return page.picture(0), page.picture(1)
    finally:
        page.end()


def own_scene(address):
    """Seconds until the first picture of the own scene after the opening and after the last key, and those of processors."""
    page = Opened(address)
    try:
        page.picture(0)
        page.browser.run("(() => { const area = document.getElementById('text'); area.focus(); area.select(); })()")
        begun = time.monotonic()
        for i, letter in enumerate(OWN):
            time.sleep(max(0, begun + i / KEYS_PER_SECOND - time.monotonic()))
            page.browser.call("Input.insertText", text=letter)
        assert page.browser.run("document.getElementById('text').value") == OWN
        last = page.browser.run("performance.now() / 1000")
        # The draft of the new text, not a pass of the scene before, which goes on for 0.4 s.
        draft = "drawn.find(([at, passes]) => at > %f && passes === 0)" % last
        at = page.browser.until(f"window.drawn && {draft}", 60)[0]
        return at, at - last, page.browser.cpu() - page.before
    finally:
        page.end()


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build, times = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 5
    example = "#example=A%20ring%20of%20lamps"
    ways = {"folder": serve(build / "playground"), "one file": f"file://{build / 'playground.html'}"}
    for way, address in ways.items():
        runs = [first_pictures(address + example) for _ in range(times)]
        for name, each in zip(("first picture", "whole size"), zip(*runs)):
            clock, cpu = (statistics.median(values) for values in zip(*each))
            print(f"{way}, {name}: {clock:.2f} s, {cpu:.2f} s of processors")
    whole, after, cpu = own_scene(ways["folder"])
    print(f"an own scene of 100 lamps, {len(OWN)} keys: {whole:.1f} s, of which {after:.1f} s after the last key; "
          f"{cpu:.1f} s of processors")


if __name__ == "__main__":
    main()
