# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages "Light by numbers" of the book: a page for each scene of examples/work with its picture, its false colours, the
table of its meters, where its light goes, and its text. Used by book.py."""
import hashlib
import html
import json
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

WORK = Path(__file__).resolve().parent.parent / "examples" / "work"
# Each scene, the title of its page, and what is declared for the table of its meters.
SCENES = [("office", "An office", ()), ("street", "A street", ()), ("pitch", "A football pitch", ()),
          ("shop_window", "A shop window", ()), ("daylight", "A room by daylight", ("Declare=Overcast=1",)),
          ("solved_street", "A street whose lamps are solved", ())]
# Scenes whose light is that of the sky, which has no flux: there is nothing to say about where it goes.
WITHOUT_LAMPS = {"daylight"}
SIZE = ("+W960", "+H540")
UNITS = {"cd/m2": "cd/m²"}


def rounded(value):
    """A number with three digits."""
    if value == 0:
        return "0"
    shown = f"{value:.3g}"
    return f"{float(shown):g}" if "e" in shown else shown


def with_error(value):
    return f'{rounded(value["value"])} <small>± {rounded(value["error"])}</small>'


class Numbers:
    """What the program measures in the scenes, kept by what it was measured in."""

    def __init__(self, program, folder, illustrated):
        self.program, self.folder, self.illustrated, self.failed = program, folder, illustrated, []
        folder.mkdir(parents=True, exist_ok=True)

    def run(self, *words):
        done = subprocess.run([self.program, *words], cwd=WORK, capture_output=True, text=True)
        if done.returncode != 0:
            self.failed.append(done.stderr)
        return done.stdout

    def shown(self, scene, declared):
        """The name of the folder with all of a scene: picture, colours, table and balance."""
        source = (WORK / (scene + ".pov")).read_text()
        name = scene + "_" + hashlib.sha256((source + " ".join(declared)).encode()).hexdigest()[:12]
        made = self.folder / name
        if not self.illustrated or made.exists():
            return name
        failed = len(self.failed)
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            light = str(work / "light.exr")
            file = scene + ".pov"
            self.run(file, *SIZE, "+O" + light, "--layers", "illuminance,luminance", "--noise", "0.03", "--time", "300s",
                     "-V", "--warn", "none")
            self.run("develop", light, "-o", str(work / "picture.png"), "-V")
            self.run("develop", light, "--false-colour", "lux", "--isolines", "-o", str(work / "lux.png"), "-V")
            self.run(file, "--measure", str(work / "meters.json"), "--time", "40s", "-V", "--warn", "none", *declared)
            if scene not in WITHOUT_LAMPS:
                text = self.run(file, "--light-balance", str(work / "balance.csv"), "--time", "30s", "--warn", "none")
                # The library's files by their names alone.
                (work / "balance.txt").write_text(re.sub(r"\S*/stdlib/", "", text))
            Path(light).unlink(missing_ok=True)
            if len(self.failed) == failed:
                shutil.copytree(work, made)
        return name

    # ---- parts of a page

    @staticmethod
    def summary(meters):
        rows = []
        for meter in meters:
            unit = UNITS.get(meter["unit"], meter["unit"])
            several = len(meter["points"]) > 1
            value = f'{with_error(meter["mean"])} {unit}'
            cells = [html.escape(meter["name"]), meter["quantity"].replace("_", " "), value]
            if several:
                cells += [rounded(meter["min"]["value"]), rounded(meter["max"]["value"]),
                          "" if meter["quantity"] == "ugr" else rounded(meter["uo"]["value"]), str(len(meter["points"]))]
            else:
                cells += ["", "", "", "1"]
            rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
        heads = ("meter", "quantity", "mean", "least", "greatest", "U<sub>o</sub>", "points")
        return ('<div class="wide"><table class="numbers"><tr>' + "".join(f"<th>{head}</th>" for head in heads) + "</tr>" +
                "".join(rows) + "</table></div>")

    @staticmethod
    def grid(meter):
        """The values of a grid at their places, with the least and the greatest marked."""
        along, across = meter["counts"]
        values = [point["value"] for point in meter["points"]]
        # Points inside of objects have no value.
        known = [value for value in values if value is not None]
        least, greatest = min(known, default=None), max(known, default=None)
        rows = []
        for j in reversed(range(across)):
            cells = ""
            for value in values[j * along:(j + 1) * along]:
                if value is None:
                    cells += "<td>–</td>"
                    continue
                mark = ' class="least"' if value == least else ' class="greatest"' if value == greatest else ""
                cells += f"<td{mark}>{rounded(value)}</td>"
            rows.append(f"<tr>{cells}</tr>")
        unit = UNITS.get(meter["unit"], meter["unit"])
        about = meter["quantity"].replace("_", " ") + (", " + unit if unit else "")
        return (f'<h3>{html.escape(meter["name"])}: {about}</h3><div class="wide"><table class="grid">' + "".join(rows) +
                "</table></div>")

    def page(self, scene, title, declared):
        """The parts of the page of a scene."""
        source = (WORK / (scene + ".pov")).read_text()
        about, *commands = self.head(source)
        name = self.shown(scene, declared)
        place = f"numbers/{name}/"
        parts = [about, f'<img src="{place}picture.png" alt="{title}" width="960" height="540">', *commands]
        parts.append('<h2 id="lux">Lux in false colours</h2>'
                     '<p>The illuminance of all that is seen, with lines at the marks of the scale.</p>'
                     f'<img src="{place}lux.png" alt="illuminance in false colours" width="960" height="608">')
        parts.append('<h2 id="meters">What the meters say</h2>')
        file = self.folder / name / "meters.json"
        if file.exists():
            meters = json.loads(file.read_text())["meters"]
            parts.append("<p>Means have half of their 95 % interval beside them." + (
                f" Measured with <code>{html.escape(' '.join(declared))}</code>." if declared else "") + "</p>")
            parts.append(self.summary(meters))
            grids = [meter for meter in meters if "counts" in meter and 1 < len(meter["points"]) <= 240]
            if grids:
                parts.append('<p>At the points of the grids, with the first row below; the <span class="least">least</span> '
                             'and the <span class="greatest">greatest</span> are marked.</p>')
                parts += [self.grid(meter) for meter in grids]
        if scene not in WITHOUT_LAMPS:
            parts.append('<h2 id="balance">Where the light goes</h2>')
        report = self.folder / name / "balance.txt"
        if report.exists():
            parts.append(f'<pre class="report">{html.escape(report.read_text())}</pre>')
        parts.append(f'<h2 id="scene">The scene</h2><details><summary>examples/work/{scene}.pov</summary>'
                     f"<pre>{html.escape(source)}</pre></details>")
        return parts

    @staticmethod
    def head(source):
        """What the scene's first lines say, in parts: paragraphs, and the commands and answers between them."""
        blocks = []
        for line in source.splitlines()[1:]:
            if not line.startswith("//"):
                break
            kind = "pre" if line.startswith("//   ") else "p"
            if not blocks or blocks[-1][0] != kind:
                blocks.append((kind, []))
            blocks[-1][1].append(line[5:].rstrip() if kind == "pre" else line[2:].strip())
        parts = []
        for kind, lines in blocks:
            text = html.escape((" " if kind == "p" else "\n").join(lines))
            parts.append(f"<{kind}>" + (re.sub("`(.*?)`", r"<code>\1</code>", text) if kind == "p" else text) + f"</{kind}>")
        return parts

    def overview(self):
        """The parts of the page that leads to the scenes."""
        parts = ["<p>Six scenes as lighting planners have them: lamps by their data sheets, meters by standards, and what "
                 "they say. Every number has an interval that holds the true value in 95 of 100 cases. "
                 '<a href="candelabra-lights.7.html">Light</a> tells how a scene gets there, section '
                 '<a href="candelabra.1.html#METERS">Meters</a> what is measured and how exactly.</p>', '<div class="gallery">']
        for scene, title, declared in SCENES:
            name = self.shown(scene, declared)
            parts.append(f'<figure><a href="numbers_{scene}.html"><img src="numbers/{name}/picture.png" alt="" loading="lazy" '
                         f'width="240" height="135"><figcaption>{title}</figcaption></a></figure>')
        return parts + ["</div>"]

    def pages(self):
        """Address, title and parts of each page."""
        yield "numbers.html", "Light by numbers", self.overview()
        for scene, title, declared in SCENES:
            yield f"numbers_{scene}.html", title, self.page(scene, title, declared)

    def tidy(self):
        """Removes what was measured in other scenes."""
        kept = {self.shown(scene, declared) for scene, _, declared in SCENES}
        for old in self.folder.iterdir():
            if old.name not in kept and re.fullmatch(r"\w+_[0-9a-f]{12}", old.name):
                for file in old.iterdir():
                    file.unlink()
                old.rmdir()
