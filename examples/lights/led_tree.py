#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes the two tables that led_tree.pov reads: led_tree_coords.csv, the places of 500 LEDs on a
tree in metres, y up; and led_tree_frames.csv, 100 frames with r, g, b of each LED from 0 to 255, in
steps of 5, which make the packed table a quarter smaller.
The film begins anew behind its last frame without a jump. Other tables of these forms will do."""

import colorsys
import math
import pathlib
import random

LEDS, FRAMES = 500, 100
HEIGHT, FOOT, REACH = 2.2, 0.35, 0.78
FOLDER = pathlib.Path(__file__).parent


def places():
    """A string that is wound around a cone, evenly by area, and hangs a little as it likes."""
    chance = random.Random(7)
    result = []
    for i in range(LEDS):
        share = 1 - math.sqrt(1 - (i + 0.5) / LEDS)
        radius = REACH * (1 - share) * chance.uniform(0.86, 1.04) + 0.02
        angle = 2 * math.pi * (13 * share * (2 - share) + chance.uniform(-0.02, 0.02))
        height = FOOT + (HEIGHT - FOOT) * share + chance.uniform(-0.03, 0.03)
        result.append((radius * math.cos(angle), height, radius * math.sin(angle)))
    return result


def colour(place, time):
    """Three bands of colour climb the tree, and a white wave runs up through them."""
    x, y, z = place
    share = (y - FOOT) / (HEIGHT - FOOT)
    turn = math.atan2(z, x) / (2 * math.pi) + 1.5 * share - time
    band = math.floor(3 * turn) % 3
    within = 3 * turn - math.floor(3 * turn)
    strength = max(0.0, math.sin(math.pi * within)) ** 2
    hue = (0.0, 0.1, 0.64)[band]
    wave = math.exp(-((((share - 2 * time + 0.5) % 1) - 0.5) / 0.05) ** 2)
    red, green, blue = colorsys.hsv_to_rgb(hue, 1, strength)
    light = (max(red, wave), max(green, 0.8 * wave), max(blue, 0.55 * wave))
    return [0 if value < 0.03 else 5 * round(51 * value) for value in light]


def main():
    leds = places()
    with open(FOLDER / "led_tree_coords.csv", "w", newline="\n") as file:
        file.write("x,y,z\n")
        for place in leds:
            file.write(",".join(f"{value:.3f}" for value in place) + "\n")
    with open(FOLDER / "led_tree_frames.csv", "w", newline="\n") as file:
        names = [f"{part}_{i}" for i in range(LEDS) for part in "rgb"]
        file.write(",".join(["frame"] + names) + "\n")
        for frame in range(FRAMES):
            row = [str(frame)]
            for place in leds:
                row += [str(value) for value in colour(place, frame / FRAMES)]
            file.write(",".join(row) + "\n")


if __name__ == "__main__":
    main()
