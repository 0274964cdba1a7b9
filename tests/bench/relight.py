#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error and the cost of pictures that are relit: relight.py PROGRAM [KIND [LAMPS [SAMPLES [TIMES]]]]

A facade of LAMPS lamps (a square number, 2500) stands before a street. KIND is `direct`, `bounces` or `air`. The light is kept
in one render with all lamps on and SAMPLES samples a pixel (32), and relit by the frames of five films. Each frame is compared
with a render of the same frame with TIMES (8) times the samples, beside a fresh render with SAMPLES samples: root of the mean
square of the error, in percent of the mean. The own error of relighting is that against the picture whose light was kept,
times the ratio of two renders with many samples, of the frame and with all lamps on; it has the noise of both.
"""
import math
import random
import resource
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SCENE = """#version 3.7; global_settings {{ assumed_gamma 1 {settings} }}
camera {{ location <0, 7, -1> look_at <0, 0, -8> angle 60 right 16/9*x }}
plane {{ y, 0 pigment {{ rgb 0.5 }} finish {{ ambient 0 diffuse 0.8 }} }}
box {{ <-10, 0, 0>, <10, 12, 1> pigment {{ rgb 0.3 }} finish {{ ambient 0 diffuse 0.7 }} }}
box {{ <-6, 0, -6>, <-4, 3, -5> pigment {{ rgb 0.6 }} finish {{ ambient 0 diffuse 0.7 }} }}
sphere {{ <3, 1.2, -7>, 1.2 pigment {{ rgb 0.6 }} finish {{ ambient 0 diffuse 0.7 }} }}
#declare W = array[{count}] {{ {values} }}
union {{
  #for (I, 0, {count} - 1)
    #if (W[I] > 0)
      sphere {{ <-9.9 + 19.8*mod(I, {side})/{side}, 0.8 + 11*div(I, {side})/{side}, -0.1>, 0.03
        pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 3*W[I]*{gain} }} }}
    #end
  #end
  light_name "Facade"
}}
{more}
"""
KINDS = {
    "direct": ("", ""),
    "bounces": ("integrator { path_traced }", ""),
    "air": ("", "media { scattering { 1, 0.03 } }"),
}


def films(side):
    rolls = random.Random(7)
    places = [(i % side / side, i // side / side) for i in range(side * side)]
    block = max(1, side // 10)
    return {
        "uniform": [0.5 for _ in places],
        "smooth": [0.5 + 0.5 * math.sin(5 * x) * math.cos(4 * y) for x, y in places],
        "text": [float((int(x * side) // block + int(y * side) // block * 3) % 4 < 2) for x, y in places],
        "noise": [rolls.random() for _ in places],
        "sparse": [float(rolls.random() < 0.01) for _ in places],
    }


def light_in(png):
    """The values of a PNG picture with 16 bits."""
    data, at, packed = Path(png).read_bytes(), 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", data[at + 8:at + 18])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    step = 2 * (3 if colour == 2 else 1)
    raw, row, values = zlib.decompress(packed), width * step, []
    before = bytearray(row)
    for y in range(height):
        kind, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for i in range(row):
            a, b = line[i - step] if i >= step else 0, before[i]
            c = before[i - step] if i >= step else 0
            p = a + b - c
            nearest = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = line[i] + (0, a, b, (a + b) // 2, nearest)[kind] & 255
        before = line
        values += struct.unpack(f">{row // 2}H", line)
    return [value / 65535 for value in values]


def error(made, right):
    squares = sum((a - b) ** 2 for a, b in zip(made, right))
    return f"{100 * math.sqrt(squares / len(right)) / (sum(right) / len(right)):.2f} %"


def main():
    program = sys.argv[1]
    kind = sys.argv[2] if len(sys.argv) > 2 else "direct"
    side, samples, times = (int(sys.argv[i]) if len(sys.argv) > i else usual for i, usual in ((3, 2500), (4, 32), (5, 8)))
    side = math.isqrt(side)
    settings, more = KINDS[kind]
    picture = ["-V", "+W128", "+H72", "+FN16", "File_Gamma=1"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)

        def run(*words):
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            subprocess.run([program, *map(str, words)], check=True)
            return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before

        def scene(values):
            text = SCENE.format(count=side * side, side=side, gain=10000 / side ** 2, settings=settings, more=more,
                                values=",".join(f"{value:.4f}" for value in values))
            (folder / "facade.pov").write_text(text)
            return folder / "facade.pov"

        def rendered(values, samples, *words):
            run(scene(values), *picture, "--samples", samples, *words, f"+O{folder}/made.png")
            return light_in(folder / "made.png")

        everything = scene([1] * side * side)
        costs = [run(everything, *picture, "--samples", samples, f"+O{folder}/all.png", *words)
                 for words in ((), ("--keep-lights", folder / "all.lights"))]
        size = (folder / "all.lights").stat().st_size
        print(f"{kind}: {side * side} lamps, {samples} samples, user time {costs[0]:.1f} s, with light kept {costs[1]:.1f} s, "
              f"{size / 1e6:.1f} MB")
        kept, right_of_all = light_in(folder / "all.png"), rendered([1] * side * side, times * samples, "--seed", 9)
        print("| film | fresh | relit | own error | relit, `--smooth 0` |\n|---|---|---|---|---|")
        for film, values in films(side).items():
            (folder / "film.csv").write_text(f"Facade[0..{side * side - 1}]\n" + ",".join(f"{v:.4f}" for v in values) + "\n")
            relit = []
            for words in ((), ("--smooth", 0)):
                run("relight", folder / "all.lights", "--csv", folder / "film.csv", "+FN16", "File_Gamma=1", *words,
                    f"+O{folder}/relit.png")
                relit.append(light_in(folder / "relit1.png"))
            fresh = rendered(values, samples, "--seed", 5)
            right = rendered(values, times * samples, "--seed", 9)
            own = [a * b / c if c > 0 else b for a, b, c in zip(kept, right, right_of_all)]
            print(f"| {film} | {error(fresh, right)} | {error(relit[0], right)} | {error(relit[0], own)} | "
                  f"{error(relit[1], right)} |", flush=True)


if __name__ == "__main__":
    main()
