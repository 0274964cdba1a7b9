// SPDX-License-Identifier: GPL-3.0-or-later
// Path tracing: each sample follows one path, which continues from each vertex in one randomly
// chosen direction, and adds the direct light of light sources and luminaires at each vertex. So
// light counts after any number of reflections. The estimate is unbiased, and is the reference for
// the other methods of indirect light.
#pragma once

#include "base/rgb.h"
#include "transport/direct_light.h"
#include "transport/layer_stack.h"
#include "transport/participating_media.h"
#include "transport/photons.h"
#include "transport/reflected_light.h"
#include "transport/surface_lobes.h"
#include "transport/tracing.h"
#include "transport/white_element.h"

#include <optional>

namespace candelabra {

class PathTracedIntegrator {
public:
    PathTracedIntegrator(const Shot&, const Tracing&);

    Rgb radiance(const Ray& ray, const Key& key);
    /// Radiance that a white element shows. Without Tracing::from_anywhere it lies in the solids
    /// that contain the camera.
    Rgb element_radiance(const WhiteElement&, const Key&);

    LightLedger& ledger() { return ledger_; }
    const LightLedger& ledger() const { return ledger_; }
    double clear() const { return ends_.clear(); }

    /// Paths do not branch, and have a bounded number of vertices.
    static constexpr bool cut() { return false; }
    /// Builds the photons and reflected luminaires for a sample.
    void prepare(std::uint32_t sample) const {
        photons_.prepare(sample);
        reflected_.prepare(sample);
    }

private:
    PathState begin(const Ray&, const Key&);
    Rgb end();
    void trace(PathState);
    bool pass_air(PathState&, double distance);
    PathState scattered_path(const PathState&) const;
    bool at_vertex(PathState&, const Vertex&, const Layers&);
    bool ends_covered(PathState&, const Hit&, double distance) const;
    void gather(const PathState&, const Vertex&, const LayerStack::Seen&);
    bool goes_deeper(const PathState&) const;
    LobeKinds wanted_lobes(const PathState&) const;
    bool go_on(const SurfaceLobes&, const Vertex&, PathState&);

    const World& world_;
    ShadingRules rules_;
    ServedGeneration<Photons> photons_;
    DirectLight direct_light_;
    ReflectedLight reflected_;
    ParticipatingMedia media_;
    PathEnds ends_;
    LightLedger ledger_;
    Rgb sum_ = Rgb(0);  ///< radiance of the sample so far
    /// The part of the path that media have scattered away; nothing: they have not.
    std::optional<PathState> aside_;
    bool divided_ = false;  ///< the path has met a medium that could scatter it
    int max_bounces_;
    bool in_air_;               ///< reflected luminaires light media as well
    bool lamps_only_;           ///< all light is that of lamps for which they can stand
    bool others_;               ///< there is light that reflected luminaires do not stand for
    double chance_of_covered_;  ///< see ends_covered()
};

}  // namespace candelabra
