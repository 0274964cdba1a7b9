# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of Candelabra as NumPy arrays.

    import candelabra
    picture = candelabra.render("scene.pov", width=640, declare={"N": 100}, layers=["depth", "lights"])
    picture.light               # radiance: height x width x 3, float32
    picture.layers["depth"]     # height x width
    picture.lights["Lamp"]      # what the lamps of the statement Lamp contribute

Keywords are the long options of the command with `_` in the place of `-`; `options()` lists them.
Errors are raised as SceneError, and warnings are SceneWarning. See candelabra-python(3).
"""

from __future__ import annotations

import dataclasses
import difflib
import functools
import json
import os
import sys
import warnings
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence, Union

import numpy

from . import _core

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import FilmOptions, Options

__version__: str = _core.version

Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[float], Optional[bool]]


@dataclasses.dataclass(frozen=True)
class Diagnostic:
    """A message about a scene or its options."""

    severity: str  #: "error", "warning" or "note"
    rule: str  #: kind of problem, such as "out-of-range"
    message: str
    file: str | None
    line: int | None  #: from 1
    column: int | None  #: from 1, in characters
    end_line: int | None
    end_column: int | None  #: behind the last character
    label: str  #: about the place
    notes: tuple[str, ...]
    help: str  #: the way out
    text: str  #: all of it, with an excerpt of the file

    def __str__(self) -> str:
        return self.text


class SceneError(Exception):
    """A scene or an option has errors, or a file cannot be used.

    `file`, `line`, `column` and `rule` are those of the first error.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic]):
        super().__init__("\n".join(each.text for each in diagnostics))
        self.diagnostics = tuple(diagnostics)

    def __reduce__(self) -> Any:
        return SceneError, (self.diagnostics,)

    @property
    def file(self) -> str | None:
        return self.diagnostics[0].file

    @property
    def line(self) -> int | None:
        return self.diagnostics[0].line

    @property
    def column(self) -> int | None:
        return self.diagnostics[0].column

    @property
    def rule(self) -> str:
        return self.diagnostics[0].rule


class SceneWarning(UserWarning):
    """A probable mistake in a scene."""

    def __init__(self, diagnostic: Diagnostic):
        super().__init__(diagnostic.text)
        self.diagnostic = diagnostic


class Cancelled(Exception):
    """`progress` has returned False."""


class Picture:
    """A rendered picture. Its arrays are those that the renderer has filled, without a copy."""

    light: numpy.ndarray  #: radiance, linear: height x width x 3, float32
    pixels: numpy.ndarray  #: as a display shows it: height x width x 3 (4 with alpha), uint8
    alpha: numpy.ndarray | None  #: opacity, 0 to 1, by which `light` has been multiplied
    layers: dict[str, numpy.ndarray]  #: by the names of OpenEXR files, such as "depth"
    light_report: list[dict[str, Any]]  #: of light_report=True, the brightest lamps first
    printed: str  #: what the scene has printed
    film: str  #: settings of the film; empty: none
    description: str  #: program, scene, options and command; kept in files

    def __init__(self, layers: Mapping[str, numpy.ndarray], pixels: numpy.ndarray | None, film: str,
                 description: str, light_report: list[dict[str, Any]] | None = None, printed: str = ""):
        self.layers = dict(layers)
        self.light = self.layers.pop("")
        self.alpha = self.layers.pop("A", None)
        self.film = film
        self.description = description
        self.light_report = light_report or []
        self.printed = printed
        self.pixels = self._developed() if pixels is None else pixels

    @property
    def width(self) -> int:
        return int(self.light.shape[1])

    @property
    def height(self) -> int:
        return int(self.light.shape[0])

    @property
    def lights(self) -> dict[str, numpy.ndarray]:
        """The light of each statement that makes lamps, and "rest"; of layers="lights"."""
        return {name[6:]: each for name, each in self.layers.items() if name.startswith("light.")}

    def develop(self, layer: str = "", lights: Mapping[str, Any] | None = None,
                **options: Unpack[FilmOptions]) -> Picture:
        """Returns the picture under another film (exposure=1), with other powers and colours of lamps
        (lights={"Lamp": 0.5, "Sign": "#ff8800"}), or of another layer of colours."""
        before = f"{layer}.light." if layer == "denoised" else "light."
        light = self.light if not layer else self._layer(layer)
        smooth = self.layers.get("film" if not layer else f"{layer}.film")
        for name, value in (lights or {}).items():
            if layer not in ("", "denoised"):
                raise ValueError(f"lamps light the picture, and not its layer {layer!r}")
            change = (numpy.asarray(_factor(value)) - 1).astype(numpy.float32)
            if change.any():
                light = light + change * self._layer(before + name)
                smooth = None
        layers = {**self.layers, "": light}
        if self.alpha is not None:
            layers["A"] = self.alpha
        for name in ("film", f"{layer}.film"):
            layers.pop(name, None)
        if smooth is not None:
            layers["film"] = smooth
        pixels = self._developed(light, smooth, **options)
        return Picture(layers, pixels, self.film, self.description)

    def save(self, path: Path) -> None:
        """Writes `pixels` to a file for displays: png, jpg, tiff, webp, bmp, ppm or tga by its ending.

        render(..., output="scene.exr") writes the files of the command."""
        encoded = self._encoded(os.path.splitext(os.fspath(path))[1].lstrip("."))
        with open(path, "wb") as file:
            file.write(encoded)

    def _encoded(self, ending: str) -> bytes:
        encoded, reports = _core.encode(self.pixels, ending, self.description)
        _heed(reports)
        return encoded

    def _repr_png_(self) -> bytes:
        return self._encoded("png")

    def __repr__(self) -> str:
        named = ", ".join(self.layers)
        return f"<candelabra.Picture {self.width}x{self.height}{': ' if named else ''}{named}>"

    def _layer(self, name: str) -> numpy.ndarray:
        if name not in self.layers:
            known = ", ".join(self.layers) or "none"
            raise KeyError(f"there is no layer {name!r}; there are: {known}")
        return self.layers[name]

    def _developed(self, light: numpy.ndarray | None = None, smooth: numpy.ndarray | None = None,
                   **options: Any) -> numpy.ndarray:
        if light is None:
            light, smooth = self.light, self.layers.get("film")
        pixels, reports = _core.develop(light, smooth, self.alpha, self.film, "the picture",
                                        _words(options, _of_film))
        _heed(reports)
        return pixels


