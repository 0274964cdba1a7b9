// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex from reflected luminaires.
#pragma once

#include "transport/light_ledger.h"
#include "transport/reflected_luminaires.h"

namespace candelabra {

/// Each job has its own: it keeps the generation that was used last.
class ReflectedLight {
public:
    ReflectedLight(const World& world, std::shared_ptr<ReflectedLuminaires> luminaires)
        : world_(world), luminaires_(std::move(luminaires)) {}

    explicit operator bool() const { return luminaires_ != nullptr; }

    /// Selects the generation that serves that sample of a pixel.
    void begin(std::uint32_t sample) { wanted_ = ReflectedLuminaires::generation_of(sample); }

    /// Radiance towards the viewer from a Lambertian layer, by light that arrives there after at
    /// most `reflections` reflections, by way of diffuse surfaces only, with the geometry term
    /// clamped to its bound. `throughput` is that of the layer's radiance, for the ledger.
    Vec3 operator()(const Vertex&, const Shading&, int reflections, const Vec3& throughput,
                    const Key&, LightLedger&);

    /// Fraction of the light from one surface to another that comes from reflected luminaires,
    /// given the cosines to their normals and the distance.
    double share(double cosine, double other_cosine, double distance) const;

    /// Builds the generations for samples from `first` to before `last`.
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
    std::uint32_t wanted_ = 0, generation_ = 0;  ///< to be used, and of set_
    LightSamples samples_;                       ///< kept as a member to reuse its memory
};

}  // namespace candelabra
