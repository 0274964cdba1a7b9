# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes glTF files: a million triangles with a thousand textures' names (land.glb), and 100,000 nodes of a lamp of 100
faces (lamps.glb).

    python3 tests/bench/models.py FOLDER
"""

import json
import math
import struct
import sys
from array import array


def glb(path, gltf, data):
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    with open(path, "wb") as file:
        file.write(b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)))
        file.write(struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", len(data)) + b"BIN\0" + data)


class Buffer:
    def __init__(self):
        self.data, self.views, self.accessors = bytearray(), [], []

    def add(self, numbers, component, kind, count, **more):
        raw = numbers.tobytes()
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(raw)})
        self.data += raw
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": component, "count": count,
                               "type": kind, **more})
        return len(self.accessors) - 1


def write(path, buffer, gltf):
    gltf.update({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "bufferViews": buffer.views,
                 "accessors": buffer.accessors, "buffers": [{"byteLength": len(buffer.data)}]})
    glb(path, gltf, bytes(buffer.data))


def land(path, tiles=10, side=71):
    """Tiles of land, each with a mesh of its own: 2 * 71^2 triangles in each of 100, with normals and u, v."""
    buffer, meshes, nodes = Buffer(), [], [{"children": list(range(1, tiles * tiles + 1))}]
    corners = array("I")
    for row in range(side):
        for column in range(side):
            a = row * (side + 1) + column
            corners.extend((a, a + side + 1, a + 1, a + 1, a + side + 1, a + side + 2))
    count = (side + 1) ** 2
    for tile in range(tiles * tiles):
        points, normals, uvs = array("f"), array("f"), array("f")
        left, front = tile % tiles, tile // tiles
        for row in range(side + 1):
            for column in range(side + 1):
                x, z = left + column / side, front + row / side
                points.extend((x, 0.2 * math.sin(3 * x) * math.cos(2 * z), z))
                slope = (-0.6 * math.cos(3 * x) * math.cos(2 * z), 1, 0.4 * math.sin(3 * x) * math.sin(2 * z))
                size = math.sqrt(sum(each * each for each in slope))
                normals.extend(each / size for each in slope)
                uvs.extend((column / side, row / side))
        attributes = {"POSITION": buffer.add(points, 5126, "VEC3", count, min=[left, -0.2, front], max=[left + 1, 0.2, front + 1]),
                      "NORMAL": buffer.add(normals, 5126, "VEC3", count),
                      "TEXCOORD_0": buffer.add(uvs, 5126, "VEC2", count)}
        meshes.append({"primitives": [{"attributes": attributes, "material": tile,
                                       "indices": buffer.add(corners, 5125, "SCALAR", len(corners))}]})
        nodes.append({"name": f"Tile {tile}", "mesh": tile})
    names = 1000
    write(path, buffer, {
        "nodes": nodes, "meshes": meshes,
        "materials": [{"name": f"Land {i}", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.4, 0.3, 1], "metallicFactor": 0}}
                      for i in range(tiles * tiles)],
        "textures": [{"source": i, "name": f"Texture {i}"} for i in range(names)],
        "images": [{"uri": f"picture{i}.png", "name": f"Picture {i}"} for i in range(names)]})


def lamps(path, count=100000):
    """Nodes of one ball of 100 faces that emits."""
    buffer, points, corners, rings, sides = Buffer(), array("f"), array("H"), 6, 10
    points.extend((0, 0.1, 0))
    for ring in range(1, rings):
        for side in range(sides):
            polar, turn = math.pi * ring / rings, 2 * math.pi * side / sides
            points.extend((0.1 * math.sin(polar) * math.cos(turn), 0.1 * math.cos(polar), 0.1 * math.sin(polar) * math.sin(turn)))
    points.extend((0, -0.1, 0))
    last = 1 + (rings - 1) * sides
    for side in range(sides):
        after = (side + 1) % sides
        corners.extend((0, 1 + after, 1 + side, last, last - sides + side, last - sides + after))
        for ring in range(rings - 2):
            a, b = 1 + ring * sides, 1 + (ring + 1) * sides
            corners.extend((a + side, a + after, b + side, b + side, a + after, b + after))
    position = buffer.add(points, 5126, "VEC3", len(points) // 3, min=[-0.1] * 3, max=[0.1] * 3)
    indices = buffer.add(corners, 5123, "SCALAR", len(corners))
    wide = math.isqrt(count)
    write(path, buffer, {
        "nodes": [{"children": list(range(1, count + 1))}] +
                 [{"mesh": 0, "translation": [i % wide, (i * 7919 % 100) / 25, i // wide]} for i in range(count)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": position}, "indices": indices, "material": 0}]}],
        "materials": [{"name": "Lamp", "emissiveFactor": [1, 0.7, 0.4], "pbrMetallicRoughness": {"metallicFactor": 0}}]})


land(sys.argv[1] + "/land.glb")
lamps(sys.argv[1] + "/lamps.glb")