class Lamps:
    """The light of each lamp in a file of keep_lights, for pictures under any powers and colours.

    `smooth`: how far around a pixel, in pixels, the light of crowds of lamps is smoothed."""

    names: dict[str, int]  #: names of lamps, and how many have each

    def __init__(self, path: Path, *, smooth: int = 0, threads: int = 0):
        if not 0 <= smooth <= 100:
            raise ValueError("smooth is a number of pixels from 0 to 100")
        self._kept = _core.KeptLamps(os.fsencode(path), smooth, threads)
        _heed(self._kept.reports)
        self.names = self._kept.groups

    def relight(self, set: Mapping[str, Any] | None = None, **options: Unpack[FilmOptions]) -> Picture:
        """Returns the picture with factors on the power of lamps: {"Facade[0..9]": 0.2, "Sign":
        "#ff8800"}. An array has a number or a colour for each lamp of the name. 1: as rendered."""
        factors = numpy.ones((sum(self.names.values()), 3))
        for name, value in (set or {}).items():
            places, reports = self._kept.places(os.fsencode(name))
            _heed(reports)
            each = numpy.asarray(_factor(value))
            factors[places] = each[:, None] if each.ndim == 1 and len(each) == len(places) != 3 else each
        if not (numpy.isfinite(factors).all() and (factors >= 0).all()):
            raise ValueError("powers of lamps are numbers from 0 on")
        layers = {"": self._kept.picture(factors)}
        if self._kept.alpha is not None:
            layers["A"] = self._kept.alpha
        picture = Picture.__new__(Picture)
        picture.alpha = layers.get("A")
        picture.film = self._kept.film
        pixels = picture._developed(layers[""], **options)
        return Picture(layers, pixels, self._kept.film, self._kept.origin)


def render(scene: Path | None = None, *, text: str | None = None, name: str = "text",
           progress: Progress | None = None, print: Callable[[str], object] | None = None,
           **options: Unpack[Options]) -> Picture:
    """Renders a scene.

    `progress` is called with the completed fraction, and cancels by returning False. `print` gets what
    the scene prints. `text` is the text of a scene without a file, and `name` its name in messages."""
    return _rendered(scene, text, name, progress, print, options)


