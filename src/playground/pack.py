#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the playground of the program that ../packaging/wasm/build.sh has built: a folder for any web server that sends files, and
one file that opens from a disk or a mail.
  pack.py BUILD     makes BUILD/playground/ and BUILD/playground.html
BUILD/npm/package (../packaging/npm/pack.sh) must be there: it runs the program for its grammar."""
import base64
import gzip
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

own = Path(__file__).resolve().parent
root = own.parents[1]
modules = ["assets", "engine", "language", "editor", "exr", "back_end", "playground"]  # each behind those that it imports


shared = root / "src/preview/page"  # with the preview
scripts = ["widgets", "asking", "lamp_panel", "film_panel", "scene_panel", "pixel_panel"]


def grammar(build):
    program = build / "npm/package/bin/candelabra.js"
    said = subprocess.run(["node", program, "--describe", "textmate"], check=True, capture_output=True, text=True).stdout
    return {"patterns": [each for each in json.loads(said)["patterns"] if "match" in each]}


def content(path):
    """A file as JSON: its text, or its bytes in base64."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return {"base64": base64.b64encode(path.read_bytes()).decode()}


def example(path):
    """A scene with the data files beside it that it names."""
    text = path.read_text()
    names = set(re.findall(r'"([\w./-]+\.(?:csv|json|ies|ldt|inc|png))"', text))
    beside = {name: content(path.parent / name) for name in sorted(names) if (path.parent / name).is_file()}
    wide = re.search(r"\b16 ?/ ?9\b", text)
    return {"text": text, "files": beside, "size": "640x360" if wide else "480x360"}


def parts(build):
    library = {str(path.relative_to(root / "stdlib")): content(path) for path in sorted((root / "stdlib").rglob("*"))
               if path.is_file()}
    lines = [line.rsplit(": ", 1) for line in (own / "examples.txt").read_text().splitlines()]
    examples = {title: example(root / "examples" / path) for title, path in lines}
    return json.dumps({"library": library, "examples": examples, "grammar": grammar(build)}, ensure_ascii=False)


def without_imports(text):
    text = re.sub(r"^import [^;]*;\n", "", text, flags=re.M)
    text = re.sub(r"^export default .*;?\n?", "", text, flags=re.M)
    return re.sub(r"^export ", "", text, flags=re.M)


def worker(build):
    """A script of the old kind: pages that come from a file may have no others as workers."""
    program = without_imports((build / "candelabra.mjs").read_text())
    program = program.replace("const require = createRequire(import.meta.url);", "").replace("import.meta.url", "location.href")
    return "\n".join([program,
                      without_imports((root / "src/packaging/npm/lib/program.mjs").read_text()),
                      (own / "worker.js").read_text()])


def one_file(folder):
    def packed(name):
        return base64.b64encode(gzip.compress((folder / name).read_bytes(), 9, mtime=0)).decode()

    page = (folder / "index.html").read_text()
    icon = "data:image/svg+xml;base64," + base64.b64encode((folder / "icon.svg").read_bytes()).decode()
    style = "".join(f"<style>\n{(folder / name).read_text()}</style>\n" for name in ("common.css", "style.css"))
    script = "\n".join(without_imports((folder / f"{name}.mjs").read_text()) for name in modules)
    data = "".join(f'<script type="text/plain" id="part:{name}">{packed(name)}</script>\n'
                   for name in ("candelabra.wasm", "parts.json", "worker.js"))
    page = re.sub('<link rel="preload".*>\n', "", page).replace("icon.svg", icon)
    page = re.sub(r'<link rel="stylesheet" href="common.css">\n<link rel="stylesheet" href="style.css">\n', lambda _: style, page)
    for name in scripts:
        page = page.replace(f'<script src="{name}.js"></script>', f"<script>\n{(folder / f'{name}.js').read_text()}</script>")
    return page.replace('<script type="module" src="playground.mjs"></script>\n',
                        f'{data}<script type="module">\n{script}</script>\n')


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve()
    folder = build / "playground"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for path in [own / "style.css", shared / "common.css", shared / "icon.svg", *(shared / f"{name}.js" for name in scripts),
                 build / "candelabra.wasm", *(own / f"{name}.mjs" for name in modules)]:
        shutil.copy(path, folder)
    page = (own / "index.html").read_text().replace("PANELS-OF-THE-PAGE", (shared / "panels.html").read_text())
    (folder / "index.html").write_text(page)
    (folder / "parts.json").write_text(parts(build))
    (folder / "worker.js").write_text(worker(build))
    single = build / "playground.html"
    single.write_text(one_file(folder))
    print(f"{folder}: {sum(path.stat().st_size for path in folder.iterdir())} bytes; {single}: {single.stat().st_size} bytes")


main()
