# SPDX-License-Identifier: CC0-1.0
"""A parameter sweep: how bright is a desk, as a lamp hangs lower?

    python3 sweep.py [STEPS]
"""

import sys

import candelabra

ROOM = """#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced } }
camera { location <0, 1.5, -3.5> look_at <0, 1, 0> }
box { <-2, 0, -4>, <2, 3, 2> pigment { rgb 0.7 } finish { ambient 0 diffuse 1 } }
box { <-0.8, 0.7, -0.4>, <0.8, 0.75, 0.4> pigment { rgb <0.5, 0.3, 0.2> } finish { ambient 0 diffuse 1 } }
sphere { <0, Height, 0>, 0.08 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 40 } }
meter { "desk" corner <-0.8, 0.751, -0.4> along 1.6*x across 0.8*z counts <3, 2> }
"""

steps = int(sys.argv[1]) if len(sys.argv) > 1 else 5
print("height      mean       min")
for step in range(steps):
    height = 2.8 - 1.2 * step / max(steps - 1, 1)
    told = candelabra.measure(text=ROOM, declare={"Height": height}, until="10%")
    desk = told["meters"][0]
    print(f"{height:6.2f} {desk['mean']['value']:9.2f} {desk['min']['value']:9.2f} {desk['unit']}")
