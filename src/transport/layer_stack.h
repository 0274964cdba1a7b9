// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a texture at a hit of a path: each is seen through those above it, and all of them
// together let light through from behind the surface. All integrators follow these rules of POV-Ray
// 3.7.
#pragma once

#include "base/function_ref.h"
#include "transport/path.h"
#include "transport/vertex.h"

#include <span>

namespace candelabra {

class LayerStack {
public:
    /// The layers at a vertex that the path has met.
    LayerStack(const World&, const PathState&, const Vertex&, std::span<const Layer>);

    /// One layer, as it is seen through those above it.
    struct Seen {
        Shading shading;
        Vec3 through = Vec3(1);  ///< fraction of its radiance that the layers above transmit
        double weight = 1;       ///< grey of `through`
        /// Fraction of the radiance from the mirror direction, without the factor `through`.
        Vec3 reflected = Vec3(0);
        /// Factor on the diffuse part. Where energy is kept, a finish with `conserve_energy` has at
        /// most what its reflection and the light from behind leave.
        double diffuse = 1;

        /// The shading with that factor, for a BSDF.
        Shading scattering() const {
            Shading s = shading;
            s.opacity *= diffuse;
            return s;
        }
    };
    /// Calls use(layer) from the top down to the last layer that matters.
    void visit(FunctionRef<void(const Seen&)> use) const;

    const Interface& interface() const { return interface_; }
    const Shading& top() const { return top_; }
    /// Fraction of the radiance from behind the surface that all layers transmit.
    const Vec3& behind() const { return behind_; }
    /// Whether that fraction is large enough to matter.
    bool is_clear() const { return clear_; }
    /// Whether all of it is reflected instead; then only the top layer has a reflection.
    bool reflects_totally() const { return total_; }

private:
    const World& world_;
    const Vertex& vertex_;
    std::span<const Layer> layers_;
    Interface interface_;
    Shading top_;
    Vec3 behind_ = Vec3(0);
    bool clear_ = false, total_ = false;
};

/// Fraction of light from behind that the surface at a hit transmits to a ray that goes straight
/// through it, as shadow rays and photons do before their target. In integrators that keep energy
/// it is what a refracted ray would see behind the surface: Fresnel's reflection is the same from
/// both sides, for the angle on the side of the lower index. `solids` contain the ray to the hit.
Vec3 passed_straight(const World&, const Ray&, const Hit&, std::span<const PrimitiveIndex> solids);

/// Fraction of light that a solid's interior transmits along the segment of a path that ends at the
/// solid's surface.
Vec3 left_inside(const World&, const PathState&, const Hit&);

}  // namespace candelabra
