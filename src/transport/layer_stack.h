// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a texture at a hit of a path: each is seen through those above it, and all of them
// together let light through from behind the surface. All integrators follow these rules of POV-Ray
// 3.7.
#pragma once

#include "base/function_ref.h"
#include "base/rgb.h"
#include "transport/path.h"
#include "transport/vertex.h"

#include <span>

namespace candelabra {

class LayerStack {
public:
    /// The layers at a vertex that the path has met.
    LayerStack(const World&, const PathState&, const Vertex&, const Layers&);

    /// One layer, as it is seen through those above it.
    struct Seen {
        Shading shading;
        Rgb through = Rgb(1);    ///< fraction of its radiance that the layers above transmit
        double weight = 1;       ///< grey of `through`
        /// Fraction of the radiance from the mirror direction: as in POV-Ray, without the factor
        /// `through`, but with it for a finish with `conserve_energy` where energy is kept.
        Rgb reflected = Rgb(0);
        /// Factor on the diffuse part. Where energy is kept, a finish with `conserve_energy` has at
        /// most what its reflection and the light from behind leave.
        double diffuse = 1;
        /// Factor on the light that facets and their base scatter: what the mirror of a finish with
        /// `conserve_energy` leaves, where energy is kept.
        Rgb below_mirror = Rgb(1);

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
    const Rgb& behind() const { return behind_; }
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
    Rgb behind_ = Rgb(0);
    bool clear_ = false, total_ = false;
};

/// The surfaces that a ray meets in turn if it goes straight through them, as shadow rays and
/// photons before their target do. In integrators that keep energy they transmit what a refracted
/// ray would see behind them: Fresnel's reflection is the same from both sides, for the angle on
/// the side of the lower index. Only the first surface is met at its real angle. Total reflection
/// takes the place of what passes, and does not count.
class StraightWay {
public:
    /// `bent`: the ray has passed other surfaces before. The arguments must outlive this.
    StraightWay(const World&, const Ray&, bool bent = false);

    /// Fraction of light from behind that the surface at a hit transmits. `solids` contain the ray
    /// to the hit.
    Rgb passed(const Hit&, std::span<const PrimitiveIndex> solids);
    /// The same of an object that casts no shadow, too: what a followed ray sees through it.
    Rgb seen(const Hit&, std::span<const PrimitiveIndex> solids);

private:
    Rgb seen(const Hit&, std::span<const PrimitiveIndex> solids, const Interface&);

    const World& world_;
    const Ray& ray_;
    bool bent_;
};

/// Fraction of light that a solid's interior transmits along the segment of a path that ends at the
/// solid's surface.
Rgb left_inside(const World&, const PathState&, const Hit&);

}  // namespace candelabra
