# SPDX-License-Identifier: GPL-3.0-or-later
"""The module of Python against the command: the same pictures, tables and messages.

PYTHONPATH names the folder of the module, and CANDELABRA the program.
"""

import gc
import json
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy

import candelabra

PROGRAM = os.environ["CANDELABRA"]
LIT = """#version 3.7;
#ifndef (N) #declare N = 2; #end
#ifndef (Where) #declare Where = <0, 2, 0>; #end
global_settings { assumed_gamma 1 integrator { path_traced } }
camera { location <0, 1, -5> look_at 0 }
#declare Lamp = sphere { 0, 0.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 3 } }
object { Lamp translate Where }
#declare Sign = sphere { <2, 1, 0>, 0.4 pigment { rgb <1, 0.5, 0.2> } finish { ambient 0 diffuse 0 emission N } }
object { Sign }
plane { y, -1 pigment { checker rgb 1, rgb <1, 0, 0> } finish { ambient 0 } }
meter { "desk" corner <-1, -0.99, -1> along 2*x across 2*z counts <2, 2> }
"""
SMALL = {"width": 16, "height": 12, "samples": 2}


class Folder(unittest.TestCase):
    """A test in a folder of its own, which holds lit.pov."""

    def setUp(self):
        self.before = os.getcwd()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, self.before)
        os.chdir(folder.name)
        catcher = warnings.catch_warnings()
        catcher.__enter__()
        self.addCleanup(catcher.__exit__, None, None, None)
        warnings.simplefilter("ignore", candelabra.SceneWarning)
        pathlib.Path("lit.pov").write_text(LIT)

    def command(self, *words):
        return subprocess.run([PROGRAM, *words], check=True, capture_output=True, text=True).stdout

    def rendered(self, *words):
        return self.command("lit.pov", "+W16", "+H12", "--samples", "2", *words)


