#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the book: the manual as HTML, with a picture for each scene, shape, pattern, normal, finish, light, camera and
macro. book.py PROGRAM MAN FOLDER [--without-pictures] [--playground=FILE]: the program, the folder of the made manual
pages, the folder to write (index.html); FILE: the playground as one file, which is copied there, so that each whole scene
can be tried. Needs mandoc. Pictures are kept by what they show, so that another run makes new ones only."""
import base64
import concurrent.futures
import hashlib
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

from numbers_pages import Numbers

HERE = Path(__file__).resolve().parent
FRONT = HERE.parent / "examples" / "pictures" / "metropolis.webp"
PAGES = [("candelabra-tutorial.7", "Tutorial"), ("candelabra-lights.7", "Light"),
         ("candelabra-povray.7", "From POV-Ray"), ("candelabra-scene.5", "The language"),
         ("candelabra.1", "The program"), ("candelabra-develop.1", "candelabra develop"),
         ("candelabra-relight.1", "candelabra relight"), ("candelabra-solve.1", "candelabra solve"),
         ("candelabra-povray.1", "candelabra-povray"),
         ("candelabra-merge.1", "candelabra merge"),
         ("candelabra-fmt.1", "candelabra fmt"), ("candelabra-lsp.1", "candelabra lsp"),
         ("candelabra-python.3", "Python")]

HEAD = "#version 3.7; global_settings { assumed_gamma 1 }\n"
EYE = "camera { location -4*z look_at 0 angle 40 right 4/3*x }\n"
LAMP = "light_source { <-4, 6, -8>, rgb 1 }\n"
SKY = "background { rgb <0.3, 0.35, 0.4> }\n"
FLOOR = "plane { y, 0 pigment { checker rgb 0.9, rgb 0.35 } finish { ambient 0.1 diffuse 0.7 } }\n"
# Lamps of many strengths, some of them of a colour, and what they light.
NIGHT = ("#default { finish { ambient 0 } }\nplane { y, 0 pigment { rgb 0.45 } }\n"
         "plane { -z, -3 pigment { rgb <0.5, 0.45, 0.4> } }\n"
         "sphere { <0, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.8, 0.75> } }\n#for (I, 0, 6)\n"
         "sphere { <0.9*I - 2.7, 1.9 + 0.1*pow(I - 3, 2), 1>, 0.06 pigment { rgb <1, 0.65, 0.3> }"
         " finish { diffuse 0 emission 60 } }\n"
         "sphere { <0.6*I - 1.8, 0.1, -1.4>, 0.1 pigment { rgb <mod(I, 2), 0.2, 1 - mod(I, 2)> }"
         " finish { diffuse 0 emission 5 } }\n#end\n")
STAND = ("camera { location <0, 2.4, -6> look_at <0, 0.85, 0> angle 36 right 4/3*x }\n"
         "plane { y, 0 pigment { rgb 0.45 } }\n")


# Options that make another picture of the same light.
DEVELOPS = {"--film", "--exposure", "--key", "--response", "--contrast", "--saturation", "--white-balance", "--glare",
            "--vignette", "--grain"}

# Tables that examples of macros read.
TABLES = (("lamps.csv", "x,y,z,colour\n-1,0.6,0,#ff8800\n0,1.4,0,#ffffff\n1,0.6,0,#3366ff\n"),
          ("strings.csv", "x,y,z,string\n-1,0.6,0,Left\n0,1.4,0,Right\n1,0.6,0,Right\n"),
          ("film.csv", "255,80,0,0,255,0,80,80,255\n0,0,255,255,255,0,255,0,0\n"))


def shown_night(words):
    """The scene at night, in which a film develops the light."""
    return (HEAD + "camera { location <0, 1.8, -5.5> look_at <0, 0.95, 0> angle 46 right 4/3*x\n" + words +
            " }\n" + NIGHT)


def frame(words, solids):
    """The scene that shows one example, which may begin with a word of solids; none for
    examples that are nothing to look at by themselves."""
    first = re.match(r"#?\w+", words)[0]
    if first == "pigment":
        return (HEAD + EYE + "box { <-1.9, -1.4, -0.01>, <1.9, 1.4, 1>\n"
                "texture { " + words + " finish { ambient 1 diffuse 0 } } }")
    if first == "normal":
        return (HEAD + EYE + LAMP + SKY + "sphere { 0, 1.1 pigment { rgb <0.9, 0.75, 0.5> }\n" +
                words + " finish { specular 0.3 roughness 0.02 } }")
    if first in ("finish", "texture"):
        pigment = "pigment { rgb <0.9, 0.55, 0.25> } " if first == "finish" else ""
        return (HEAD + "global_settings { subsurface { } }\n" + EYE + LAMP + "sky_sphere { pigment { gradient y\n"
                "color_map { [0 rgb <0.9, 0.9, 0.8>] [1 rgb <0.3, 0.5, 0.9>] } } }\nobject { " + FLOOR +
                "translate -y } sphere { 0, 1 " + pigment + words + " }")
    if first == "light_source":
        return (HEAD + "camera { location <0, 3, -6> look_at 0.5*y angle 45 right 4/3*x }\n" + FLOOR +
                "sphere { <-0.7, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.5, 0.3> } }\n"
                "cylinder { <1, 0, 0.4>, <1, 1.8, 0.4>, 0.3 pigment { rgb <0.4, 0.6, 0.9> } }\n" + words)
    if first == "camera":
        return (HEAD + words + "\n" + LAMP + SKY + FLOOR +
                "sphere { 0.7*y, 0.7 pigment { rgb <0.9, 0.5, 0.3> } }\n#for (I, 0, 11)\n"
                "cylinder { 0, 3*y, 0.25 pigment { rgb <0.4, 0.6, 0.9> } translate 4*z rotate 30*I*y }\n#end")
    if first == "film":
        return shown_night(words)
    if first == "bokeh":
        return shown_night("aperture 1.4 blur_samples 64 focal_point <0, 0.6, -3> film { exposure auto response agx } " +
                           words)
    if first in solids:
        return HEAD + STAND + LAMP + SKY + "object { " + words + "\npigment { rgb <0.9, 0.6, 0.35> } }"
    return ""


def macro_frame(file, words):
    """The scene that shows an example of a macro: lamps in the dark, other things in the light."""
    lamps = file in ("light_arrays.inc", "luminaires.inc")
    view = "" if "Set_Camera" in words or "light_source" in words else STAND
    light = ("#default { finish { ambient 0 } }\n" if lamps else
             "" if "light_source" in words else LAMP + SKY)
    if "light_source" in words:
        view = STAND
    if file == "luminaires.inc":
        view = ("global_settings { photometry { unit 1 white 100 } }\n" +
                view.replace("right 4/3*x }", "right 4/3*x film { exposure auto response agx } }"))
    return (HEAD + '#include "' + file + '"\n#declare Stream = seed(1);\n'
            "#declare Bulb = sphere { 0, 0.06 pigment { rgb <1, 0.8, 0.5> } finish { emission 12 } }\n" +
            light + view + words)


def prose(text):
    """A sentence of the help as HTML: what stands between backticks is code."""
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", html.escape(text))


def plain(text):
    """HTML as text in one line."""
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", text)).split())


def packed(text):
    """A text as the playground has it in addresses."""
    pack = zlib.compressobj(9, zlib.DEFLATED, -15)
    return base64.urlsafe_b64encode(pack.compress(text.encode()) + pack.flush()).decode().rstrip("=")


def tried(scene, files=()):
    """A link to the playground with a scene and those of the files that it names. files: names and texts."""
    named = {name: text for name, text in files if name in scene}
    beside = "&files=" + packed(json.dumps(named)) if named else ""
    return f'<a class="try" href="playground.html#scene={packed(scene)}{beside}">Try it</a>'


def sentence(head):
    """The head of a section, which manual pages write in capitals."""
    number, _, words = head.rpartition(". ")
    words = words.lower().replace("pov-ray", "POV-Ray").replace("json", "JSON")
    return (number + ". " if number else "") + words[:1].upper() + words[1:]


class Pictures:
    """Scenes that are to be rendered into a folder, each once."""

    def __init__(self, program, folder):
        self.program, self.folder, self.scenes, self.failed = program, folder, {}, []
        folder.mkdir(parents=True, exist_ok=True)

    def add(self, scene, size=(240, 180), files=TABLES, options=()):
        """The address of its picture. files: names and texts of what lies beside the scene."""
        name = hashlib.sha256((scene + str(size) + " ".join(options)).encode()).hexdigest()[:16]
        self.scenes[name] = (scene, size, files, options)
        return "pictures/" + name + ".png"

    def render(self, name):
        scene, size, files, options = self.scenes[name]
        target = self.folder / (name + ".png")
        if target.exists():
            return
        with tempfile.TemporaryDirectory() as work:
            for file, text in (*files, ("scene.pov", scene)):
                (Path(work) / file).write_text(text)
            done = subprocess.run([self.program, "scene.pov", f"+W{size[0]}", f"+H{size[1]}", "+WT1", "--noise", "0.06",
                                   "--time", "20s", "-V", "--warn", "none", "+Oscene.png", *options],
                                  cwd=work, capture_output=True, text=True)
            if done.returncode == 0:
                shutil.move(Path(work) / "scene.png", target)
            else:
                self.failed.append(done.stderr)

    def render_all(self):
        with concurrent.futures.ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as pool:
            list(pool.map(self.render, self.scenes))
        for old in self.folder.glob("*.png"):
            if old.stem not in self.scenes:
                old.unlink()


class Book:
    def __init__(self, program, made, folder, illustrated, playground):
        self.program, self.made, self.folder, self.illustrated = program, made, folder, illustrated
        self.playground = playground
        self.pictures = Pictures(program, folder / "pictures")
        self.numbers = Numbers(program, folder / "numbers", illustrated)
        self.all = json.loads(subprocess.run([program, "describe", "--json"], capture_output=True, text=True,
                                             check=True).stdout)
        self.solids = {item["name"] for group in self.all["groups"] if group["name"] == "Shapes"
                       for item in group["items"]} | {"union", "intersection", "difference", "merge"}
        self.entries = []  # what the search finds: title, kind, address, text
        self.words = {}    # word -> address
        self.bodies = {}   # file name -> title, HTML

    # ---- pieces

    def entry(self, title, kind, address, text, word=None):
        self.entries.append([title, kind, address, text])
        if word:
            self.words.setdefault(word, address)

    def linked(self, code):
        """Code as HTML, with its known words as links."""
        def link(match):
            word = match.group(0)
            address = self.words.get(word)
            return f'<a href="{address}">{word}</a>' if address else word
        parts = re.split(r"(//[^\n]*|\"[^\"\n]*\")", code)
        return "".join(html.escape(part) if i % 2 else
                       re.sub(r"#?[A-Za-z_][A-Za-z_0-9]*", link, html.escape(part, quote=False))
                       for i, part in enumerate(parts))

    def trying(self, picture):
        """A link to the playground with the scene of a picture."""
        scene, _, files, options = self.pictures.scenes[Path(picture).stem]
        return tried(scene, files) if self.playground and not options else ""

    def figure(self, picture, code):
        return (f'<figure><img src="{picture}" alt="" loading="lazy" width="240" height="180"><figcaption>'
                f"{self.trying(picture)}<code>{self.linked(code)}</code></figcaption></figure>")

    # ---- pages

    def page_name(self, title):
        return re.sub(r"[^a-z]+", "_", title.lower()).strip("_") + ".html"

    def field(self, field):
        takes = field["type"].replace("_", " ")
        for key, words in (("minimum", "from"), ("above", "above"), ("maximum", "to")):
            if key in field:
                takes += f" {words} {field[key]:g}"
        about = "" if field["help"] == field["name"].strip("()") else field["help"]
        default = field.get("default")
        if field["optional"] and isinstance(default, (int, float)) and not isinstance(default, bool):
            takes += f", default {default:g}"
        return (f"<tr><td><code>{html.escape(field['name'])}</code></td><td>{html.escape(takes)}</td>"
                f"<td>{prose(about)}</td></tr>")

    def group(self, group):
        page = self.page_name(group["name"])
        parts = [f"<p>{prose(group['help'])}</p>"]
        if len(group["items"]) > 5:
            parts.append('<p class="contents">' + " ".join(
                f'<a href="#{item["name"]}">{item["name"]}</a>' for item in group["items"]) + "</p>")
        for item in group["items"]:
            name = item["name"]
            self.entry(name, group["name"], f"{page}#{name}", item["help"], name)
            for field in item["fields"]:
                if not field["name"].startswith("("):
                    self.words.setdefault(field["name"], f"{page}#{name}")
            parts.append(f'<h2 id="{name}"><a href="#{name}">{name}</a></h2>\n<p class="usage"><code>'
                         f"{html.escape(item['usage'])}</code></p><p>{prose(item['help'])}</p>")
            parts.append(("gallery", name, item["examples"]))
            if item["fields"]:
                parts.append("<table>" + "".join(self.field(f) for f in item["fields"]) + "</table>")
        self.bodies[page] = (group["name"], parts)

    def library(self):
        page = "candelabra-stdlib.7.html"
        parts = ["<p>The files of the standard library and the macros in them. A scene reads one by "
                 "<code>#include \"colors.inc\"</code>. In examples of lamps <code>Bulb</code> is a small glowing "
                 "ball, in those of random numbers <code>Stream</code> is <code>seed(1)</code>.</p>"]
        for file in self.all["library"]:
            name = file["file"]
            self.entry(name, "library", f"{page}#{name}", file["about"])
            parts.append(f'<h2 id="{name}"><a href="#{name}">{name}</a></h2><p>{prose(file["about"])}</p>')
            for macro in file["macros"]:
                self.entry(macro["name"], name, f"{page}#{macro['name']}", macro["help"], macro["name"])
                parts.append(f'<h3 id="{macro["name"]}"><code>{html.escape(macro["form"])}</code></h3>'
                             f"<p>{prose(macro['help'])}</p>")
                if macro["example"]:
                    parts.append(("macro", name, (macro["example"], macro["value"])))
        self.bodies[page] = ("The library", parts)

    def glossary(self):
        page = "words.html"
        parts = ["<p>Directives, blocks, constants and functions.</p><h2>Words</h2><dl>"]
        for entry in self.all["glossary"]:
            names = [name.lstrip("#") for name in entry["term"].split(", ")]
            for name in names:
                self.entry(name, "word", f"{page}#{names[0]}", entry["help"])
            for name in entry["term"].split(", "):
                self.words.setdefault(name, f"{page}#{names[0]}")
            example = f"<pre>{self.linked(entry['example'])}</pre>" if "example" in entry else ""
            parts.append(f'<dt id="{html.escape(names[0])}"><code>{html.escape(entry["term"])}</code></dt>'
                         f"<dd>{prose(entry['help'])}{example}</dd>")
        parts.append("</dl><h2>Functions</h2><dl>")
        for entry in self.all["functions"]:
            name = entry["term"].split("(")[0]
            self.entry(name, "function", f"{page}#{name}", entry["help"], name)
            parts.append(f'<dt id="{name}"><code>{html.escape(entry["term"])}</code></dt>'
                         f"<dd>{prose(entry['help'])}</dd>")
        parts.append("</dl><h2>Warnings</h2><dl>")
        for entry in self.all["warnings"]:
            self.entry(entry["term"], "warning", f"{page}#{entry['term']}", entry["help"])
            parts.append(f'<dt id="{entry["term"]}"><code>{entry["term"]}</code></dt>'
                         f"<dd>{prose(entry['help'])}</dd>")
        self.bodies[page] = ("Words and functions", parts + ["</dl>"])

    def manual_page(self, page, title):
        done = subprocess.run(["mandoc", "-Thtml", "-O", "fragment,man=%N.%S.html", str(self.made / page)],
                              capture_output=True, text=True, check=True)
        text = re.sub(r'<table class="(head|foot)">.*?</table>', "", done.stdout, flags=re.S)
        text = re.sub(r"<b>(candelabra[a-z-]*)</b>\((\d)\)|<b>(candelabra[a-z-]*)\((\d)\)</b>",
                      lambda m: '<a href="{0}.{1}.html">{0}({1})</a>'.format(m[1] or m[3], m[2] or m[4]), text)
        # The name and what it is for become the head of the page. Heads of sections are read better in small letters.
        text = re.sub(r'<section class="Sh">\s*<h1 class="Sh" id="NAME">.*?</h1>\s*<p class="Pp">(?:\S+ - )?(.*?)'
                      r"</p>\s*</section>",
                      lambda m: f"<h1>{html.escape(title)}</h1><p>{m[1][:1].upper()}{m[1][1:]}.</p>",
                      text, count=1, flags=re.S)
        text = re.sub(r'(<h1 class="Sh" id="[^"]*"><a[^>]*>)([^<]*)(</a>)',
                      lambda m: m[1] + sentence(m[2]) + m[3], text)
        self.entry(title, "page", page + ".html", plain(re.search(r"</h1>\s*<p>(.*?)</p>", text, flags=re.S)[1]))
        for match in re.finditer(r'<h1 class="Sh" id="([^"]*)">.*?>([^<]*)</a></h1>(.*?)(?=<h1 |$)', text, flags=re.S):
            if match[2] not in ("See also", "Description", "Synopsis"):
                self.entry(plain(match[2]), title, f"{page}.html#{match[1]}", plain(match[3]))
        text = self.with_options_found(text, page, title)
        self.bodies[page + ".html"] = (title, ["page", text, page])

    def with_options_found(self, text, page, title):
        """The page with a place at each option, which the search finds."""
        places = {}

        def placed(match):
            name = plain(match[1])
            if not re.match(r"[-+]", name):
                return match[0]
            place = "option" + re.match(r"[-+\w]*", name)[0]
            places[place] = places.get(place, 0) + 1
            if places[place] > 1:
                place += f"_{places[place]}"
            self.entry(name, title, f"{page}.html#{place}", plain(match[2]))
            return f'<dt id="{place}"><b>{html.escape(name)}</b></dt>{match[2]}'
        return re.sub(r"<dt[^>]*>(.*?)</dt>(\s*<dd.*?</dd>)", placed, text, flags=re.S)

    def sources(self, page):
        """The examples of a page with their names, as they are written: mandoc keeps no empty lines."""
        signs = {"e": "\\", "-": "-", "&": "", "(dq": '"', "(aq": "'", "(ti": "~", "(ha": "^", "(ga": "`", "(bu": "*"}
        for match in re.finditer(r"^(?:\.\\\" scene (\S+)\n\.RS\n)?\.nf\n(.*?)^\.fi$", (self.made / page).read_text(),
                                 flags=re.S | re.M):
            lines = re.sub(r"^\.(BI?|BR?|IR?) ", "", match[2], flags=re.M)
            yield match[1], re.sub(r"\\(f[A-Z]|\([a-z]{2}|.)", lambda m: signs.get(m[1], ""), lines).rstrip("\n")

    def with_scenes(self, text, page):
        """The page with links in its examples, and a picture behind each whole scene and each command that develops one
        of them otherwise."""
        sources = list(self.sources(page))
        if len(sources) != len(re.findall("<pre>", text)):
            raise ValueError(f"{page} has {len(sources)} examples, its HTML another number")
        files = [(m[1], html.unescape(m[2])) for m in
                 re.finditer(r"Save this as[^<]*<b>([a-z_.]+)</b>.*?<pre>(.*?)</pre>", text, flags=re.S)]

        scenes = {}

        def developed(code):
            """The pictures of commands such as `candelabra photo.pov --response filmic`."""
            for line in code.splitlines():
                program, scene, *options = [*line.split(), "", "", ""]
                if program == "candelabra" and scene in scenes and options[0] in DEVELOPS:
                    shown = [option for option in options if option and not option.startswith("+O")]
                    yield self.figure(self.pictures.add(scenes[scene], files=files, options=shown), " ".join(shown))

        def block():
            name, code = sources.pop(0)
            scenes[name] = code
            plain = re.match(r"candelabra |error|warning", code) or not re.search(r"[{#]", code)
            result = f"<pre>{html.escape(code) if plain else self.linked(code)}</pre>"
            if code.startswith("#version") and "camera" in code:
                picture = self.pictures.add(code, (400, 300), files)
                result += f'{self.trying(picture)}</div><div><img class="scene" src="{picture}" alt="" width="400" height="300">'
            figures = "".join(developed(code))
            return result + (f'</div><div class="gallery">{figures}' if figures else "")
        return re.sub(r"<pre>.*?</pre>", lambda _: block(), text, flags=re.S)

    # ---- writing

    def part(self, part):
        if isinstance(part, str):
            return part
        kind, about, what = part
        if kind == "gallery":
            scenes = [(frame(line, self.solids), line) for line in what]
            figures = "".join(self.figure(self.pictures.add(scene), line) for scene, line in scenes if scene)
            codes = "".join(f"<pre>{self.linked(line)}</pre>" for scene, line in scenes if not scene)
            return codes + (f'<div class="gallery">{figures}</div>' if figures else "")
        code, value = what
        text = f'<pre>{self.linked(code)}{" &rarr; " + html.escape(value) if value else ""}</pre>'
        visible = not value and re.search(r"\b(object|sphere|box|mesh|cone|intersection|Screen_\w+)\b", code)
        hidden = about in ("math.inc", "strings.inc") or re.search(r"trace\(|Extents\(|#declare Wide", code)
        if visible and not hidden or re.match(r"(Spheroid|Align_Object|Center_Object)\(", code):
            picture = self.pictures.add(macro_frame(about, code))
            return f'{text}<img src="{picture}" alt="" loading="lazy" width="240" height="180">{self.trying(picture)}'
        return text

    def write(self):
        groups = self.all["groups"]
        for group in groups:
            self.group(group)
        self.glossary()
        self.library()
        for page, title in PAGES:
            self.manual_page(page, title)
        for address, title, parts in self.numbers.pages():
            self.entry(title, "Light by numbers", address, plain(parts[0]))
            self.bodies[address] = (title, parts)
        chapters = [(page + ".html", title) for page, title in PAGES[:3]]
        chapters.insert(2, ("numbers.html", "Light by numbers"))
        chapters.append(("candelabra-stdlib.7.html", "The library"))
        reference = [(self.page_name(group["name"]), group["name"]) for group in groups]
        reference += [("words.html", "Words and functions")]
        reference += [(page + ".html", title) for page, title in PAGES[3:]]
        def links(list_of):
            return "".join(f'<li><a href="{address}">{html.escape(title)}</a></li>' for address, title in list_of)
        menu = (f'<nav><a class="title" href="index.html">Candelabra</a><input id="search" type="search" '
                f'placeholder="search" autocomplete="off"><ul id="found"></ul><details open><summary>Contents</summary>'
                f"<ul>{links(chapters)}</ul><ul>{links(reference)}</ul></details></nav>")
        self.bodies["index.html"] = ("Candelabra", [
            f"<p>Version {html.escape(self.all['version'])}. A scene language in the manner of POV-Ray's, and the ray "
            "tracer behind it, for scenes lit by thousands of lamps.</p>"
            f'<img class="front" src="{FRONT.name}" alt="a city at dusk, lit by its windows" width="1280" height="720">'
            "<h2>Learn it</h2><ul>"
            '<li><a href="candelabra-tutorial.7.html">Tutorial</a>: nine chapters, from a first picture to a film</li>'
            '<li><a href="candelabra-lights.7.html">Light</a>: lamps, how bright they are, and noise</li>'
            '<li><a href="numbers.html">Light by numbers</a>: lux, glare and lumens of six scenes, as planners want them</li>'
            '<li><a href="candelabra-povray.7.html">From POV-Ray</a>: what is the same, better and missing</li>'
            '</ul><h2>Look it up</h2><ul><li><a href="candelabra-stdlib.7.html">The library</a>: every macro with an '
            "example</li>" + links(reference) + "</ul>"])
        for address, (title, parts) in self.bodies.items():
            if parts[0] == "page":
                body = self.with_scenes(*parts[1:])
            else:
                body = f"<h1>{html.escape(title)}</h1>" + "\n".join(self.part(part) for part in parts)
            (self.folder / address).write_text(
                f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(title)}</title>'
                '<meta name="viewport" content="width=device-width"><link rel="stylesheet" href="book.css">'
                f'<script src="words.js" defer></script><script src="search.js" defer></script></head><body>{menu}'
                f"<main>{body}</main></body></html>\n")
        (self.folder / "words.js").write_text("const words = " + json.dumps(self.entries, ensure_ascii=False) + ";\n")
        if self.playground:
            shutil.copyfile(self.playground, self.folder / "playground.html")
        for file in (HERE / "book" / "book.css", HERE / "book" / "search.js", FRONT):
            shutil.copyfile(file, self.folder / file.name)
        if self.illustrated:
            self.pictures.render_all()
            self.numbers.tidy()
        failed = self.pictures.failed + self.numbers.failed
        for message in failed:
            print(message, file=sys.stderr)
        print(f"{self.folder / 'index.html'}: {len(self.bodies)} pages, {len(self.pictures.scenes)} pictures")
        return 1 if failed else 0


def main():
    program, made, folder = (Path(word).resolve() for word in sys.argv[1:4])
    folder.mkdir(parents=True, exist_ok=True)
    playground = [word.removeprefix("--playground=") for word in sys.argv if word.startswith("--playground=")]
    if playground and not Path(playground[0]).exists():
        print(f"without `Try it`: src/packaging/wasm/build.sh and src/playground/pack.py have not made {playground[0]}")
        playground = []
    return Book(str(program), made, folder, "--without-pictures" not in sys.argv, *playground or [None]).write()


if __name__ == "__main__":
    sys.exit(main())
