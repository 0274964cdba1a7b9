// SPDX-License-Identifier: GPL-3.0-or-later
// Facts about a pigment or a normal and about all others in it: their number, which bounds the time
// to evaluate and to write them, and the inputs that they need beside the point. The readers refuse
// those that nest too deeply.
#pragma once

#include <algorithm>

namespace candelabra {

struct Nesting {
    int depth = 0;         ///< maps within each other: each may double the work at a point
    double entries = 1;    ///< of all maps written out, however often one part is used
    bool uv = false;       ///< some pattern needs u and v
    bool by_view = false;  ///< some pattern depends on the direction of the ray
    bool by_surface = false;  ///< some pattern depends on how the surface faces
    bool by_axes = false;  ///< some pattern needs SurfaceAxes

    bool too_deep() const { return depth > 16 || entries > 1e6; }

    /// One of the parts of a map.
    void add(Nesting part) {
        ++part.depth;
        include(part);
    }

    /// Another layer or part that lies beside it.
    void include(const Nesting& other) {
        depth = std::max(depth, other.depth);
        entries += other.entries;
        uv |= other.uv;
        by_view |= other.by_view;
        by_surface |= other.by_surface;
        by_axes |= other.by_axes;
    }
};

}  // namespace candelabra
