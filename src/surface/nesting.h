// SPDX-License-Identifier: GPL-3.0-or-later
// How much there is to a pigment or a normal that has others in it: evaluation, and writing it out,
// take as long. The readers refuse what is too much.
#pragma once

#include <algorithm>

namespace candelabra {

struct Nesting {
    int depth = 0;       ///< maps within each other: each may double the work at a point
    double entries = 1;  ///< of all maps written out, however often one part is used
    bool uv = false;     ///< some of it asks for u and v

    bool too_deep() const { return depth > 16 || entries > 1e6; }

    /// One of the parts of a map.
    void add(const Nesting& part) {
        depth = std::max(depth, part.depth + 1);
        entries += part.entries;
        uv |= part.uv;
    }
};

}  // namespace candelabra
