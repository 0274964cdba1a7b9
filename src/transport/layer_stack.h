// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a texture where a path meets them: each is seen through those above it, and all of
// them together let light through from behind the surface. POV-Ray 3.7's rules, for all
// integrators.
#pragma once

#include "base/function_ref.h"
#include "transport/path.h"
#include "transport/vertex.h"

#include <span>

namespace candelabra {

class LayerStack {
public:
    /// Of a path that has met the vertex.
    LayerStack(const World&, const PathState&, const Vertex&, std::span<const Layer>);

    /// One layer, as it is seen.
    struct Seen {
        Shading shading;
        Vec3 through = Vec3(1);  ///< share of its radiance that the layers above it leave
        double weight = 1;       ///< grey of that
        /// Share of the radiance from the mirror direction, with `through` not in it.
        Vec3 reflected = Vec3(0);
    };
    /// From the top, as far as a layer counts.
    void visit(FunctionRef<void(const Seen&)> use) const;

    const Interface& interface() const { return interface_; }
    const Shading& top() const { return top_; }
    /// The share of the radiance from behind the surface that all layers let through.
    const Vec3& behind() const { return behind_; }
    /// Whether that counts.
    bool is_clear() const { return clear_; }
    /// Whether all of it is reflected instead: then the top layer has the only reflection.
    bool reflects_totally() const { return total_; }

private:
    Vec3 kept(const Shading&) const;

    const World& world_;
    const Vertex& vertex_;
    std::span<const Layer> layers_;
    Interface interface_;
    Shading top_;
    Vec3 behind_ = Vec3(0);
    bool clear_ = false, total_ = false;
};

/// The share of light that a solid's inside leaves along the part of a path that ends at its
/// surface.
Vec3 left_inside(const World&, const PathState&, const Hit&);

}  // namespace candelabra
