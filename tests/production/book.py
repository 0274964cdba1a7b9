#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The book without its pictures: each link leads to a place that there is, each word of the reference is found, and each scene
with a picture leads to the playground (tests/production/playground.py opens such a link).
book.py PROGRAM. 77: mandoc is missing."""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PAGES = ("candelabra.1 candelabra-develop.1 candelabra-merge.1 candelabra-fmt.1 candelabra-lsp.1 candelabra-relight.1 "
         "candelabra-solve.1 candelabra-povray.1 candelabra-python.3 candelabra-scene.5 candelabra-lights.7 candelabra-povray.7 candelabra-stdlib.7 candelabra-tutorial.7").split()


def page_of_playground(folder):
    page = folder / "playground.html"
    page.write_text("<!DOCTYPE html>\n")
    return page


def make(program, folder):
    made = folder / "man"
    made.mkdir()
    for page in PAGES:
        source = "tutorial.md" if page == "candelabra-tutorial.7" else page + ".in"
        subprocess.run(["cmake", f"-DPROGRAM={program}", "-DVERSION=0", f"-DINPUT={SOURCE}/man/{source}",
                        f"-DOUTPUT={made / page}", "-P", f"{SOURCE}/man/generate.cmake"], check=True)
    subprocess.run([sys.executable, str(SOURCE / "man" / "book.py"), program, str(made), str(folder / "manual"),
                    "--without-pictures", f"--playground={page_of_playground(folder)}"], check=True)
    return folder / "manual"


def problems(book):
    texts = {file.name: file.read_text() for file in book.glob("*.html")}
    places = {name: set(re.findall(r'\bid="([^"]+)"', text)) for name, text in texts.items()}
    words = json.loads((book / "words.js").read_text().removeprefix("const words = ").rstrip(";\n"))

    def leads_nowhere(name, address):
        if address.startswith("http"):
            return False
        page, _, place = address.partition("#")
        page = page or name
        if page == "playground.html":
            return not place.startswith("scene=")
        return page not in texts or (place and place not in places[page])

    for name, text in texts.items():
        for address in set(re.findall(r'<a [^>]*?href="([^"]+)"', text)):
            if leads_nowhere(name, address):
                yield f"{name} leads to {address}"
    for title, _, address, _ in words:
        if leads_nowhere("index.html", address):
            yield f"the search leads {title} to {address}"
    titles = {entry[0] for entry in words}
    for word in ("sphere", "bozo", "light_octree", "Light_Ring", "Round_Box", "declare", "vrotate", "media",
                 "Tutorial", "How bright", "--light-report"):
        if word not in titles:
            yield f"the search does not find {word}"
    for name, text in texts.items():
        pictures, tries = len(re.findall('<img [^>]*src="pictures/', text)), text.count('class="try"')
        # The tutorial also has a scene's picture as it is developed in other ways.
        if tries != (9 if name == "candelabra-tutorial.7.html" else pictures):
            yield f"{name} has {pictures} pictures of scenes, and {tries} links to try them"
    scenes = len(re.findall(r'class="scene"', texts["candelabra-tutorial.7.html"]))
    if scenes != 9:
        yield f"the tutorial has {scenes} pictures"
    for scene in (SOURCE / "examples" / "work").glob("*.pov"):
        if f"numbers_{scene.stem}.html" not in texts:
            yield f"{scene.name} has no page in Light by numbers"
    for group in ("shapes", "patterns", "cameras", "films"):
        bare = re.findall(r'<h2 id="(\w+)">(?:(?!<h2|<img).)*(?=<h2|</main>)', texts[group + ".html"], flags=re.S)
        for item in bare:
            yield f"{item} in {group}.html has no picture"


def main():
    if not shutil.which("mandoc"):
        return 77
    with tempfile.TemporaryDirectory() as folder:
        found = list(problems(make(sys.argv[1], Path(folder))))
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
