#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes stdlib/models/gems.gltf, the smaller model of the examples: two gems of one mesh, painted by a picture in the file,
and a lamp whose measured light is in the file, too."""
import base64
import os
import struct
import sys
import zlib

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
from lantern import Model  # noqa: E402

WEB = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 2 1 2 0 0 0\n1 1 10\n0 45 90\n0 90\n900 500 50\n900 300 20\n"
CORNERS = [(0.7, 0, 0), (-0.7, 0, 0), (0, 0.9, 0), (0, -0.6, 0), (0, 0, 0.7), (0, 0, -0.7)]
FACES = [(4, 0, 2), (0, 5, 2), (5, 1, 2), (1, 4, 2), (0, 4, 3), (5, 0, 3), (1, 5, 3), (4, 1, 3)]


def png(width, pixels):
    rows = b"".join(b"\0" + b"".join(bytes(p) for p in pixels[i:i + width]) for i in range(0, len(pixels), width))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, len(pixels) // width, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


model = Model()
picture = png(2, [(200, 60, 40, 255), (60, 200, 90, 255), (70, 90, 220, 120), (240, 230, 200, 255)])
model.gltf["images"] = [{"uri": uri("image/png", picture)}]
model.gltf["textures"] = [{"source": 0}]
paint = model.add("materials", {"name": "Painted", "normalTexture": {"index": 0, "scale": 0.5}, "pbrMetallicRoughness": {
    "baseColorFactor": [0.9, 0.8, 1, 1], "metallicFactor": 0.1, "roughnessFactor": 0.4, "baseColorTexture": {"index": 0}}})
gem = model.mesh("Gem", paint, [[CORNERS[i] for i in face] for face in FACES], uvs=[(0, 0), (1, 0), (0.5, 1)] * len(FACES))
model.gltf["extensionsUsed"] = ["EXT_lights_ies"]
model.gltf["extensions"] = {"EXT_lights_ies": {"lights": [{"uri": uri("application/octet-stream", WEB.encode())}]}}
model.gltf["nodes"] = [
    {"name": "Gems", "children": [1, 4]}, {"name": "Pair", "children": [2, 3]},
    {"name": "Gem", "mesh": gem, "translation": [0.3, 0, 0], "scale": [0.6, 0.6, 0.6]},
    {"name": "Gem", "mesh": gem, "translation": [-0.4, 0.1, 0.2], "rotation": [0, 0.70710678, 0, 0.70710678],
     "scale": [0.5, 0.7, 0.5]},
    {"name": "Lamp", "translation": [0, 2, 0], "rotation": [-0.70710678, 0, 0, 0.70710678],
     "extensions": {"EXT_lights_ies": {"light": 0, "multiplier": 0.5}}}]
model.write(sys.argv[1] if len(sys.argv) > 1 else "stdlib/models/gems.gltf")
