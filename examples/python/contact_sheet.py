# SPDX-License-Identifier: CC0-1.0
"""A contact sheet: a scene under many seeds, side by side in one picture.

    python3 contact_sheet.py [WIDTH] [PICTURE]
"""

import sys

import numpy

import candelabra

TREES = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 1.6, 0> right x angle 50 }
background { rgb <0.02, 0.03, 0.08> }
plane { y, 0 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.8 } }
#declare R = seed(Seed);
cone { y * 0.5, 1.4, y * 3.4, 0 pigment { rgb <0.05, 0.2, 0.08> } finish { ambient 0 diffuse 1 } }
#for (I, 1, 40)
  #local H = 0.6 + 2.6 * rand(R);
  #local A = 360 * rand(R);
  sphere { <(3.4 - H) / 2.9 * 1.45, H, 0>, 0.05 rotate A * y
    pigment { rgb <1, 0.5 + 0.5 * rand(R), 0.2 + 0.4 * rand(R)> } finish { ambient 0 diffuse 0 emission 12 } }
#end
"""

width = int(sys.argv[1]) if len(sys.argv) > 1 else 240
columns, rows = 4, 2
pictures = [candelabra.render_text(TREES, width=width, height=width, declare={"Seed": seed}, samples=16, film=True)
            for seed in range(1, columns * rows + 1)]
lines = [numpy.hstack([each.pixels for each in pictures[row * columns:(row + 1) * columns]]) for row in range(rows)]
sheet = pictures[0]
sheet.pixels = numpy.vstack(lines)
sheet.save(sys.argv[2] if len(sys.argv) > 2 else "trees.png")
print(f"{len(pictures)} pictures, {sheet.pixels.shape[1]}x{sheet.pixels.shape[0]}")