class Pictures(Folder):
    def test_a_picture_is_that_of_the_command(self):
        picture = candelabra.render("lit.pov", **SMALL)
        self.rendered("-o", "command.png")
        picture.save("python.png")
        self.assertEqual(pathlib.Path("python.png").read_bytes(), pathlib.Path("command.png").read_bytes())
        self.assertEqual(picture._repr_png_(), pathlib.Path("command.png").read_bytes())
        self.assertEqual((picture.width, picture.height), (16, 12))
        self.assertEqual((picture.light.shape, picture.light.dtype), ((12, 16, 3), numpy.float32))
        self.assertEqual((picture.pixels.shape, picture.pixels.dtype), ((12, 16, 3), numpy.uint8))
        self.assertGreater(picture.light.max(), 1)
        self.assertIn("16x12", repr(picture))

    def test_arrays_show_what_the_renderer_has_filled(self):
        picture = candelabra.render("lit.pov", width=640, height=480, samples=1, layers=["depth", "normal"])
        for array in (picture.light, picture.pixels, picture.layers["depth"], picture.layers["normal"]):
            self.assertEqual(type(array.base).__name__, "PyCapsule")
            self.assertFalse(array.flags.owndata)
            self.assertTrue(array.flags.c_contiguous and array.flags.writeable)
        light = picture.light
        first = light.copy()
        del picture
        gc.collect()
        numpy.testing.assert_array_equal(light, first)

    def test_files_of_the_command_are_written_too(self):
        picture = candelabra.render("lit.pov", output="python.exr", layers="all", **SMALL)
        self.rendered("-o", "command.exr", "--layers", "all")
        self.assertEqual(pathlib.Path("python.exr").read_bytes(), pathlib.Path("command.exr").read_bytes())
        read = candelabra.read("python.exr")
        numpy.testing.assert_array_equal(read.light, picture.light)
        self.assertEqual(set(read.layers), set(picture.layers))
        for name, layer in picture.layers.items():
            numpy.testing.assert_array_equal(read.layers[name], layer, name)
        numpy.testing.assert_array_equal(read.pixels, picture.pixels)
        self.assertEqual(read.description, picture.description)
        candelabra.render("lit.pov", **SMALL)
        self.assertEqual(sorted(os.listdir()), ["command.exr", "lit.pov", "python.exr"])

    def test_layers_are_arrays_by_name(self):
        picture = candelabra.render("lit.pov", layers=["depth", "lights"], output_alpha=True, **SMALL)
        self.assertEqual(set(picture.lights), {"Lamp", "Sign", "rest"})
        self.assertEqual(picture.layers["depth"].shape, (12, 16))
        numpy.testing.assert_allclose(sum(picture.lights.values()), picture.light, atol=1e-5)
        self.assertEqual(picture.alpha.shape, (12, 16))
        self.assertEqual(picture.pixels.shape, (12, 16, 4))
        picture.save("python.png")
        self.rendered("-o", "command.png", "+UA", "--layers", "depth,lights")
        self.assertEqual(pathlib.Path("python.png").read_bytes(), pathlib.Path("command.png").read_bytes())
        picture.save("python.jpg")
        with self.assertRaises(ValueError):
            picture.save("python.exr")
        self.assertFalse(os.path.exists("python.exr"))

    def test_a_text_is_a_scene(self):
        picture = candelabra.render_text(LIT, **SMALL)
        numpy.testing.assert_array_equal(picture.light, candelabra.render("lit.pov", **SMALL).light)
        for scene in ({}, {"scene": "lit.pov", "text": LIT}):
            with self.assertRaises(TypeError):
                candelabra.render(**scene)

    def test_the_library_is_there(self):
        picture = candelabra.render_text('#include "colors.inc"\ncamera { location -z }\nbackground { Red }',
                                         width=4, height=4)
        self.assertEqual(picture.pixels[0, 0].tolist(), [255, 0, 0])

    def test_what_the_scene_prints(self):
        told = []
        text = '#debug "one\\n"\n#debug "two\\n"\ncamera {} background { rgb 1 }'
        picture = candelabra.render_text(text, print=told.append, **SMALL)
        self.assertEqual((picture.printed, "".join(told)), ("one\ntwo\n", "one\ntwo\n"))

    def test_draft_and_denoise(self):
        picture = candelabra.render("lit.pov", denoise=True, **SMALL)
        self.assertEqual(picture.layers["denoised"].shape, (12, 16, 3))
        draft = candelabra.render("lit.pov", draft=True, width=16, height=12)
        self.command("lit.pov", "+W16", "+H12", "--draft", "-o", "command.png")
        draft.save("draft.png")
        self.assertEqual(pathlib.Path("draft.png").read_bytes(),
                         pathlib.Path("command.draft.png").read_bytes())


class Options(Folder):
    def test_keywords_are_the_options_of_the_command(self):
        known = candelabra.options()
        self.assertIn("light_sampler", known)
        self.assertIn("width of the picture", known["width"])
        for name in ("frames", "sheet", "check", "measure", "checkpoint", "stats", "allow_commands", "sandbox"):
            self.assertNotIn(name, known)
            with self.assertRaises(TypeError):
                candelabra.render("lit.pov", **{name: "1"})
        with self.assertRaisesRegex(TypeError, "`widht`.*`width`"):
            candelabra.render("lit.pov", widht=3)
        with self.assertRaisesRegex(TypeError, "until"):
            candelabra.render("lit.pov", until="2%")

    def test_values_become_words(self):
        cases = [({"antialias": False}, ["-A"]), ({"antialias": 0.05}, ["+A0.05"]),
                 ({"declare": {"N": 5, "Where": (1, 2, 0)}}, ["Declare=N=5", "Declare=Where=<1, 2, 0>"]),
                 ({"declare": {"N": numpy.float64(1.5)}}, ["Declare=N=1.5"]),
                 ({"film": True, "exposure": -1}, ["--film", "on", "--exposure", "-1"]),
                 ({"film": None, "seed": numpy.int32(3)}, ["--seed", "3"]),
                 ({"library_path": ["/tmp", pathlib.Path("/usr")]}, ["+L/tmp", "+L/usr"]),
                 ({"start_column": 3, "grayscale_output": False}, ["+SC3"])]
        for number, (options, words) in enumerate(cases):
            with self.subTest(options):
                picture = candelabra.render("lit.pov", **SMALL, **options)
                self.rendered("-o", f"{number}.png", *words)
                picture.save("python.png")
                self.assertEqual(pathlib.Path("python.png").read_bytes(),
                                 pathlib.Path(f"{number}.png").read_bytes())
        with self.assertRaises(TypeError):
            candelabra.render("lit.pov", width=object())

    def test_declared_texts_may_have_quotes(self):
        picture = candelabra.render_text("#debug Word camera {} background { rgb 1 }", width=4, height=4,
                                         declare={"Word": 'say "a", =<b>', "On": True})
        self.assertEqual(picture.printed.rstrip(), 'say "a", =<b>')

    def test_types_are_told(self):
        folder = pathlib.Path(candelabra.__file__).parent
        types = (folder / "_options.pyi").read_text()
        self.assertIn("    width: int\n", types)
        self.assertTrue((folder / "py.typed").exists())
        for name in candelabra.options():
            self.assertIn(f"    {name}: ", types)


