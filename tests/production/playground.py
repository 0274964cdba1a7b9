#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The playground in a browser without a window, as a folder behind a server and as one file: it shows the samples that the
native program makes, byte for byte, and saves the same OpenEXR file; mistakes are shown where they are; completion and help
come; lamps, film, a pixel and frames; an address holds a scene; nothing overlaps at three widths; nothing is requested but
its own files.
  playground.py BUILD PROGRAM [FOLDER]    BUILD: that of src/packaging/wasm/build.sh, with the playground made;
                                          FOLDER: gets pictures of the page
  playground.py BUILD --picture FILE      makes the picture of README.md, examples/pictures/playground.webp"""
import functools
import http.server
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from urllib.parse import quote

from chromium import Chromium

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = dict(line.rsplit(": ", 1) for line in (ROOT / "src/playground/examples.txt").read_text().splitlines())
SIZE = (96, 72)
OVERLAP = """(() => {
  const boxes = ["header", "#writing", "#stage", "#panels", "footer"].map(each => document.querySelector(each))
    .map(each => [each.id || each.tagName, each.getBoundingClientRect()]);
  const crossing = boxes.flatMap(([a, p], i) => boxes.slice(i + 1).filter(([, q]) =>
    p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1).map(([b]) => a + b));
  const wide = document.documentElement.scrollWidth > innerWidth ? ["wider than the window"] : [];
  const picture = document.getElementById("picture"), shown = picture.getBoundingClientRect();
  const around = document.getElementById("stage").getBoundingClientRect();
  const whole = shown.left >= around.left && shown.right <= around.right && shown.top >= around.top &&
    shown.bottom <= around.bottom && Math.abs(shown.width * picture.height / shown.height / picture.width - 1) < 0.02;
  return [...crossing, ...wide, ...(whole ? [] : ["the picture is cut or bent"])].join(" ");
})()"""
requests = []


def check(what, is_so):
    if not is_so:
        raise SystemExit("not so: " + what)


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".mjs": "text/javascript",
                      ".wasm": "application/wasm"}

    def log_message(self, *_):
        requests.append(self.path)


def serve(folder):
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}/index.html"


class Page:
    def __init__(self, browser, address):
        self.browser, self.address = browser, address

    def open(self, **words):
        self.browser.go("about:blank")
        self.browser.go(self.address + "#" + "&".join(f"{key}={quote(value)}" for key, value in words.items()))
        self.browser.until("document.body && document.body.dataset.ready === 'yes'", 120)

    def finished(self):
        self.browser.until("document.body.dataset.passes === 'all'", 300)

    def text_of(self, name):
        return self.browser.run(f"document.querySelector('{name}').textContent")

    def type(self, text):
        self.browser.run(f"(() => {{ const area = document.getElementById('text'); area.focus(); area.value = {text!r};"
                         "area.dispatchEvent(new Event('input')); })()")

    def samples(self):
        return bytes.fromhex(self.browser.run(
            "(() => { const c = document.getElementById('picture');"
            "return [...c.getContext('2d').getImageData(0, 0, c.width, c.height).data].filter((v, i) => i % 4 < 3)"
            ".map(v => v.toString(16).padStart(2, '0')).join(''); })()"))


def same_bytes(page, program, folder, titles):
    width, height = SIZE
    for title in titles:
        page.open(example=title, size=f"{width}x{height}", samples="1")
        page.finished()
        picture = folder / "native.ppm"
        subprocess.run([program, ROOT / "examples" / EXAMPLES[title], f"+W{width}", f"+H{height}", "--samples", "1",
                        "-V", "-o", picture], cwd=folder, check=True, stderr=subprocess.PIPE)
        native, shown = picture.read_bytes()[-3 * width * height:], page.samples()
        off = sum(a != b for a, b in zip(native, shown))
        print(f"{title}: {off} of {len(native)} samples differ from the native program's")
        check(f"{title}: as the native program's", len(native) == len(shown) and off == 0)


def writes_and_reads(page, shots):
    browser = page.browser
    page.open(size="96x72", samples="1")
    page.finished()
    page.type("camera { location -5*z look_at 0 }\nsphere { 0, x y }\n")
    browser.until("document.querySelector('#messages .error') !== null")
    check("the message names its line", "line 2" in page.text_of("#messages"))
    check("the place is marked", browser.run("document.querySelectorAll('#colours mark').length") == 1)
    if shots:
        browser.shot(str(shots / "mistake.png"))
    page.type("#declare Radius_Of_It = 1;\nsphere { 0, Radius_O")
    browser.run("(() => { const a = document.getElementById('text'); a.setSelectionRange(a.value.length, a.value.length);"
                "a.dispatchEvent(new Event('input')); })()")
    browser.until("document.querySelector('#proposals li') !== null")
    check("a declared name is proposed", "Radius_Of_It" in page.text_of("#proposals"))
    browser.key("Enter")
    check("the proposal is taken", browser.run("document.getElementById('text').value").endswith("sphere { 0, Radius_Of_It"))
    page.type("sphere { 0, 1 }")
    box = browser.run("(() => { const b = document.getElementById('text').getBoundingClientRect(); return [b.x, b.y]; })()")
    browser.mouse("Moved", box[0] + 30, box[1] + 20)
    browser.until("!document.getElementById('hint').hidden")
    check("help for a word", "sphere" in page.text_of("#hint").lower())


def turns(page):
    """A slider that a comment asks for changes the picture."""
    browser = page.browser
    page.open(size="96x72", samples="1")
    page.type("#version 3.8; #ifndef (Size) #declare Size = 0.2; #end // 0.1 to 2\n"
              "camera { location -5*z look_at 0 } sphere { 0, Size pigment { rgb 1 } finish { emission 1 } }")
    browser.until("document.querySelector('#knobs input[type=range]') !== null")
    page.finished()
    before = sum(page.samples())
    browser.run("(() => { const input = document.querySelector('#knobs input'); input.value = 1;"
                "input.dispatchEvent(new Event('input')); })()")
    browser.until("document.body.dataset.passes !== 'all'")
    page.finished()
    check("a larger ball is seen", sum(page.samples()) > 4 * before)


class Panels:
    """The panels over a scene, and what the native program makes of the same."""

    def __init__(self, page, program, folder, scene):
        self.page, self.browser, self.program, self.folder = page, page.browser, program, folder
        (folder / "scene.pov").write_text(scene)
        page.open(size="96x72", samples="16")
        page.type(scene)
        self.browser.until("document.body.dataset.passes !== 'all'")
        page.finished()
        self.run("scene.pov", "+W96", "+H72", "--samples", "16", "--layers", "lights", "-o", "light.exr")

    def run(self, *words):
        done = subprocess.run([self.program, *words], cwd=self.folder, check=True, capture_output=True, text=True)
        return done.stdout

    def redrawn(self, script):
        before = self.browser.run("document.body.dataset.drawn")
        self.browser.run(script)
        self.browser.until(f"document.body.dataset.drawn !== '{before}'")

    def same_as(self, what, *words):
        self.run("develop", "light.exr", "-o", "made.ppm", *words)
        check(what, (self.folder / "made.ppm").read_bytes()[-3 * 96 * 72:] == self.page.samples())


LAMPS = """#version 3.8; camera { location <0, 1, -6> look_at 0 film { response filmic } }
#declare Lamp = sphere { 0, 0.2 pigment { rgb 1 } finish { emission 15 } }
object { Lamp translate <-1.5 + clock, 1, 0> }
#declare Blue = sphere { 0, 0.2 pigment { rgb <0.2, 0.4, 1> } finish { emission 20 } }
object { Blue translate <1.5, 1, -1> }
plane { y, 0 pigment { rgb 0.7 } }
"""


def panels(page, program, folder, shots):
    """Lamps, film, EXR and a pixel, each as the native program makes it."""
    browser, on = page.browser, Panels(page, program, folder, LAMPS)
    names = browser.run("[...document.querySelectorAll('#lamps .name')].map(each => each.textContent).join()")
    check(f"the lamps are named ({names})", names == "Lamp,Blue")
    check("and where they stand", "scene.pov:3" in page.text_of("#lamps .from"))
    on.same_as("the picture is the developed light")
    browser.run("saveFile = content => { window.saved = content; }; document.getElementById('save-light').click()")
    saved = bytes.fromhex(browser.run("[...saved].map(byte => byte.toString(16).padStart(2, '0')).join('')"))
    check("the OpenEXR file is the native program's", saved == (folder / "light.exr").read_bytes())
    on.redrawn("document.querySelector('#lamps .lamp input[type=checkbox]').click()")
    on.same_as("without one lamp", "--light", "Lamp=0")
    if shots:
        browser.shot(str(shots / "playground-lamps.png"))
    browser.run("document.getElementById('panel-film').open = true")
    on.redrawn("(() => { const input = document.querySelector('#film input'); input.value = 1;"
               "input.dispatchEvent(new Event('input')); })()")
    on.same_as("and a stop brighter", "--light", "Lamp=0", "--exposure=1")
    check("the scene's own film is shown", browser.run("document.querySelector('#film select').value") == "filmic")
    if shots:
        browser.shot(str(shots / "playground-film.png"))
    on.redrawn("document.getElementById('film-reset').click()")
    on.redrawn("document.getElementById('lamps-reset').click()")
    on.same_as("as in the scene again")
    box = browser.run("(() => { const b = document.getElementById('picture').getBoundingClientRect();"
                      "return [b.x, b.y, b.width, b.height]; })()")
    browser.click(box[0] + 48.5 / 96 * box[2], box[1] + 60.5 / 72 * box[3])
    browser.until("document.getElementById('picked').textContent.includes('plane')")
    # The picture may lie between the pixels of the screen.
    said = page.text_of("#picked")
    x, y = (int(number) for number in re.match(r"<(\d+), (\d+)>", said).groups())
    check("the pixel is the one under the pointer", abs(x - 48) <= 1 and abs(y - 60) <= 1)
    check("a pixel is what the native program says of it",
          said == on.run("scene.pov", "+W96", "+H72", "--pick", f"{x},{y}"))
    browser.run("document.querySelector('#picked a').click()")
    check("its link leads to the line", browser.run("(() => { const a = document.getElementById('text');"
                                                    "return a.value.slice(a.selectionStart).split('\\n')[0]; })()").startswith("plane"))
    if shots:
        browser.shot(str(shots / "playground-pixel.png"))


def plays(page):
    """Frames, one after the other."""
    browser = page.browser
    browser.run("document.getElementById('panel-knobs').open = true; window.clocks = new Set();"
                "window.before = document.body.dataset.drawn;"
                "[...document.querySelectorAll('#knobs button')].find(each => each.textContent === 'Play').click()")
    browser.until("clocks.add([...document.querySelectorAll('#knobs output')].pop().value) && clocks.size >= 4", 120)
    browser.run("[...document.querySelectorAll('#knobs button')].find(each => each.textContent === 'Stop').click()")
    check("frames were seen", browser.run("Number(document.body.dataset.drawn) - Number(before)") >= 6)


def words_of_book(scene, files):
    """The words of the address to which the book's links lead."""
    sys.path.insert(0, str(ROOT / "man"))
    import book
    return dict(word.split("=") for word in re.search('#([^"]*)"', book.tried(scene, files))[1].split("&"))


