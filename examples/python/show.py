# SPDX-License-Identifier: CC0-1.0
"""A show: the lamps of a scene that has been rendered once play a wave, frame by frame.

    python3 show.py [WIDTH] [FRAMES] [FOLDER]
"""

import math
import os
import sys
import tempfile

import numpy

import candelabra

STAIRS = """#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3.2, 2.4, -5> look_at <0, 1, 0> }
#declare Step = union {
  #for (I, 0, 11)
    box { <-1.5, 0, 0.3 * I - 2>, <1.5, 0.18 * I + 0.1, 0.3 * I - 1.7>
      pigment { rgb 0.7 } finish { ambient 0 diffuse 0.9 } }
  #end
}
object { Step }
plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.9 } }
#declare Led = sphere { 0, 0.04 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 150 } }
union {
  #for (I, 0, 11) object { Led translate <-1.35, 0.18 * I + 0.2, 0.3 * I - 1.85> } #end
  light_name "Leds"
}
"""

width = int(sys.argv[1]) if len(sys.argv) > 1 else 320
frames = int(sys.argv[2]) if len(sys.argv) > 2 else 24
folder = sys.argv[3] if len(sys.argv) > 3 else "."
with tempfile.TemporaryDirectory() as kept:
    file = os.path.join(kept, "stairs.lights")
    candelabra.render_text(STAIRS, width=width, height=width * 3 // 4, keep_lights=file, samples=64)
    lamps = candelabra.Lamps(file)
count = lamps.names["Leds"]
for frame in range(frames):
    phase = 2 * math.pi * (frame / frames - numpy.arange(count) / count)
    power = 0.5 + 0.5 * numpy.cos(phase)
    colour = numpy.stack([power, power ** 2, 0.3 * power ** 3], axis=1)
    lamps.relight({"Leds": colour}, film="on").save(os.path.join(folder, f"show{frame:03}.png"))
print(f"{frames} frames of {count} lamps")
