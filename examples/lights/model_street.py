#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes model_street.gltf beside itself: a street of houses with lit windows, paved road, lanterns of examples/library/
lantern.py in sixteen places, and a spotlight of KHR_lights_punctual over a door."""
import os
import random
import struct
import sys
import zlib

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "library"))
sys.dont_write_bytecode = True
from lantern import Model, lantern  # noqa: E402


def png(width, height, pixel):
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def box(low, high):
    """The six faces of a box, counterclockwise from outside."""
    (a, b, c), (d, e, f) = low, high
    return [[(a, b, f), (d, b, f), (d, e, f), (a, e, f)], [(d, b, c), (a, b, c), (a, e, c), (d, e, c)],
            [(a, b, c), (a, b, f), (a, e, f), (a, e, c)], [(d, b, f), (d, b, c), (d, e, c), (d, e, f)],
            [(a, e, f), (d, e, f), (d, e, c), (a, e, c)], [(a, b, c), (d, b, c), (d, b, f), (a, b, f)]]


def floor(low, high, y, tile):
    """A rectangle seen from above, and u and v in tiles."""
    (a, c), (d, f) = low, high
    return [[(a, y, f), (d, y, f), (d, y, c), (a, y, c)]], [(a / tile, f / tile), (d / tile, f / tile), (d / tile, c / tile),
                                                         (a / tile, c / tile)]


rng = random.Random(7)
model = Model()
parts = lantern(model)


def material(name, colour, roughness, **more):
    return model.add("materials", {"name": name, "pbrMetallicRoughness": {
        "baseColorFactor": [*colour, 1], "metallicFactor": 0, "roughnessFactor": roughness, **more.pop("pbr", {})}, **more})


def glowing(name, colour, strength):
    return material(name, [0.6, 0.5, 0.4], 0.5, emissiveFactor=colour,
                    extensions={"KHR_materials_emissive_strength": {"emissiveStrength": strength}})


def sett(x, y):
    """Setts of a road in rows that are shifted by half."""
    row = y // 16
    left = (x + 8 * (row % 2)) % 64
    stone = random.Random(left // 16 * 100 + row)
    edge = left % 16 in (0, 15) or y % 16 in (0, 15)
    grey = 40 if edge else stone.randrange(80, 140)
    return [max(0, min(255, grey + random.Random(x * 64 + y).randrange(-6, 7) + warm)) for warm in (4, 0, -6)]


view = model.view(png(64, 64, sett))
model.gltf["images"] = [{"bufferView": view, "mimeType": "image/png", "name": "setts"}]
model.gltf["textures"] = [{"source": 0}]
road = material("Setts", [0.7, 0.7, 0.7], 0.55, pbr={"baseColorTexture": {"index": 0}})
kerb = material("Kerb", [0.28, 0.27, 0.26], 0.8)
walls = [material("Wall " + name, colour, 0.9) for name, colour in (
    ("ochre", [0.5, 0.33, 0.15]), ("rose", [0.45, 0.22, 0.18]), ("grey", [0.33, 0.34, 0.35]), ("cream", [0.55, 0.48, 0.36]))]
roof = material("Slates", [0.09, 0.09, 0.11], 0.7)
frame = material("Frame", [0.5, 0.48, 0.45], 0.6)
dark = material("Pane", [0.02, 0.025, 0.03], 0.08)
lit = [glowing("Window " + name, colour, strength) for name, colour, strength in (
    ("warm", [1, 0.6, 0.28], 1.1), ("white", [1, 0.82, 0.6], 1.5), ("dim", [1, 0.5, 0.2], 0.5))]

nodes = model.gltf["nodes"]
nodes.append({"name": "Street", "children": []})


def node(name, parent=0, **more):
    nodes.append({"name": name, **more})
    nodes[parent].setdefault("children", []).append(len(nodes) - 1)
    return len(nodes) - 1


faces, uvs = floor((-3, -60), (3, 8), 0, 1.6)
node("Road", mesh=model.mesh("Road", road, faces, uvs=uvs))
for side in (-1, 1):
    node("Pavement", mesh=model.mesh("Pavement", kerb, box((min(3 * side, 5 * side), -0.2, -60), (max(3 * side, 5 * side), 0.14, 8))))

# Windows are meshes that all houses share.
pane = box((-0.45, 0, 0), (0.45, 1.3, 0.03))[:1]
bars = [f for low, high in (((-0.55, -0.12, 0), (0.55, 0, 0.12)), ((-0.55, 1.3, 0), (0.55, 1.42, 0.1)),
                            ((-0.03, 0, 0), (0.03, 1.3, 0.06)), ((-0.45, 0.85, 0), (0.45, 0.9, 0.06)))
        for f in box(low, high)]
frames = model.mesh("Window frame", frame, bars)
panes = [model.mesh("Pane", one, pane) for one in (dark, *lit)]
for side in (-1, 1):
    z = 6.0
    for number in range(9):
        width, storeys = rng.choice((5.5, 6.5, 7.5)), rng.choice((2, 3, 3, 4))
        height = 3 * storeys + 0.6
        # A house faces +x here, and is turned to the street.
        house = node("House", translation=[5 * side, 0, round(z - width / 2, 3)],
                     rotation=[0, 1, 0, 0] if side > 0 else [0, 0, 0, 1])
        half = width / 2
        node("Walls", house, mesh=model.mesh("Walls", rng.choice(walls), box((-7, 0, -half), (0, height, half))[:5]))
        gable = [[(-7, height, -half), (0.3, height, -half), (-3.5, height + 2.6, -half)],
                 [(0.3, height, half), (-7, height, half), (-3.5, height + 2.6, half)],
                 [(0.3, height, -half), (0.3, height, half), (-3.5, height + 2.6, half), (-3.5, height + 2.6, -half)],
                 [(-7, height, half), (-7, height, -half), (-3.5, height + 2.6, -half), (-3.5, height + 2.6, half)]]
        node("Roof", house, mesh=model.mesh("Roof", roof, gable))
        for storey in range(storeys):
            for place in range(int(width // 1.8)):
                at = (place + 0.5) * width / int(width // 1.8) - half
                shown = rng.choice((0, 0, 0, 1, 1, 2, 3))
                turn = [0, 0.70710678, 0, 0.70710678]
                window = node("Window", house, translation=[0.01, 3 * storey + 1.1, round(at, 3)], rotation=turn)
                node("Frame", window, mesh=frames)
                node("Pane", window, mesh=panes[shown])
        z -= width
for number in range(8):
    for side in (-1, 1):
        post = node("Lantern", translation=[3.5 * side, 0.14, round(2.5 - 7.2 * number - 3.6 * (side > 0), 3)], scale=[1.4, 1.7, 1.4])
        node("Post", post, mesh=parts["Post"])
        lamp = node("Lamp", post, translation=[0, 1.55, 0])
        node("Panes", lamp, mesh=parts["Panes"])
        node("Roof", lamp, mesh=parts["Roof"])

model.gltf["extensionsUsed"].append("KHR_lights_punctual")
model.gltf["extensions"] = {"KHR_lights_punctual": {"lights": [
    {"type": "spot", "color": [1, 0.85, 0.6], "intensity": 900, "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.7}}]}}
node("Door light", translation=[-4.2, 3.4, -4], rotation=[-0.70710678, 0, 0, 0.70710678],
     extensions={"KHR_lights_punctual": {"light": 0}})
model.write(os.path.join(here, "model_street.gltf"))
