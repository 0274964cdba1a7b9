#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
# Forty of the scenes that come with POV-Ray, drawn by lot with a fixed seed, by both programs at 160x120 without
# antialiasing. Averages of 4x4 pixels may differ by 0.04 of the full scale (root mean square), and
# by 0.10 in three others. Scenes that ask for media, photons, radiosity or POT files are left out, and those that take
# POV-Ray long.
# Needs Debian's povray, povray-examples and povray-includes; ends with 77 where they are missing.
#   povray.py PROGRAM
import gzip, os, random, re, shutil, subprocess, sys, tempfile
from concurrent.futures import ThreadPoolExecutor

EXAMPLES, INCLUDES = "/usr/share/doc/povray/examples", "/usr/share/povray-3.7/include"
if not shutil.which("povray") or not os.path.isdir(EXAMPLES) or not os.path.isdir(INCLUDES):
    print("skipped: povray with its examples and includes is not installed")
    sys.exit(77)
WIDTH, HEIGHT, SECONDS = 160, 120, 20
program = os.path.realpath(sys.argv[1])
folder = tempfile.mkdtemp()


def unpack():
    """A copy of the examples that scenes may write beside themselves in; the names of the scenes."""
    scenes = []
    for place, _, files in os.walk(EXAMPLES):
        target = os.path.join(folder, os.path.relpath(place, EXAMPLES))
        os.makedirs(target, exist_ok=True)
        for name in files:
            source = os.path.join(place, name)
            if name.endswith(".gz"):
                name = name[:-3]
                with gzip.open(source) as packed, open(os.path.join(target, name), "wb") as plain:
                    shutil.copyfileobj(packed, plain)
            else:
                shutil.copy(source, os.path.join(target, name))
            if name.endswith(".pov"):
                scenes.append(os.path.join(target, name))
    return sorted(scenes)


def text_of(path):
    """A scene with the files beside it that it includes."""
    text = open(path, errors="replace").read()
    for name in re.findall(r'#include\s*"([^"]+)"', text):
        beside = os.path.join(os.path.dirname(path), name)
        if os.path.exists(beside):
            text += open(beside, errors="replace").read()
    return text


def pixels(path):
    """Averages of 4x4 pixels of a binary PPM file, from 0 to 1."""
    data = open(path, "rb").read()
    gap = rb"(?:\s+|#[^\n]*\n)+"
    head = re.match(rb"P6" + gap + rb"(\d+)" + gap + rb"(\d+)" + gap + rb"(\d+)\s", data)
    assert head and (int(head[1]), int(head[2])) == (WIDTH, HEIGHT), path
    wide = 2 if int(head[3]) > 255 else 1
    values = data[head.end()::wide]
    sums = [0.0] * (WIDTH // 4 * (HEIGHT // 4) * 3)
    for y in range(HEIGHT):
        for x in range(WIDTH):
            for c in range(3):
                sums[(y // 4 * (WIDTH // 4) + x // 4) * 3 + c] += values[(y * WIDTH + x) * 3 + c]
    return [s / 16 / 255 for s in sums]


def render(command, scene, picture, own):
    options = [command, "+I" + os.path.basename(scene), "+O" + picture, "+W%d" % WIDTH, "+H%d" % HEIGHT, "-A", "-D", "+FP",
               "+WT1", "+L" + INCLUDES] + own
    try:
        run = subprocess.run(options, cwd=os.path.dirname(scene), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return "takes more than %d s" % SECONDS
    if run.returncode or not os.path.exists(picture):
        return run.stdout.decode(errors="replace")[-400:]
    return ""


def compare(scene):
    """How far the pictures are apart, or why there is none; None where POV-Ray has none."""
    stem = os.path.join(folder, os.path.relpath(scene, folder).replace("/", "_")[:-4])
    if render("povray", scene, stem + ".povray.ppm", ["-GA"]):
        return None
    complaint = render(program, scene, stem + ".ppm", ["-V"])
    if complaint:
        return complaint
    a, b = pixels(stem + ".povray.ppm"), pixels(stem + ".ppm")
    return (sum((p - q) ** 2 for p, q in zip(a, b)) / len(a)) ** 0.5


try:
    asks_for_more = re.compile(r"\b(media|photons|radiosity|pot)\b")
    # Scenes that other files or a clock belong to make another picture by themselves.
    apart = ("portfolio", "animations", "radiosity", "interior", "incdemo/i_")
    chosen = [s for s in unpack() if not os.path.relpath(s, folder).startswith(apart)
              and not asks_for_more.search(text_of(s))]
    random.Random(1).shuffle(chosen)
    matches, near, bad = 0, [], []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for scene, apart in zip(chosen, pool.map(compare, chosen[:44])):
            name = os.path.relpath(scene, folder)
            if apart is None or matches + len(near) + len(bad) == 40:
                continue
            if isinstance(apart, str) or apart > 0.10:
                bad.append((name, apart))
            elif apart > 0.04:
                near.append((name, apart))
            else:
                matches += 1
    print("%d match, %d near, %d far or without a picture" % (matches, len(near), len(bad)))
    for name, apart in near + bad:
        print(name, apart)
    sys.exit(1 if bad or len(near) > 3 or matches < 37 else 0)
finally:
    shutil.rmtree(folder)