def render_text(text: str, *, name: str = "text", progress: Progress | None = None,
                print: Callable[[str], object] | None = None, **options: Unpack[Options]) -> Picture:
    """Renders the text of a scene; see render()."""
    return _rendered(None, text, name, progress, print, options)


def measure(scene: Path | None = None, *, text: str | None = None, name: str = "text",
            progress: Progress | None = None, print: Callable[[str], object] | None = None,
            **options: Unpack[Options]) -> dict[str, Any]:
    """Measures the light at the meters of a scene, and returns what --measure light.json writes."""
    return json.loads(_run("measure", scene, text, name, progress, print, options)["table"])


def light_balance(scene: Path | None = None, *, text: str | None = None, name: str = "text",
                  progress: Progress | None = None, print: Callable[[str], object] | None = None,
                  **options: Unpack[Options]) -> dict[str, Any]:
    """Follows the light of all lamps to its ends, and returns what --light-balance light.json writes."""
    return json.loads(_run("light_balance", scene, text, name, progress, print, options)["table"])


def check(scene: Path | None = None, *, text: str | None = None, name: str = "text",
          **options: Unpack[Options]) -> list[Diagnostic]:
    """Returns the errors and warnings of a scene, which is not rendered."""
    words = _scene_words(scene, text, _words(options, _of_runs))
    made = _core.run(words, "check", _bytes(text), name, _library(), None)
    return _diagnostics(made["reports"])


def read(path: Path) -> Picture:
    """Reads an OpenEXR file with its layers, as render(..., output="scene.exr") writes it."""
    layers, film, description, reports = _core.read(os.fsencode(path))
    _heed(reports)
    if "" not in layers:
        raise ValueError(f"{os.fspath(path)!r} has no colours")
    return Picture(layers, None, film, description)


def develop(picture: Picture | Path, layer: str = "", lights: Mapping[str, Any] | None = None,
            **options: Unpack[FilmOptions]) -> Picture:
    """Develops a picture, or the light in an OpenEXR file; see Picture.develop()."""
    made = picture if isinstance(picture, Picture) else read(picture)
    return made.develop(layer, lights, **options)


def relight(lamps: Lamps | Path, set: Mapping[str, Any] | None = None,
            **options: Unpack[FilmOptions]) -> Picture:
    """Returns the picture of a file of keep_lights with factors on its lamps; see Lamps.relight()."""
    return (lamps if isinstance(lamps, Lamps) else Lamps(lamps)).relight(set, **options)


def options() -> dict[str, str]:
    """Returns the keywords of render() with their help."""
    return {name: row["help"] for name, row in _table().items() if _of_runs(name, row)}


# --- options as words of the command ---


@functools.lru_cache(None)
def _table() -> dict[str, dict[str, Any]]:
    rows = json.loads(_core.options())
    return {row["long"].replace("-", "_"): row for row in rows if "long" in row}


def _of_runs(name: str, row: Mapping[str, Any]) -> bool:
    """Whether the option is one of render() and its relatives: Python has its own ways to make
    animations, to go on, to print and to run commands, and the sandbox would close the whole process."""
    if row["group"] in ("animation", "states", "tasks", "console", "commands"):
        return name in ("warn", "until")
    return name not in ("input_file_name", "include_ini", "create_ini", "output_to_file", "sandbox")


def _of_film(name: str, row: Mapping[str, Any]) -> bool:
    return row["group"] == "film" or name == "work_threads" or name == "threads"


def _bytes(text: str | None) -> bytes | None:
    return None if text is None else os.fsencode(text)


def _words(given: Mapping[str, Any], offered: Callable[[str, Mapping[str, Any]], bool]) -> list[bytes]:
    words = []
    for name, value in given.items():
        row = _table().get(name)
        if row is None or not offered(name, row):
            known = [each for each, row in _table().items() if offered(each, row)]
            near = difflib.get_close_matches(name, known, 1)
            hint = f"; did you mean `{near[0]}`?" if near else ""
            raise TypeError(f"there is no option `{name}` here{hint}")
        words += [os.fsencode(word) for word in _words_of(row, value)]
    return words


def _words_of(row: Mapping[str, Any], value: Any) -> list[str]:
    option = "--" + row["long"]
    if value is None:
        return []
    if isinstance(value, (bool, numpy.bool_)):
        if row["type"] == "boolean" and (value or "keyword" not in row):
            return [option] if value else []
        return [f"{option}={'on' if value else 'off'}"]
    if isinstance(value, Mapping):
        return [f"{option}={name}={_declared(each)}" for name, each in value.items()]
    if isinstance(value, (list, tuple)):
        values = [_text(each) for each in value]
        repeated = row["type"] == "texts" or row["long"] == "declare"
        return [f"{option}={each}" for each in values] if repeated else [f"{option}={','.join(values)}"]
    return [f"{option}={_text(value)}"]


