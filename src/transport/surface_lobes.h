// SPDX-License-Identifier: GPL-3.0-or-later
// The ways on from a surface that a path has met: the lobes of its layers, and light from behind.
// Integrators and photons ask here how a path may go on; pov_ray follows all lobes, the others
// choose one at random.
#pragma once

#include "base/rgb.h"
#include "transport/layer_stack.h"
#include "transport/path_steps.h"

#include <optional>

namespace candelabra {

enum class LobeKind : std::uint8_t {
    mirror,   ///< a delta lobe
    facets,   ///< reflection by microfacets
    diffuse,  ///< in front of the surface, behind it, or both
    behind,   ///< a delta lobe: refraction, or straight through
    total     ///< total reflection of light that would come from behind
};

/// A set of lobes of layers.
struct LobeKinds {
    bool mirror = true, facets = true, diffuse = true;
};

struct Lobe {
    LobeKind kind = LobeKind::mirror;
    Shading shading = {};  ///< of the layer
    /// Factor on the radiance of the next ray, apart from that of the sampled direction.
    Rgb through = Rgb(1);
    /// Expected factor altogether: the fraction of uniform light that the lobe sends to the viewer.
    Rgb share = Rgb(0);
};

class SurfaceLobes {
public:
    /// The arguments must outlive this.
    SurfaceLobes(const World&, const ShadingRules&, const PathState&, const Vertex&,
                 const LayerStack&);

    /// Adds lobes of a layer.
    void add(const LayerStack::Seen&, const LobeKinds&);
    /// Adds light from behind all layers, if there is any. Of total reflection, it takes the place
    /// of what would pass, so that all lobes together have no more than all light.
    void add_behind();

    /// One of the lobes, chosen in proportion to the greatest channel of their shares.
    struct Choice {
        const Lobe& lobe;
        double chance;
    };
    /// `u` is in [0, 1). Nothing if there are no lobes.
    std::optional<Choice> choose(double u) const;

    /// Continues the path in a direction of the lobe, which is sampled. The throughput gets the
    /// factor of the direction, but not Lobe::through. Returns false if no light comes from there.
    bool follow(const Lobe&, PathState&) const;

private:
    bool follow_diffuse(const Shading&, PathState&) const;
    void follow_behind(const Shading&, PathState&) const;
    void follow_total(const Shading&, PathState&) const;

    const World& world_;
    const ShadingRules& rules_;
    const PathState& path_;
    const Vertex& vertex_;
    const LayerStack& stack_;
    ShortList<Lobe, 4> lobes_;
    bool adds_no_light_ = true;  ///< by what the finishes say; a debug build checks it
};

}  // namespace candelabra
