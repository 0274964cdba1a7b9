#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes povlogo.ttf, the library's fonts/povlogo.ttf: a TrueType font whose only glyph is a mark of
our own, a ball in a ring on a tapering stem. It stands in for POV-Ray's font of that name, and has
the size of its glyph: 0.67 wide and 1 high, with an advance of 0.705."""

import math
import pathlib
import struct

EM = 1000
ADVANCE = 705


def circle(x, y, radius, clockwise):
    """Eight arcs as (x, y, on the curve); the points between are where the tangents meet."""
    points = []
    for i in range(16):
        angle = math.pi / 8 * (-i if clockwise else i)
        r = radius if i % 2 == 0 else radius / math.cos(math.pi / 8)
        points.append((round(x + r * math.cos(angle)), round(y + r * math.sin(angle)), i % 2 == 0))
    return points


def corners(*places):
    return [(x, y, True) for x, y in places]


CONTOURS = [
    circle(370, 702, 300, True),
    circle(370, 702, 205, False),
    circle(370, 702, 120, True),
    corners((110, 552), (0, 2), (24, 2), (232, 436)),
]


def glyph():
    points = [point for contour in CONTOURS for point in contour]
    box = [f(p[axis] for p in points) for f in (min, max) for axis in (0, 1)]
    data = struct.pack(">5h", len(CONTOURS), *box)
    last = -1
    for contour in CONTOURS:
        last += len(contour)
        data += struct.pack(">H", last)
    data += struct.pack(">H", 0)  # no instructions
    data += bytes(1 if on else 0 for _, _, on in points)
    for axis in (0, 1):
        places = [point[axis] for point in points]
        data += b"".join(struct.pack(">h", a - b) for a, b in zip(places, [0] + places))
    return data + bytes(-len(data) % 4), box, len(points)


def tables():
    """Glyph 0 stands for all signs that the font lacks; P has glyph 1, of the same form."""
    outline, box, count = glyph()
    head = struct.pack(">4I2H2q4h2H3h", 0x10000, 0x10000, 0, 0x5F0F3CF5, 3, EM, 0, 0, *box, 0, 8, 2,
                       1, 0)
    cmap = struct.pack(">2H2HI", 0, 1, 3, 1, 12)
    cmap += struct.pack(">16H", 4, 32, 0, 4, 4, 1, 0, ord("P"), 0xFFFF, 0, ord("P"), 0xFFFF,
                        (1 - ord("P")) & 0xFFFF, 1, 0, 0)
    name = "Candelabra Povlogo".encode("utf-16-be")
    return {
        b"cmap": cmap,
        b"glyf": outline * 2,
        b"head": head,
        b"hhea": struct.pack(">I3hH3h3h4hhH", 0x10000, 1000, -200, 0, ADVANCE, box[0],
                             ADVANCE - box[2], box[2], 1, 0, 0, 0, 0, 0, 0, 0, 2),
        b"hmtx": struct.pack(">HhHh", ADVANCE, box[0], ADVANCE, box[0]),
        b"loca": struct.pack(">3I", 0, len(outline), 2 * len(outline)),
        b"maxp": struct.pack(">I14H", 0x10000, 2, count, len(CONTOURS), 0, 0, 1, *[0] * 8),
        b"name": struct.pack(">9H", 0, 1, 18, 3, 1, 0x409, 4, len(name), 0) + name,
        b"post": struct.pack(">IihhI4I", 0x30000, 0, -100, 50, 0, 0, 0, 0, 0),
    }


def checksum(data):
    return sum(struct.unpack(f">{len(data) // 4}I", data)) & 0xFFFFFFFF


def font():
    parts = sorted(tables().items())
    steps = len(parts).bit_length() - 1
    span = 16 << steps
    start = struct.pack(">I4H", 0x10000, len(parts), span, steps, 16 * len(parts) - span)
    at = len(start) + 16 * len(parts)
    body = b""
    for tag, data in parts:
        padded = data + bytes(-len(data) % 4)
        start += tag + struct.pack(">3I", checksum(padded), at + len(body), len(data))
        body += padded
    whole = start + body
    adjustment = (0xB1B0AFBA - checksum(whole)) & 0xFFFFFFFF
    head = at + sum(len(d) + -len(d) % 4 for t, d in parts if t < b"head")
    return whole[:head + 8] + struct.pack(">I", adjustment) + whole[head + 12:]


pathlib.Path("povlogo.ttf").write_bytes(font())