def _text(value: Any) -> str:
    if isinstance(value, numpy.generic):
        value = value.item()
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, (int, float)):
        return repr(value)
    raise TypeError(f"{value!r} is no value of an option")


def _declared(value: Any) -> str:
    """A value as Declare=name=value has it."""
    if isinstance(value, (bool, numpy.bool_)):
        return "on" if value else "off"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, (list, tuple, numpy.ndarray)):
        return "<" + ", ".join(_text(each) for each in value) + ">"
    return _text(value)


def _scene_words(scene: Path | None, text: str | None, words: list[bytes]) -> list[bytes]:
    if (scene is None) == (text is None):
        raise TypeError("a scene is a file or a text")
    path = b"-" if scene is None else os.fsencode(scene)
    return [*words, b"--", b"./-" if scene is not None and path == b"-" else path]


def _factor(value: Any) -> Any:
    """Powers and colours as numbers."""
    if not isinstance(value, str):
        return value
    factor = _core.factor(value)
    if factor is None:
        raise ValueError(f"{value!r} is no power, no colour such as #ff8800, and not both: 0.5,#ff8800")
    return factor


# --- runs ---


@functools.lru_cache(None)
def _library() -> str:
    """The folder of the standard library: that of a variable, of a wheel, or of the system."""
    chosen = os.environ.get("CANDELABRA_STDLIB")
    if chosen:
        return chosen
    own = os.path.dirname(os.path.abspath(__file__))
    share = os.path.join("share", "candelabra", "stdlib")
    places = [os.path.join(own, "stdlib"), os.path.join(own, *[os.pardir] * 4, share)]
    places += [os.path.join(root, share) for root in (sys.prefix, "/usr", "/usr/local")]
    for place in places:
        if os.path.isfile(os.path.join(place, "colors.inc")):
            return os.path.normpath(place)
    return ""


def _rendered(scene: Path | None, text: str | None, name: str, progress: Progress | None,
              printer: Callable[[str], object] | None, options: Mapping[str, Any]) -> Picture:
    made = _run("render", scene, text, name, progress, printer, options, level=5)
    return Picture(made["layers"], made["pixels"], made["film"], made["description"],
                   made["light_report"], made["printed"])


def _run(task: str, scene: Path | None, text: str | None, name: str, progress: Progress | None,
         printer: Callable[[str], object] | None, options: Mapping[str, Any],
         level: int = 4) -> dict[str, Any]:
    if task != "measure" and "until" in options:
        raise TypeError("`until` is the error at which measure() ends")
    words = _scene_words(scene, text, _words(options, _of_runs))
    last = -1.0

    def tick(done: float, news: bytes) -> bool:
        nonlocal last
        if printer and news:
            printer(news.decode(errors="replace"))
        if progress and done != last:
            last = done
            return progress(done) is not False
        return True

    made = _core.run(words, task, _bytes(text), name, _library(), tick if progress or printer else None)
    _heed(made["reports"], level)
    if made["status"] == 4:
        raise Cancelled("the run was cancelled")
    printed = made["printed"].decode(errors="replace")
    return {**(made["picture"] or {}), "table": made["table"], "printed": printed}


def _diagnostics(reports: Sequence[tuple[str, bytes]]) -> list[Diagnostic]:
    made = []
    for report, text in reports:
        told = json.loads(report)
        place = told["place"] or {}
        made.append(Diagnostic(told["severity"], told["name"], told["message"], place.get("file"), place.get("line"),
                               place.get("column"), place.get("end_line"), place.get("end_column"), told["label"],
                               tuple(told["notes"]), told["help"], text.decode(errors="replace").rstrip()))
    return made


def _heed(reports: Sequence[tuple[str, bytes]], level: int = 3) -> None:
    """Raises errors, and passes warnings on to the caller of our caller."""
    if not reports:
        return
    told = _diagnostics(reports)
    errors = [each for each in told if each.severity == "error"]
    for each in told:
        if each.severity == "warning":
            warnings.warn(SceneWarning(each), stacklevel=level)
    if errors:
        raise SceneError(errors)
