// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex that comes from reflected luminaires.
#pragma once

#include "transport/light_ledger.h"
#include "transport/reflected_luminaires.h"

namespace candelabra {

/// One for each job: it keeps the generation that was asked last.
class ReflectedLight {
public:
    ReflectedLight(const World& world, std::shared_ptr<ReflectedLuminaires> luminaires)
        : world_(world), luminaires_(std::move(luminaires)) {}

    explicit operator bool() const { return luminaires_ != nullptr; }

    /// From now on light is of that sample of a pixel, whose generation serves it.
    void begin(std::uint32_t sample) { wanted_ = ReflectedLuminaires::generation_of(sample); }

    /// Radiance towards the viewer by a lambertian layer: all that arrives there after so many
    /// reflections at most and by way of diffuse surfaces only, as far as the geometry term has its
    /// bound. `throughput` is of the layer's radiance, for the ledger.
    Vec3 operator()(const Vertex&, const Shading&, int reflections, const Vec3& throughput,
                    const Key&, LightLedger&);

    /// How much of the light that one surface sends to another comes from reflected luminaires: by
    /// the cosines to their normals and the distance.
    double share(double cosine, double other_cosine, double distance) const;

    /// Makes what samples from `first` to before `last` need.
    void prepare(std::uint32_t first, std::uint32_t last) const {
        if (luminaires_) luminaires_->prepare(first, last);
    }

private:
    Vec3 from(const ReflectedLuminaire&, const Vertex&, const Shading&) const;
    bool is_seen(const ReflectedLuminaire&, const Vertex&, const Vec3& direction,
                 double distance) const;

    const World& world_;
    ShadingRules rules_ = shading_rules(world_);
    std::shared_ptr<ReflectedLuminaires> luminaires_;
    std::shared_ptr<const ReflectedSet> set_;
    std::uint32_t wanted_ = 0, generation_ = 0;  ///< that is to serve, and that set_ is
    LightSamples samples_;                       ///< kept for its memory
};

}  // namespace candelabra