class Problems(Folder):
    def test_errors_have_places(self):
        with self.assertRaises(candelabra.SceneError) as caught:
            candelabra.render_text("camera {}\nsphere { 0, red }\n", name="ball", **SMALL)
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), ("ball", 2, 13))
        self.assertEqual(error.rule, error.diagnostics[0].rule)
        self.assertIn("ball:2:13", str(error))
        self.assertEqual(error.diagnostics[0].severity, "error")
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual(again.diagnostics, error.diagnostics)

    def test_options_and_files_have_errors_too(self):
        for options, rule in (({"width": -3}, "option"), ({"layers": "dept"}, "option"),
                              ({"light_sampler": "none_such"}, "option")):
            with self.assertRaises(candelabra.SceneError) as caught:
                candelabra.render("lit.pov", **options)
            self.assertEqual((caught.exception.rule, caught.exception.line), (rule, None))
        with self.assertRaises(candelabra.SceneError) as caught:
            candelabra.render("lid.pov")
        self.assertEqual(caught.exception.rule, "io")
        self.assertIn("lit.pov", caught.exception.diagnostics[0].help)
        with self.assertRaises(candelabra.SceneError):
            candelabra.render("lit.pov", output="/no/such/folder/a.png", **SMALL)

    def test_warnings_are_those_of_python(self):
        text = "camera {}\n#declare A = 1/0;\nbackground { rgb 1 }\nsphere { 0, 1 }\n"
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            candelabra.render_text(text, **SMALL)
        self.assertTrue(caught)
        self.assertTrue(all(issubclass(each.category, candelabra.SceneWarning) for each in caught))
        self.assertIn("division-by-zero", [each.message.diagnostic.rule for each in caught])
        self.assertEqual(caught[0].message.diagnostic.line, 2)
        self.assertEqual(os.path.basename(caught[0].filename), "module_test.py")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(candelabra.SceneWarning):
                candelabra.render_text(text, **SMALL)
            candelabra.render_text(text, warn="none", **SMALL)

    def test_a_check_renders_nothing(self):
        self.assertEqual(candelabra.check("lit.pov"), [])
        told = candelabra.check(text="sphere { 0, red }")
        self.assertEqual([each.severity for each in told if each.severity == "error"], ["error"])