def shares(page, program, folder):
    browser, scene = page.browser, ("#version 3.8; camera { location -5*z look_at 0 }\n"
                                    "sphere { 0, 1 pigment { rgb 1 } finish { emission 0.7 } } // \u00e9\n")
    page.open(size="96x72", samples="1")
    page.type(scene)
    browser.run("document.getElementById('share').click()")
    browser.until("location.hash.startsWith('#scene=')")
    code = browser.run("new URLSearchParams(location.hash.slice(1)).get('scene')")
    page.open(scene=code, size="96x72", samples="1")
    check("the address holds the scene", browser.run("document.getElementById('text').value") == scene)
    check("which is no example", browser.run("document.getElementById('examples').value") == "")
    page.finished()
    (folder / "shared.pov").write_text(scene)
    subprocess.run([program, "shared.pov", "+W96", "+H72", "--samples", "1", "-V", "-o", "shared.ppm"], cwd=folder,
                   check=True, stderr=subprocess.PIPE)
    check("its picture is that of the program", (folder / "shared.ppm").read_bytes()[-3 * 96 * 72:] == page.samples())
    read = scene + '#declare Rows = read_csv("lamps.csv");\n#debug concat("four: ", str(Rows[0][0], 0, 0))\n'
    page.open(**words_of_book(read, [("lamps.csv", "x,y\n4,5\n"), ("other.csv", "x\n")]), size="96x72", samples="1")
    check("so does a link of the book", browser.run("document.getElementById('text').value") == read)
    check("with its files", page.text_of("#file-list").endswith(": lamps.csv"))
    page.finished()
    check("which it reads", "four: 4" in page.text_of("#messages"))
    browser.run("history.replaceState(null, '', '#'); document.getElementById('share').click()")
    browser.until("location.hash.includes('&files=')")
    words = browser.run("Object.fromEntries(new URLSearchParams(location.hash.slice(1)))")
    page.open(**words, size="96x72", samples="1")
    check("and an address of the page holds them", page.text_of("#file-list").endswith(": lamps.csv"))
    library = ("../library/colors.inc", "#declare Red = rgb y;")
    page.open(**words_of_book('#include "../library/colors.inc"\n' + scene, [library]), size="96x72", samples="1")
    check("an address replaces nothing of the library",
          "light_arrays.inc" in browser.run("document.getElementById('text').value") and
          "library" not in page.text_of("#file-list"))
    page.open(scene="broken!", size="96x72", samples="1")
    check("a broken address gives an example", "light_arrays.inc" in browser.run("document.getElementById('text').value"))


