// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/white_element.h"

#include <cmath>

namespace candelabra {

namespace {

/// A surface through which nothing passes, and on which photons leave nothing.
const Material& opaque() {
    static const Material material = [] {
        Material made;
        made.photons.collects = false;
        return made;
    }();
    return material;
}

const Finish& white() {
    static const Finish finish = [] {
        Finish made;
        made.ambient = Rgb(0);
        made.diffuse = 1;
        return made;
    }();
    return finish;
}

}  // namespace

Vertex WhiteElement::vertex(std::span<const PrimitiveIndex> around) const {
    // The element may lie on a surface, up to rounding.
    constexpr double relative_tolerance = 1e-9;
    Vertex vertex{{}, {}, &opaque(), around};
    Hit& hit = vertex.hit;
    hit.position = position_;
    hit.normal = hit.smooth_normal = normal_;
    hit.tolerance =
        std::fmax(tolerance_, relative_tolerance * (1 + max_component(glm::abs(position_))));
    Shading& s = vertex.shading;
    s.position = position_;
    s.view = -normal_;
    s.normal = s.smooth_normal = s.geometric_normal = normal_;
    return vertex;
}

Layers WhiteElement::layers() const {
    Layers layers;
    layers.push_back({{Rgb(1)}, normal_, &white()});
    return layers;
}

}  // namespace candelabra
