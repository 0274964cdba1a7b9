#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages to share in a browser without a window, from a file: they show what develop makes of the same light, with each
response and with other lamps; hostile names are shown and nothing else; lights are compared, saved for develop, and nothing
is requested. Ends with 77 where chromium is missing. With a folder, it leaves pictures of the page there.
  share_page.py PROGRAM [FOLDER]"""
import json
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from chromium import Chromium

SCENE = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.6, 0>
  film { exposure 0.5 response agx contrast 1.1 saturation 0.9 white_balance 5000 vignette 0.3 smooth_edges off
         glare { veil 0.1 halo 0.01 star 0.02 } } }
union { light_source { <-4, 5, -3> rgb <1, 0.7, 0.4> } light_name "</script><img src=x onerror=hacked()> & \\"Top\\"" }
#declare Sign = sphere { <1.6, 0.5, 0>, 0.4 pigment { rgb <1, 0.3, 0.2> } finish { emission 8 ambient 0 diffuse 0 } }
object { Sign }
plane { y, 0 pigment { checker rgb 0.8, rgb 0.25 } finish { ambient 0.02 } }
sphere { <0, 1, 1>, 1 pigment { rgb <0.9, 0.6, 0.3> } finish { ambient 0.02 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.1, 0.12, 0.2>] [1 rgb 0.02] } } }
"""
NAME = '</script><img src=x onerror=hacked()> & "Top"'
KEPT_NAME = "".join("_" if c in '.,="\\' else c for c in NAME)  # in names of layers

OVERLAP = """(() => {
  const boxes = ["header", "#stage", "#panels"].map(each => document.querySelector(each))
    .map(each => [each.id || each.tagName, each.getBoundingClientRect()]);
  return boxes.flatMap(([a, p], i) => boxes.slice(i + 1).filter(([, q]) =>
    p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1).map(([b]) => a + b));
})().join(" ")"""
WIDTH, HEIGHT = 320, 241


def check(what, is_so):
    if not is_so:
        raise SystemExit("not so: " + what)


class Shared:
    def __init__(self, program, folder, browser):
        self.program, self.folder, self.browser = program, folder, browser

    def run(self, *words):
        subprocess.run([self.program, *words], cwd=self.folder, check=True, stderr=subprocess.PIPE)

    def open(self, page):
        self.browser.go(f"file://{self.folder}/{page}")
        self.browser.until("document.readyState === 'complete' && document.body.dataset.ready === 'yes'")

    def shown(self):
        """The bytes of the canvas, without alpha."""
        text = self.browser.run("refresh(1), [...canvas.getContext('2d').getImageData(0, 0, width, height).data]"
                                ".filter((v, i) => i % 4 < 3).map(v => v.toString(16).padStart(2, '0')).join('')")
        return bytes.fromhex(text)

    def developed(self, *words):
        self.run("develop", "x.exr", "-o", "x.ppm", *words)
        return (self.folder / "x.ppm").read_bytes()[-WIDTH * HEIGHT * 3:]

    def agree(self, what, *words):
        ours, theirs = self.shown(), self.developed(*words)
        check(f"{what}: as large", len(ours) == len(theirs))
        off = [abs(a - b) for a, b in zip(ours, theirs)]
        mean, many = sum(off) / len(off), sum(each > 6 for each in off) / len(off)
        print(f"{what}: mean difference {mean:.2f} of 255, more than 6: {100 * many:.2f} %")
        check(f"{what}: as developed", mean < 1.2 and many < 0.02)

    def fits(self, name, shots):
        """Nothing of the page lies over another thing or beside the window, at three widths, in both themes."""
        for width, height, phone in ((1280, 800, False), (768, 1024, False), (390, 844, True)):
            self.browser.size(width, height, phone)
            for theme in ("dark", "light"):
                self.browser.run(f"useTheme('{theme}')")
                time.sleep(0.3)
                check(f"nothing overlaps at {width}", self.browser.run(OVERLAP) == "")
                check(f"no scrolling at {width}", self.browser.run("document.documentElement.scrollWidth <= innerWidth"))
                if shots:
                    self.browser.shot(f"{shots}/{name}_{width}_{theme}.png")


