# SPDX-License-Identifier: CC0-1.0
"""Lamps of a table: each row of leds.csv is a lamp, by pandas if that is installed.

    python3 led_table.py [WIDTH] [PICTURE]
"""

import csv
import pathlib
import sys

import candelabra

table = pathlib.Path(__file__).with_name("leds.csv")
try:
    import pandas
    rows = pandas.read_csv(table).to_dict("records")
except ImportError:
    with open(table, newline="") as file:
        rows = list(csv.DictReader(file))

scene = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 0.6, 0> }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.8 } }
plane { -z, -1 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.8 } }
"""
for row in rows:
    red, green, blue = (int(row["colour"][i:i + 2], 16) / 255 for i in (1, 3, 5))
    scene += f"""#declare {row['name']} = sphere {{ <{row['x']}, {row['y']}, 0>, 0.05
  pigment {{ srgb <{red}, {green}, {blue}> }} finish {{ ambient 0 diffuse 0 emission 60 * {row['candela']} }} }}
object {{ {row['name']} }}
"""

width = int(sys.argv[1]) if len(sys.argv) > 1 else 480
picture = candelabra.render_text(scene, width=width, height=width * 3 // 4, samples=16, film=True, light_report=True)
for lamp in picture.light_report:
    print(f"{lamp['name']:8} {100 * lamp['light']:6.1f} % of the light")
picture.save(sys.argv[2] if len(sys.argv) > 2 else "leds.png")