def drops_and_saves(page):
    """Tables and scenes that are dropped on the page, and files that it saves."""
    browser, scene = page.browser, '#declare Rows = read_csv("dropped.csv");\n#debug concat("seven: ", str(Rows[0][0], 0, 0))\n'
    page.open(size="96x72", samples="1")
    browser.run("(() => { const drop = new DataTransfer();"
                "drop.items.add(new File(['x\\n7\\n'], 'dropped.csv'));"
                f"drop.items.add(new File([{scene!r}], 'dropped.pov'));"
                "document.dispatchEvent(new DragEvent('drop', { dataTransfer: drop, cancelable: true })); })()")
    browser.until("document.getElementById('messages').textContent.includes('seven: 7')")
    check("a dropped scene is shown", browser.run("document.getElementById('text').value") == scene)
    page.finished()
    browser.run("saveFile = (content, name) => { (window.kept ??= {})[name] = content; };"
                "for (const name of ['save-picture', 'save-scene']) document.getElementById(name).click()")
    browser.until("Object.keys(kept).length === 2")
    check("the scene is saved", browser.run("kept['scene.pov']") == scene)
    begin = browser.run("new Response(kept['scene.png']).arrayBuffer().then(bytes => [...new Uint8Array(bytes).slice(0, 4)])")
    check("so is the picture", bytes(begin) == b"\x89PNG")


