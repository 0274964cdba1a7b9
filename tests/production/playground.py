#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The playground in a browser without a window, as a folder behind a server and as one file: it shows the samples that the
native program makes, byte for byte; mistakes are shown where they are; completion and help come; an address holds a scene;
nothing overlaps at three widths; nothing is requested but its own files.
  playground.py BUILD PROGRAM [FOLDER]    BUILD: that of src/packaging/wasm/build.sh, with the playground made;
                                          FOLDER: gets pictures of the page"""
import functools
import http.server
import importlib.util
import shutil
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from urllib.parse import quote

from chromium import Chromium

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = dict(line.rsplit(": ", 1) for line in (ROOT / "src/playground/examples.txt").read_text().splitlines())
SIZE = (96, 72)
OVERLAP = """(() => {
  const boxes = ["header", "#writing", "#stage", "#panel", "footer"].map(each => document.querySelector(each))
    .map(each => [each.id || each.tagName, each.getBoundingClientRect()]);
  const crossing = boxes.flatMap(([a, p], i) => boxes.slice(i + 1).filter(([, q]) =>
    p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1).map(([b]) => a + b));
  const wide = document.documentElement.scrollWidth > innerWidth ? ["wider than the window"] : [];
  return [...crossing, ...wide].join(" ");
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


def code_of_book(scene):
    """The scene as the book puts it into its links."""
    about = importlib.util.spec_from_file_location("manual_book", ROOT / "man/book.py")
    book = importlib.util.module_from_spec(about)
    about.loader.exec_module(book)
    return book.tried(scene).split("=")[1]


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
    page.finished()
    (folder / "shared.pov").write_text(scene)
    subprocess.run([program, "shared.pov", "+W96", "+H72", "--samples", "1", "-V", "-o", "shared.ppm"], cwd=folder,
                   check=True, stderr=subprocess.PIPE)
    check("its picture is that of the program", (folder / "shared.ppm").read_bytes()[-3 * 96 * 72:] == page.samples())
    page.open(scene=code_of_book(scene), size="96x72", samples="1")
    check("so does a link of the book", browser.run("document.getElementById('text').value") == scene)
    page.open(scene="broken!", size="96x72", samples="1")
    check("a broken address gives an example", "light_arrays.inc" in browser.run("document.getElementById('text').value"))


def looks(page, shots):
    browser = page.browser
    for width, height in ((1280, 800), (800, 900), (390, 844)):
        browser.size(width, height, phone=width < 500)
        page.open(example="Neon", size="320x240", samples="1")
        page.finished()
        crossing = browser.run(OVERLAP)
        check(f"at {width} pixels nothing overlaps ({crossing})", crossing == "")
        if shots:
            browser.shot(str(shots / f"playground-{width}.png"))
    browser.run("document.getElementById('theme').click()")
    if shots:
        browser.shot(str(shots / "playground-theme.png"))
    browser.size(1280, 800)


def main():
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
            shares(page, program, folder)
            looks(page, shots)
            own = {path.name for path in (build / "playground").iterdir()}
            foreign = {each for each in requests if each.split("#")[0].split("?")[0].rsplit("/", 1)[-1] not in own}
            check(f"nothing is requested but its own files ({foreign})", not foreign)
            alone = Page(browser, f"file://{build / 'playground.html'}")
            same_bytes(alone, program, folder, list(EXAMPLES)[:1])
            check(f"no errors of the page: {browser.errors}", not browser.errors)
        finally:
            browser.end()


main()