def look(shared, shots):
    browser, run = shared.browser, shared.browser.run
    shared.run("scene.pov", f"+W{WIDTH}", f"+H{HEIGHT}", "--samples", "4", "-V", "--layers", "lights", "+Ox.exr")
    pages = {"agx": [], "filmic": ["--response", "filmic", "--contrast", "1", "--white-balance", "0"],
             "linear": ["--response", "linear", "--exposure", "auto-1", "--glare", "off", "--saturation", "0.5"]}
    for name, words in pages.items():
        shared.run("share", "x.exr", "-o", name, *words)
        shared.open(name + ".html")
        shared.agree(name, *words)
    shared.open("agx.html")
    check("hostile names are shown", run("cards.map(card => card.querySelector('.name').textContent)") ==
          [KEPT_NAME, "Sign", "Other light"])
    check("and nothing else", run("document.images.length") == 0)
    # Other lamps, in the page and by develop with what the page saves.
    run("cards[0].put(0.25)")
    run("cards[1].querySelector('input[type=color]').value = '#4080ff'")
    run("cards[1].querySelector('input[type=color]').dispatchEvent(new Event('input'))")
    saved = run("lampsAsJson(lampsOf(lights[active]))")
    check("the lamps are saved", json.loads(saved)["Sign"] == {"strength": 1, "colour": "#4080ff"})
    (shared.folder / "set.json").write_text(saved)
    shared.agree("relit", "--lights", "set.json")
    run("exposure.querySelector('input').value = 1; exposure.querySelector('input').dispatchEvent(new Event('input'))")
    shared.agree("brighter", "--lights", "set.json", "--exposure", "1.5")
    # Two lights beside each other.
    browser.key("b")
    shared.agree("the other light")
    browser.key("s")
    check("split", run("!divider.hidden && split === 0.5"))
    shown, whole = shared.shown(), shared.developed()
    row = 3 * WIDTH * 100
    right = [abs(a - b) for a, b in zip(shown[row + 3 * 200:row + 3 * WIDTH], whole[row + 3 * 200:row + 3 * WIDTH])]
    left = [abs(a - b) for a, b in zip(shown[row:row + 3 * 120], whole[row:row + 3 * 120])]
    check(f"A left, B right: {sum(left)} {sum(right)}", max(right) < 12 and sum(left) > 4 * len(left))
    box = run("(({left, top}) => [left + 6, top + 60])(divider.getBoundingClientRect())")
    browser.drag([tuple(box), (box[0] + 40, box[1]), (box[0] + 80, box[1])])
    check("the line is dragged", run("split") > 0.52)
    shared.fits("share", shots)
    check("nothing is requested", run("performance.getEntriesByType('resource').length") == 0)
    check("nothing could be", run("fetch('http://localhost:1/').then(() => 'sent', () => 'refused')") == "refused")
    browser.errors = [each for each in browser.errors if "localhost:1" not in str(each)]


