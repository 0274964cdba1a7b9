// SPDX-License-Identifier: GPL-3.0-or-later
// A small white surface anywhere in a scene, by which the light that falls there is measured: it
// shows a radiance of its irradiance over pi. It changes nothing in the scene, and integrators
// light it as they light any surface. Photons leave nothing on it; paths find their light.
#pragma once

#include "transport/path.h"
#include "transport/vertex.h"

namespace candelabra {

class WhiteElement {
public:
    /// `normal`: unit, on the side that is lit. `tolerance`: what lies nearer does not count, nor
    /// does what is a rounding error away.
    WhiteElement(const Vec3& position, const Vec3& normal, double tolerance = 0)
        : position_(position), normal_(normal), tolerance_(tolerance) {}

    /// A ray that sees it.
    Ray ray() const { return {position_, -normal_}; }
    /// The element for a path along that ray; `around` are the solids that contain it.
    Vertex vertex(std::span<const PrimitiveIndex> around) const;
    /// Its look.
    Layers layers() const;

private:
    Vec3 position_, normal_;
    double tolerance_;
};

}  // namespace candelabra
