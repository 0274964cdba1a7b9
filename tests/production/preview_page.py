#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The preview's page in a browser without a window: the first picture, zoom, layers, lamps, film, the camera under the
mouse, a slider, what is under a pixel with its links, keys, themes, a phone, and after a mistake in the scene its
message; no panel lies over another one, and a page of another site gets and changes nothing. Ends with 77 where chromium
is missing. With a folder, it leaves pictures of the page there.
  preview_page.py PROGRAM [FOLDER]"""
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from chromium import Chromium

SCENE = """#version 3.7;
#ifndef (Size) #declare Size = 1; #end  // 0.5 to 2: of the lamp
camera { location -5*z look_at 0 }
#declare Lamp = sphere { 0, Size pigment { rgb 1 } finish { emission 1 } }
object { Lamp }
plane { y, -2 pigment { checker rgb 1, rgb <0.3, 0.5, 0.8> } }
light_source { <-5, 8, -6>, rgb 0.6 }
"""

ELSEWHERE = """<body><script>
const tell = (name, result) => document.body.append(name + ":" + result + " ");
for (const [name, options] of Object.entries({
    get: {}, blind: { mode: "no-cors" }, post: { method: "POST", mode: "no-cors", body: "name=Size&value=2" } }))
  for (const path of ["turn", "picture", "dim", "orbit"])
    fetch("ADDRESS" + path, options).then(() => tell(name + path, "sent"), () => tell(name + path, "refused"));
