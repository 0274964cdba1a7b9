#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Makes the library's pictures/mtmand.pot: the potential around Mandelbrot's set as a mountain of 160x120 heights.

    examples/library/mtmand.py > stdlib/pictures/mtmand.pot

A .pot file is a GIF picture of twice the width: numbers of 256 colours, in the left half the higher bytes of the heights, in
the right half the lower ones.
"""
import math
import struct
import sys

WIDTH, HEIGHT, MOST_STEPS = 160, 120, 1000


def steps(x, y):
    """How many steps a point takes to leave, with a fraction: the surface has no terraces."""
    c = complex(x, y)
    z = 0
    for step in range(MOST_STEPS):
        z = z * z + c
        if abs(z) > 100:
            return max(1.0, step + 1 - math.log2(math.log(abs(z))))
    return MOST_STEPS


def heights():
    """0 to 65535: the nearer to the set, the higher, with a top that is not all plain."""
    rows = [[steps(-1.77 + 0.08 * (i / WIDTH - 0.5), 0.06 * (0.5 - j / HEIGHT)) for i in range(WIDTH)] for j in range(HEIGHT)]
    lowest = min(min(row) for row in rows)
    return [[round(65535 * (1 - (lowest / number) ** 0.8)) for number in row] for row in rows]


def packed(numbers):
    """LZW with codes of nine to twelve bits, the table begun anew when it is full."""
    clear, end = 256, 257
    stored, bits, result = 0, 0, bytearray()
    table, width, last = {}, 9, ()

    def put(code):
        nonlocal stored, bits
        stored |= code << bits
        bits += width
        while bits >= 8:
            result.append(stored & 255)
            stored >>= 8
            bits -= 8

    put(clear)
    for number in numbers:
        word = last + (number,)
        if len(word) == 1 or word in table:
            last = word
            continue
        put(table[last] if len(last) > 1 else last[0])
        table[word] = end + 1 + len(table)
        if table[word] == 4095:
            put(clear)
            table, width = {}, 9
        elif table[word] == 1 << width:
            width += 1
        last = (number,)
    put(table[last] if len(last) > 1 else last[0])
    put(end)
    if bits:
        result.append(stored & 255)
    return bytes(result)


numbers = [n for row in heights() for n in [h >> 8 for h in row] + [h & 255 for h in row]]
data = packed(numbers)
out = b'GIF87a' + struct.pack('<HHBBB', 2 * WIDTH, HEIGHT, 0xf7, 0, 0) + bytes(v for i in range(256) for v in (i, i, i))
out += b',' + struct.pack('<HHHHB', 0, 0, 2 * WIDTH, HEIGHT, 0) + b'\x08'
for i in range(0, len(data), 255):
    block = data[i:i + 255]
    out += bytes([len(block)]) + block
sys.stdout.buffer.write(out + b'\0;')