class Work(Folder):
    LONG = {"width": 640, "height": 480, "samples": 10000}

    def test_progress_goes_from_0_to_1(self):
        told = []
        candelabra.render("lit.pov", width=160, height=120, samples=64, progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertTrue(all(0 <= each <= 1 for each in told))

    def test_false_cancels(self):
        begun = time.monotonic()
        with self.assertRaises(candelabra.Cancelled):
            candelabra.render("lit.pov", progress=lambda done: False, **self.LONG)
        self.assertLess(time.monotonic() - begun, 20)
        self.assertEqual(os.listdir(), ["lit.pov"])

    def test_an_endless_loop_is_cancelled(self):
        begun = time.monotonic()
        with self.assertRaises(candelabra.Cancelled):
            candelabra.render_text("#while (1) #end", progress=lambda done: False)
        self.assertLess(time.monotonic() - begun, 5)

    def test_an_error_of_the_callback_cancels(self):
        def fails(done):
            raise KeyError("mine")
        with self.assertRaisesRegex(KeyError, "mine"):
            candelabra.render("lit.pov", progress=fails, **self.LONG)

    def test_control_c_cancels(self):
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            candelabra.render("lit.pov", **self.LONG)
        candelabra.render("lit.pov", **SMALL)

    def test_other_threads_of_python_run_meanwhile(self):
        counted = [0]
        done = threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.001)
        worker = threading.Thread(target=count)
        worker.start()
        candelabra.render("lit.pov", width=320, height=240, samples=64, time=0.5)
        done.set()
        worker.join()
        self.assertGreater(counted[0], 20)

    def test_several_pictures_at_once(self):
        alone = [candelabra.render("lit.pov", declare={"N": n}, **SMALL).light for n in range(4)]
        made = [None] * 4

        def work(n):
            made[n] = candelabra.render("lit.pov", declare={"N": n}, **SMALL).light
        workers = [threading.Thread(target=work, args=(n,)) for n in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for one, other in zip(alone, made):
            numpy.testing.assert_array_equal(one, other)
        self.assertFalse((alone[0] == alone[3]).all())

    def test_the_memory_of_the_process_is_not_limited(self):
        import resource
        before = resource.getrlimit(resource.RLIMIT_DATA)
        candelabra.render("lit.pov", memory="2G", **SMALL)
        self.assertEqual(resource.getrlimit(resource.RLIMIT_DATA), before)
        with self.assertRaises(candelabra.SceneError):
            candelabra.render("lit.pov", memory="1M", width=4000, height=4000)


class Tables(Folder):
    def test_meters_are_a_dict(self):
        told = candelabra.measure("lit.pov", **{**SMALL, "samples": 64})
        self.rendered("--measure", "m.json", "--samples", "64")
        self.assertEqual(told, json.loads(pathlib.Path("m.json").read_text()))
        self.assertEqual(told["meters"][0]["name"], "desk")
        self.assertEqual(candelabra.measure(text=LIT, **{**SMALL, "samples": 64}), told)
        candelabra.measure("lit.pov", until="lux 20%")
        with self.assertRaises(candelabra.SceneError):
            candelabra.measure(text="camera {} sphere { 0, 1 finish { emission 1 } }")
        with self.assertRaises(candelabra.SceneError):
            candelabra.measure("lit.pov", denoise=True)

    def test_the_balance_of_light_is_a_dict(self):
        told = candelabra.light_balance("lit.pov", **SMALL)
        self.rendered("--light-balance", "b.json")
        self.assertEqual(told, json.loads(pathlib.Path("b.json").read_text()))

    def test_the_light_report(self):
        picture = candelabra.render("lit.pov", light_report=True, declare={"N": 0.1}, **SMALL)
        report = picture.light_report
        self.assertEqual([row["name"] for row in report], ["Lamp", "Sign"])
        self.assertEqual((report[0]["file"], report[0]["line"]), ("lit.pov", 7))
        self.assertAlmostEqual(sum(row["light"] for row in report), 1)
        self.assertEqual(report[0]["lights"], 1)
        self.assertEqual(candelabra.render("lit.pov", **SMALL).light_report, [])


class Films(Folder):
    def test_a_picture_is_developed_again(self):
        picture = candelabra.render("lit.pov", film=True, **SMALL)
        self.rendered("-o", "light.exr", "--film", "on")
        self.command("develop", "light.exr", "-o", "command.png", "--exposure", "2", "--response", "filmic")
        developed = picture.develop(exposure=2, response="filmic")
        numpy.testing.assert_array_equal(developed.pixels, candelabra.develop(
            "light.exr", exposure=2, response="filmic").pixels)
        developed.save("python.png")
        self.assertEqual(self.pixels("python.png"), self.pixels("command.png"))
        with self.assertRaises(TypeError):
            picture.develop(samples=3)
        with self.assertRaises(candelabra.SceneError):
            picture.develop(response="none_such")

    def pixels(self, name):
        """The compressed pixels of a PNG file: its IDAT."""
        bytes_of = pathlib.Path(name).read_bytes()
        at = bytes_of.index(b"IDAT")
        return bytes_of[at:]

    def test_lamps_are_dimmed_afterwards(self):
        picture = candelabra.render("lit.pov", layers="lights", **SMALL)
        dark = picture.develop(lights={"Lamp": 0, "Sign": "0.5,#ff0000"})
        expected = picture.lights["rest"] + picture.lights["Sign"] * numpy.float32([0.5, 0, 0])
        numpy.testing.assert_allclose(dark.light, expected, atol=1e-5)
        with self.assertRaises(KeyError):
            picture.develop(lights={"Lmp": 0})
        with self.assertRaises(ValueError):
            picture.develop(lights={"Lamp": "#zz"})

    def test_kept_light_is_lit_anew(self):
        picture = candelabra.render("lit.pov", keep_lights="lit.lights", **SMALL)
        lamps = candelabra.Lamps("lit.lights")
        self.assertEqual(lamps.names, {"Lamp": 1, "Sign": 1})
        numpy.testing.assert_allclose(lamps.relight().light, picture.light, atol=1e-3)
        self.command("relight", "lit.lights", "-o", "command.png", "--set", "Lamp=0.5,#ff8800", "--exposure", "1")
        made = candelabra.relight("lit.lights", {"Lamp": "0.5,#ff8800"}, exposure=1)
        made.save("python.png")
        self.assertEqual(self.pixels("python.png"), self.pixels("command.png"))
        same = lamps.relight({"Lamp": numpy.array([0.25]), "*": 0.25, "Sign": (0.25, 0.25, 0.25)})
        numpy.testing.assert_allclose(same.light, 0.25 * picture.light, atol=1e-3)
        for wrong in ({"Lmp": 1}, {"Lamp[7]": 1}):
            with self.assertRaises(candelabra.SceneError):
                lamps.relight(wrong)
        for wrong in ({"Lamp": -1}, {"Lamp": float("nan")}, {"Lamp": [1, 2, 3, 4, 5]}, {"Lamp": "blue"}):
            with self.assertRaises(ValueError):
                lamps.relight(wrong)
        with self.assertRaises(candelabra.SceneError):
            candelabra.Lamps("lit.pov")


class Hostile(Folder):
    def test_wrong_arrays_are_refused(self):
        core = candelabra._core
        flat = numpy.zeros((4, 4), numpy.float32)
        picture = numpy.zeros((4, 4, 3), numpy.float32)
        for call in (lambda: core.develop(flat, None, None, "", "", []),
                     lambda: core.develop(picture, None, flat[:2], "", "", []),
                     lambda: core.develop(picture, picture[:2], None, "", "", []),
                     lambda: core.encode(numpy.zeros((4, 4), numpy.uint8), "png", ""),
                     lambda: core.encode(numpy.zeros((4, 4, 9), numpy.uint8), "png", ""),
                     lambda: core.encode(numpy.zeros((0, 4, 3), numpy.uint8), "png", ""),
                     lambda: core.encode(numpy.zeros((4, 4, 3), numpy.uint8), "exe", ""),
                     lambda: core.develop(numpy.zeros((0, 0, 3), numpy.float32), None, None, "", "", [])):
            with self.assertRaises(ValueError):
                call()

    def test_files_that_are_none(self):
        pathlib.Path("broken.exr").write_bytes(b"nothing")
        with self.assertRaises(candelabra.SceneError):
            candelabra.read("broken.exr")
        with self.assertRaises(candelabra.SceneError):
            candelabra.develop("missing.exr")


if __name__ == "__main__":
    sys.exit(unittest.main())
