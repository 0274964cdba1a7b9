// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of a glowing leaf of a composite. Used where light leaves it, and where its surface is
// measured.
#pragma once

#include "shape/composite.h"

namespace candelabra {

class LeafSides {
public:
    /// `size`: the radius of a ball around the leaf. The composite must outlive this.
    LeafSides(const Composite&, std::uint32_t leaf, double size);

    /// Whether a line runs from the inner side to the outer one where it meets the leaf. What is
    /// inside decides if normals may be on either side: windings of meshes are as their makers
    /// chose, and normals for shading may face away from where the surface faces.
    bool leaves(const Ray& line, const Composite::Meeting&) const;

private:
    const Composite& whole_;
    double beside_;  ///< distance of points beside the surface
    bool unsure_;    ///< whether normals may be on either side
};

}  // namespace candelabra