for (const path of ["picture.png", "save.png", "icon.svg", "manual/"]) {
  const image = new Image();
  image.onload = () => tell(path, "loaded");
  image.onerror = () => tell(path, "refused");
  image.src = "ADDRESS" + path;
}
</script></body>"""

# Whether two boxes that are to lie beside each other share a place.
OVERLAP = """(() => {
  const boxes = ["header", "#stage", "#panels", "footer", "#messages"].map(each => document.querySelector(each))
    .filter(each => each.checkVisibility()).map(each => [each.id || each.tagName, each.getBoundingClientRect()])
    .filter(([, box]) => box.width > 0 && box.height > 0);
  return boxes.flatMap(([a, p], i) => boxes.slice(i + 1).filter(([, q]) =>
    p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1).map(([b]) => a + b));
})().join(" ")"""


def check(what, is_so):
    if not is_so:
        raise SystemExit("not so: " + what)


def look(browser, address, shots, scene):
    def shot(name):
        if shots:
            browser.shot(f"{shots}/{name}.png")

    def colour(x, y):
        return browser.run(f"[...now.image.getContext('2d').getImageData({x}, {y}, 1, 1).data]")

    browser.go(address)
    browser.until("document.readyState === 'complete' && now.width === 320")
    browser.until("now.columns === 320 && element('status').textContent.includes('finished')")
    check("fit fills the stage", browser.run("view.zoom > 2 && view.fits"))
    shot("laptop")
    browser.key("1")
    check("1:1", browser.run("element('zoom').value") == "100 %")
    browser.key("f")
    check("fit", browser.run("view.fits"))
    # A layer, and back.
    browser.run("post('/look', { view: 'normal' })")
    browser.until("!element('badge').hidden && element('badge').textContent === 'normal'")
    browser.run("post('/look', { view: 'picture' })")
    browser.until("element('badge').hidden")
    # Lamps and film without rendering.
    before = browser.until("now.columns === 320 && now.generation")
    check("names of lamps", browser.run("lampRows.map(row => row.querySelector('.name').textContent).sort().join()") ==
          "Lamp,light_source")
    index = browser.run("lampRows.findIndex(row => row.textContent.startsWith('Lamp'))")
    lit = colour(160, 120)
    browser.run(f"lampRows[{index}].put(0)")
    browser.until("now.image.getContext('2d').getImageData(160, 120, 1, 1).data[0] < 250")
    check("the lamp was lit", lit[0] == 255)
    browser.run("post('/dim', { reset: 'all' })")
    browser.until("now.image.getContext('2d').getImageData(160, 120, 1, 1).data[0] === 255")
    browser.key("[")
    browser.until("film.now < 0")
    browser.run("post('/develop', { name: 'reset' })")
    browser.until("film.now === 0")
    check("relit without rendering", browser.run("now.generation") == before)
    browser.run("compared.image = null")
    browser.key("s")
    check("nothing to compare with", browser.run("divider.hidden && "
                                                 "element('split').ariaPressed === 'false'"))
    # The camera under the mouse; the last picture stays to be compared with.
    browser.key("c")
    browser.drag([(400, 300), (420, 300), (460, 310), (500, 320)])
    browser.until(f"now.generation > {before} && !element('camera-reset').disabled")
    check("the last picture is kept", browser.run("compared.image !== null"))
    check("the camera is a script", "look_at" in browser.run("fetch('/camera').then(answer => answer.text())"))
    browser.key("s")
    check("split", browser.run("!divider.hidden && element('split').ariaPressed === 'true'"))
    browser.key("s")
    browser.key("0")
    browser.until("element('camera-reset').disabled && element('status').textContent.includes('finished')")
    # A slider of the scene: the old picture stays until the new one is there.
    before = browser.run("now.generation")
    browser.run("""window.black = 0; window.taking = take; take = bytes => { taking(bytes);
      if (new Uint8ClampedArray(bytes, 20).every((v, i) => i % 4 === 3 || v === 0)) ++black; };""")
    for value in (0.8, 1.1, 1.4, 1.7):
        browser.run(f"knobRows[0].querySelector('input').value = {value};"
                    "knobRows[0].querySelector('input').dispatchEvent(new Event('input'))")
        time.sleep(0.05)
    browser.until(f"now.generation > {before} && element('status').textContent.includes('finished')")
    check("never black", browser.run("black") == 0)
    # What is under a pixel, and links.
    browser.key("v")
    x, y = browser.run("[view.x + 160 * view.zoom, view.y + 230 * view.zoom + stage.getBoundingClientRect().top]")
    browser.click(x, y)
    browser.until("element('picked').textContent.includes('pigment { checker')")
    links = browser.run("[...element('picked').querySelectorAll('a')].map(each => each.href)")
    check(f"links to the scene: {links}", f"vscode://file{scene}:6" in links)
    browser.run("element('panel-report').open = true")
    browser.until("element('lights').textContent.includes('scene.pov:7: light_source')")
    shot("pixel")
    for width, height, phone in ((1280, 800, False), (1920, 1080, False), (390, 844, True)):
        browser.size(width, height, phone)
        for theme in ("dark", "light"):
            browser.run(f"useTheme('{theme}'); fit(); document.body.classList.remove('without-panels')")
            time.sleep(0.3)
            check(f"nothing overlaps at {width}", browser.run(OVERLAP) == "")
            check(f"no scrolling at {width}", browser.run("document.documentElement.scrollWidth <= innerWidth"))
            shot(f"{width}_{theme}")
    browser.size(1280, 800)
    # Warnings in a bar that can be folded, with links, and what the scene says.
    text = Path(scene).read_text()
    check("no messages", browser.run("element('warnings').hidden && element('panel-console').hidden"))
    Path(scene).write_text(text + '#debug "so it is"\n#warning "<b>mind</b> the step"\nunion { }\n')
    browser.until("!element('warnings').hidden && !element('panel-console').hidden")
    check("two warnings", browser.run("element('warnings').querySelector('summary').textContent") == "2 warnings")
    browser.run("element('warnings').open = true")
    told = browser.run("element('warnings').querySelector('pre').textContent")
    check("warnings are told: " + told, "warning[user-warning]" in told and "warning[no-effect]" in told and
          "<b>mind</b>" in told)
    links = browser.run("[...element('warnings').querySelectorAll('a')].map(each => each.href)")
    check(f"warnings have links: {links}", f"vscode://file{scene}:9" in links)
    check("the console says", "so it is" in browser.run("element('said').textContent"))
    check("nothing overlaps with warnings", browser.run(OVERLAP) == "")
    shot("warnings")
    browser.size(390, 844, True)
    time.sleep(0.3)
    check("nothing overlaps with warnings on a phone", browser.run(OVERLAP) == "")
    shot("warnings_phone")
    browser.size(1280, 800)
    check("lamps are saved", '"Lamp": {' in browser.run("lampsAsJson(lampsNow)"))
    Path(scene).write_text(text)
    browser.until("element('warnings').hidden && element('panel-console').hidden")
    # A mistake, below which the old picture stays.
    text = Path(scene).read_text()
    Path(scene).write_text(text + "sphere { 0, Sise }\n")
    browser.until("element('errors').textContent.includes('nothing is declared as `Sise`')")
    check("the picture stays", browser.run("now.image !== null"))
    check("nothing overlaps with a mistake", browser.run(OVERLAP) == "")
    shot("mistake")
    Path(scene).write_text(text)
    browser.until("element('errors').textContent === ''")
    browser.go(address + "manual/")
    browser.until("document.body && /manual|Candelabra/i.test(document.body.textContent)")
    return [each for each in browser.errors if "manual" not in str(each)]


def watch(browser, address):
    """Frames of an animation, played."""
    browser.go(address)
    browser.until("document.readyState === 'complete' && element('status').textContent.includes('finished')")
    browser.run("window.frames = new Set(); const showing = showKnobs; showKnobs = knobs => { showing(knobs); "
                "window.frames.add(knobs.find(isFrame).value); }; player.button.click()")
    browser.until("[1, 2, 3].every(each => window.frames.has(each))")
    browser.run("player.button.click()")
    check("it stops", browser.run("!player.plays && player.button.textContent === 'Play'"))


def main():
    if not shutil.which("chromium"):
        print("skipped: chromium is not installed")
        sys.exit(77)
    program = str(Path(sys.argv[1]).resolve())
    shots = str(Path(sys.argv[2]).resolve()) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        scene = str(Path(folder).resolve() / "scene.pov")
        Path(scene).write_text(SCENE)
        run = subprocess.Popen([program, "scene.pov", "+W320", "+H240", "--samples", "16", "--preview", "0"],
                               stderr=subprocess.PIPE, text=True, cwd=folder)
        browser = None
        try:
            said = ""
            while not said.startswith("preview: "):
                said = run.stderr.readline()
            address = said.split()[-1]
            browser = Chromium(folder + "/profile")
            errors = look(browser, address, shots, scene)
            check(f"no errors of the page: {errors}", not errors)
            before = browser.run("fetch('/status').then(answer => answer.text())")
            page = Path(folder) / "elsewhere.html"
            page.write_text(ELSEWHERE.replace("ADDRESS", address))
            browser.go("file://" + str(page))
            said = browser.until("document.body && document.body.textContent.split(':').length > 12 &&"
                                 "document.body.textContent")
            time.sleep(1)
            said = browser.run("document.body.textContent")
            for name in ("getturn", "getpicture", "getdim", "getorbit"):
                check("another site is refused: " + name, name + ":refused" in said)
            check("another site sees nothing: " + said, ":loaded" not in said)
            browser.go(address)
            browser.until("document.readyState === 'complete' && now.width === 320")
            after = browser.run("fetch('/status').then(answer => answer.text())")
            keep = '"moved":false', '"relit":false', '"film_changed":false'
            check("another site has changed nothing", all(each in before and each in after for each in keep))
            run.terminate()
            run.wait(30)
            run = subprocess.Popen([program, "scene.pov", "+W64", "+H48", "--samples", "2", "+KFF3", "--preview", "0"],
                                   stderr=subprocess.PIPE, text=True, cwd=folder)
            said = ""
            while not said.startswith("preview: "):
                said = run.stderr.readline()
            watch(browser, said.split()[-1])
        finally:
            if browser:
                browser.end()
            run.terminate()
            run.wait(30)


main()
