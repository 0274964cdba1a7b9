#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes stdlib/models/lantern.gltf, the model of the examples: a post of iron and a lamp of four panes that emits, and
a camera in front of it."""
import base64
import json
import math
import struct
import sys


class Model:
    """A glTF file with its one buffer inside."""

    def __init__(self):
        self.bytes = b""
        self.gltf = {"asset": {"version": "2.0", "generator": "lantern.py", "copyright": "CC0-1.0"}, "scene": 0,
                     "scenes": [{"nodes": [0]}], "nodes": [], "meshes": [], "materials": [], "accessors": [],
                     "bufferViews": []}

    def add(self, kind, thing):
        self.gltf[kind].append(thing)
        return len(self.gltf[kind]) - 1

    def view(self, data):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        place = len(self.bytes)
        self.bytes += data
        return self.add("bufferViews", {"buffer": 0, "byteOffset": place, "byteLength": len(data)})

    def accessor(self, rows, form, component, kind, **more):
        data = b"".join(struct.pack("<" + form, *row) for row in rows)
        return self.add("accessors", {"bufferView": self.view(data), "componentType": component, "count": len(rows),
                                      "type": kind, **more})

    def mesh(self, name, material, faces, normals=None, uvs=None):
        """Faces are polygons of points, counterclockwise from outside."""
        points = [point for face in faces for point in face]
        corners, first = [], 0
        for face in faces:
            corners += [(first + i,) for j in range(1, len(face) - 1) for i in (0, j, j + 1)]
            first += len(face)
        low = [min(p[i] for p in points) for i in range(3)]
        high = [max(p[i] for p in points) for i in range(3)]
        attributes = {"POSITION": self.accessor(points, "3f", 5126, "VEC3", min=low, max=high)}
        if normals:
            attributes["NORMAL"] = self.accessor(normals, "3f", 5126, "VEC3")
        if uvs:
            attributes["TEXCOORD_0"] = self.accessor(uvs, "2f", 5126, "VEC2")
        indices = self.accessor(corners, "H", 5123, "SCALAR")
        return self.add("meshes", {"name": name, "primitives": [{"attributes": attributes, "indices": indices,
                                                                 "material": material}]})

    def write(self, path):
        data = base64.b64encode(self.bytes).decode()
        self.gltf["buffers"] = [{"byteLength": len(self.bytes), "uri": "data:application/octet-stream;base64," + data}]
        with open(path, "w", encoding="ascii") as file:
            json.dump(self.gltf, file, separators=(",", ":"))
            file.write("\n")


def turned(rings, sides):
    """Faces of a solid of revolution through rings (radius, y) from below, with a bottom and a top."""
    def corner(ring, i):
        angle = 2 * math.pi * (i + 0.5) / sides
        return (round(ring[0] * math.cos(angle), 5), ring[1], round(ring[0] * math.sin(angle), 5))
    faces = [[corner(rings[0], i) for i in range(sides)], [corner(rings[-1], -i) for i in range(sides)]]
    for low, high in zip(rings, rings[1:]):
        faces += [[corner(low, i), corner(high, i), corner(high, i + 1), corner(low, i + 1)] for i in range(sides)]
    return [[p for n, p in enumerate(face) if p not in face[:n]] for face in faces if len(set(face)) > 2]


def lantern(model):
    """Adds the meshes of a lantern; returns its nodes, the first of which has the others."""
    iron = model.add("materials", {"name": "Iron", "pbrMetallicRoughness": {
        "baseColorFactor": [0.06, 0.065, 0.07, 1], "metallicFactor": 0.6, "roughnessFactor": 0.45}})
    glow = model.add("materials", {"name": "Flame", "emissiveFactor": [1, 0.62, 0.28],
                                   "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.7, 0.5, 1], "metallicFactor": 0,
                                                            "roughnessFactor": 0.6},
                                   "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 6}}})
    model.gltf["extensionsUsed"] = ["KHR_materials_emissive_strength"]
    post = model.mesh("Post", iron, turned([(0.16, 0), (0.16, 0.12), (0.1, 0.2), (0.05, 0.3), (0.04, 1.5), (0.09, 1.55)], 8))
    panes = model.mesh("Panes", glow, turned([(0.12, 0), (0.2, 0.42)], 4)[2:])
    roof = model.mesh("Roof", iron, turned([(0.25, 0.42), (0.06, 0.6), (0.03, 0.72)], 4))
    return {"Post": post, "Panes": panes, "Roof": roof}


if __name__ == "__main__":
    made = Model()
    meshes = lantern(made)
    made.gltf["nodes"] = [{"name": "Lantern", "children": [1, 2, 5]}, {"name": "Post", "mesh": meshes["Post"]},
                          {"name": "Lamp", "translation": [0, 1.55, 0], "children": [3, 4]},
                          {"name": "Panes", "mesh": meshes["Panes"]}, {"name": "Roof", "mesh": meshes["Roof"]},
                          {"name": "View", "translation": [0, 1.3, 4], "camera": 0}]
    made.gltf["cameras"] = [{"type": "perspective", "perspective": {"yfov": 0.75, "znear": 0.1}}]
    made.write(sys.argv[1] if len(sys.argv) > 1 else "stdlib/models/lantern.gltf")