SHOW = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 1.2, 0> film { exposure 0.7 response filmic glare { veil 0.1 } vignette 0.2 } }
plane { y, 0 pigment { checker rgb 0.7, rgb 0.3 } finish { ambient 0 diffuse 0.8 } }
box { <-3, 0, 0>, <3, 3, 1> pigment { rgb 0.3 } finish { ambient 0 diffuse 0.7 } }
sphere { <0.5, 0.6, -1.5>, 0.6 pigment { rgb <0.9, 0.6, 0.4> } finish { ambient 0 diffuse 0.8 } }
union {
  #for (I, 0, 399)
    sphere { <-2.85 + 0.3*mod(I, 20), 0.6 + 0.11*int(I/20), -0.05>, 0.035
      pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 6 } }
  #end
  light_name "Front"
}
union { sphere { <-2, 0.4, -2>, 0.2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission <5, 3, 1> } } light_name "</script>Lantern" }
"""
FRAMES = """cue,time,fade
dark,0,0,Front=0
left,0.2,0.2,"Front[0..199]=#ff4020"
all,0.6,0.4,"Front=0.7,#80c0ff"
"""


def look_show(shared, shots):
    """A page that plays a show of hundreds of lamps: frames of it beside those of relight."""
    browser, run = shared.browser, shared.browser.run
    (shared.folder / "show.pov").write_text(SHOW)
    (shared.folder / "show.csv").write_text(FRAMES)
    shared.run("show.pov", f"+W{WIDTH}", f"+H{HEIGHT}", "--samples", "32", "-V", "--keep-lights", "show.lights", "+Oshow.png")
    shared.run("share", "show.lights", "--csv", "show.csv", "--frame-rate", "10", "-o", "show")
    shared.run("relight", "show.lights", "--csv", "show.csv", "--frame-rate", "10", "-o", "show.ppm")
    print(f"page of a show: {(shared.folder / 'show.html').stat().st_size / 1e6:.2f} MB")
    shared.open("show.html")
    check("cards of the names", run("facts.names") == ["Front", "</script>Lantern", "rest"])
    frames = run("show.frames")
    pictures = sorted(shared.folder.glob("show[0-9]*.ppm"))
    check(f"{frames} frames, and {len(pictures)} of relight", frames == len(pictures) > 5)

    def compare(what, path, most):
        ours, theirs = shared.shown(), path.read_bytes()[-WIDTH * HEIGHT * 3:]
        off = [abs(a - b) for a, b in zip(ours, theirs)]
        mean, bright = sum(off) / len(off), sum(theirs) / len(theirs)
        print(f"{what}: mean difference {mean:.2f} of 255, mean {bright:.1f}")
        check(f"{what}: as relit", mean < most)
        return bright

    brightness = [compare(f"frame {i + 1}", pictures[i], 2) for i in range(0, frames, 2) if not run(f"goTo({i}, 1)")]
    check("the show changes the picture", max(brightness) > 2 * min(brightness))
    # Sliders count in all frames.
    run("goTo(show.frames - 1, 1)")
    run("cards[0].put(0.25)")
    shared.run("relight", "show.lights", "--set", "Front=0.175,#80c0ff", "-o", "dim.ppm")
    compare("dimmed", shared.folder / "dim.ppm", 2)
    run("cards[0].put(1)")
    run("goTo(0, 1)")
    browser.key(" ")
    browser.until("frame > 2")
    browser.key(" ")
    check("it stops", run("playing") == 0)
    took = run("(() => { const t = performance.now(); for (let i = 0; i < 5; ++i) goTo(i % show.frames, 1);"
               " return (performance.now() - t) / 5; })()")
    print(f"a frame of {WIDTH}x{HEIGHT} takes {took:.1f} ms")
    run(f"goTo({frames - 4}, 1)")
    shared.fits("show", shots)
    check("nothing is requested", run("performance.getEntriesByType('resource').length") == 0)
    browser.size(1280, 800, False)


def look_served(shared, shots):
    """A show that relight serves: the page is loaded again when its table has changed, and stays when it has a mistake."""
    browser, run = shared.browser, shared.browser.run
    table = shared.folder / "served.csv"
    table.write_text(FRAMES)
    server = subprocess.Popen([shared.program, "relight", "show.lights", "--csv", "served.csv", "--frame-rate", "10",
                               "--preview", "0"], cwd=shared.folder, stderr=subprocess.PIPE, text=True)
    try:
        address = server.stderr.readline().split()[-1]
        ready = "document.readyState === 'complete' && document.body.dataset.ready === 'yes'"
        browser.go(address)
        browser.until(ready)
        frames = run("show.frames")
        run("goTo(3, 1)")
        dark = sum(shared.shown())
        if shots:
            browser.shot(f"{shots}/served.png")
        # Editors replace files by others.
        (shared.folder / "next.csv").write_text(FRAMES.replace("0.4", "1.4").replace("#ff4020", "4,#ff4020"))
        (shared.folder / "next.csv").replace(table)
        browser.until(f"{ready} && facts.watched === 2")
        check("a longer show", run("show.frames") == frames + 10)
        check("the frame stays", run("frame") == 3)
        check("it is brighter", sum(shared.shown()) > 1.1 * dark)
        table.write_text("cue,time,fade\nleft,0,0,Back=1\n")
        check("a mistake is said", "error" in server.stderr.readline())
        table.write_text(FRAMES)
        browser.until(f"{ready} && facts.watched === 3")
        check("the mistake is mended", run("show.frames") == frames)
        browser.go("about:blank")
    finally:
        server.terminate()
    check("it ends", server.wait(20) == 0)


def main():
    if not shutil.which("chromium"):
        print("skipped: chromium is not installed")
        sys.exit(77)
    shots = str(Path(sys.argv[2]).resolve()) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        (folder / "scene.pov").write_text(SCENE)
        browser = Chromium(name + "/profile")
        try:
            shared = Shared(str(Path(sys.argv[1]).resolve()), folder, browser)
            look_show(shared, shots)
            look_served(shared, shots)
            look(shared, shots)
            check(f"no errors of the page: {browser.errors}", not browser.errors)
        finally:
            browser.end()


main()