def looks(page, shots):
    browser = page.browser
    for width, height in ((1280, 800), (768, 1024), (390, 844)):
        browser.size(width, height, phone=width < 500)
        page.open(example="A ring of lamps", size="960x720", samples="1")
        page.finished()
        crossing = browser.run(OVERLAP)
        check(f"at {width} pixels nothing overlaps ({crossing})", crossing == "")
        if shots:
            browser.shot(str(shots / f"playground-{width}.png"))
        browser.run("document.getElementById('panel-film').open = true")
        crossing = browser.run(OVERLAP)
        check(f"nor with the film's panel ({crossing})", crossing == "")
        if shots:
            browser.shot(str(shots / f"playground-film-{width}.png"))
    browser.run("document.getElementById('theme').click()")
    if shots:
        browser.shot(str(shots / "playground-theme.png"))
    browser.size(1280, 800)


def picture_of_page(address, file):
    """The page with a fine picture, as WebP. It takes minutes."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        browser = Chromium(place + "/profile", 1280, 800)
        try:
            page = Page(browser, address)
            page.open(example="A Ferris wheel", size="640x480", samples="64")
            browser.run("document.documentElement.dataset.theme = 'dark'")
            browser.until("document.body.dataset.passes === 'all'", 1800)
            time.sleep(1)  # the bar has gone
            browser.shot(place + "/page.png")
            subprocess.run(["oiiotool", place + "/page.png", "--ch", "R,G,B", "--compression", "webp:90", "-o", file], check=True)
        finally:
            browser.end()


def main():
    if sys.argv[2:3] == ["--picture"]:
        return picture_of_page(serve(Path(sys.argv[1]) / "playground"), sys.argv[3])
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    if not shutil.which("chromium") or not (Path(sys.argv[1]) / "playground.html").exists():
        print("skipped: chromium is not installed, or src/playground/pack.py has not made the playground")
        sys.exit(77)
    build, program = Path(sys.argv[1]).resolve(), str(Path(sys.argv[2]).resolve())
    shots = Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
        folder, browser = Path(place), Chromium(place + "/profile")
        try:
            page = Page(browser, serve(build / "playground"))
            same_bytes(page, program, folder, list(EXAMPLES)[:10])
            writes_and_reads(page, shots)
            turns(page)
            panels(page, program, folder, shots)
            plays(page)
            shares(page, program, folder)
            drops_and_saves(page)
            looks(page, shots)
            own = {path.name for path in (build / "playground").iterdir()}
            foreign = {each for each in requests if each.split("#")[0].split("?")[0].rsplit("/", 1)[-1] not in own}
            check(f"nothing is requested but its own files ({foreign})", not foreign)
            alone = Page(browser, f"file://{build / 'playground.html'}")
            same_bytes(alone, program, folder, list(EXAMPLES)[:1])
            browser.call("Page.addScriptToEvaluateOnNewDocument",
                         source="Object.defineProperty(Navigator.prototype, 'hardwareConcurrency', { get: () => 5 });"
                                "window.made = 0; Worker = class extends Worker { constructor(...all) { super(...all); ++made; } }")
            print("and by four workers:")
            same_bytes(page, program, folder, list(EXAMPLES)[:3])
            check("there were four", browser.run("made") >= 4)
            check(f"no errors of the page: {browser.errors}", not browser.errors)
        finally:
            browser.end()


if __name__ == "__main__":
    main()
