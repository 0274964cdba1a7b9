#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each header of the program includes the headers of the program that it uses.

headers.py BUILD    BUILD: the build folder, which has the generated headers; CXX chooses the compiler

A header that lacks an include compiles only behind another one that has it. To compile each header by
itself takes minutes, for it reads most headers dozens of times. Here some files include all headers in
different orders, each header behind those that it includes, so that for any two of which neither
includes the other each comes first in one of the files. Then no include that lacks stays hidden, nor
does a name that two headers give to two things.
alone.sh compiles sources as well, one by one, which takes longer.
"""

import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2] / "src"
STANDARD = re.compile(r"^#include <(?:[a-z_]+|glm/[a-z_0-9]+\.hpp|nlohmann/json\.hpp)>", re.M)
# A fatal error behind all headers ends the compiler before it instantiates their templates, which takes
# most of the time, and where the order of headers makes no difference. Without it there is a fault.
END = "end of the headers"
OWN = re.compile(r'^#include "([^"]+)"', re.M)


def read_headers():
    """The text of each header by its name; those with CGAL, which take long, are left to alone.sh."""
    texts = {str(path.relative_to(SOURCE)): path.read_text() for path in sorted(SOURCE.glob("*/*.h"))}
    return {name: text for name, text in texts.items() if "<CGAL/" not in text}


class Orders:
    """Sets of headers are numbers, with a bit for each header."""

    def __init__(self, texts):
        self.names = list(texts)
        index = {name: i for i, name in enumerate(self.names)}
        self.included = [[index[own] for own in OWN.findall(text) if own in index] for text in texts.values()]
        self.reached = [0] * len(self.names)
        for i in range(len(self.names)):
            self.reach(i)
        everything = (1 << len(self.names)) - 1
        # Of each header, those that shall come behind it in one of the files still to be made
        self.open = [everything & ~reached for reached in self.reached]

    def reach(self, header):
        if not self.reached[header]:
            self.reached[header] = 1 << header  # ends a circle
            for other in self.included[header]:
                self.reached[header] |= self.reach(other)
        return self.reached[header]

    def best(self, seen):
        """The header that has most to gain for the headers that it adds; None: there is no gain."""
        best, most = None, 0
        for header, later in enumerate(self.open):
            if not later or seen >> header & 1:
                continue
            reached = self.reached[header]
            gain = (later & ~(seen | reached)).bit_count() / ((reached & ~seen).bit_count() + 2)
            if gain > most:
                best, most = header, gain
        return best

    def add(self, header, seen, order):
        if seen >> header & 1:
            return seen
        for other in self.included[header]:
            seen = self.add(other, seen, order)
        seen |= 1 << header
        self.open[header] &= seen
        order.append(self.names[header])
        return seen

    def files(self):
        while any(self.open):
            seen, order = 0, []
            while (header := self.best(seen)) is not None:
                seen = self.add(header, seen, order)
            yield order


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve()
    compiler = os.environ.get("CXX", "g++")
    cache = (build / "CMakeCache.txt").read_text()
    free_type = re.search(r"^FREETYPE_INCLUDE_DIR_freetype2:PATH=(.+)$", cache, re.MULTILINE)
    flags = ["-std=c++20", "-w", f"-I{SOURCE}", f"-I{build}/grammar", '-DCANDELABRA_VERSION=""',
             '-DCANDELABRA_SOURCE_STDLIB=""', "-DCANDELABRA_JPEG",
             f"-I{free_type[1] if free_type else '/usr/include/freetype2'}"]
    texts = read_headers()
    with tempfile.TemporaryDirectory() as folder:
        # Standard headers are all there, for speed; includes_test.cpp looks after them.
        standard = Path(folder) / "all.h"
        sources = [*texts.values(), *(path.read_text() for path in SOURCE.glob("*/*.cpp"))]
        standard.write_text("\n".join(sorted({line for text in sources for line in STANDARD.findall(text)})) + "\n")
        subprocess.run([compiler, *flags, "-x", "c++-header", standard, "-o", f"{standard}.gch"], check=True)

        def compiled(order):
            text = "".join(f'#include "{name}"\n' for name in order) + f'static_assert(false, "{END}");\n'
            command = [compiler, *flags, "-fsyntax-only", "-Wfatal-errors", "-include", standard, "-x", "c++", "-"]
            said = subprocess.run(command, input=text, capture_output=True, text=True, check=False).stderr
            return "" if END in said else said

        files = list(Orders(texts).files())
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            faults = [said for said in threads.map(compiled, files) if said]
    if faults:
        sys.exit("".join(faults) + "a header does not include what it uses, the first in each order")
    print(f"{len(texts)} headers include what they use, in {len(files)} orders")


main()
