// SPDX-License-Identifier: GPL-3.0-or-later
// Reflected light as luminaires (the imposters of the paper's section 5): points of diffuse
// surfaces that light has come to, in a light hierarchy of their own, so that indirect light at a
// point takes one shadow ray. They light what is not too near; what is near is found by a ray of
// its own (Kollig and Keller, "Illumination in the Presence of Weak Singularities", 2004). Both
// together are unbiased over the generations.
#pragma once

#include "transport/generations.h"
#include "transport/light_path.h"

namespace candelabra {

/// The reflected luminaires of one generation, and the strategy that chooses among them.
struct ReflectedSet {
    std::vector<ReflectedLuminaire> list;
    std::vector<Luminaire> proxies;  ///< for the strategy, in the same order
    BuiltLightSampler sampler;
};

class ReflectedLuminaires {
public:
    /// The world outlives this. `count`: paths of light in a generation. `threads`: 0: one per
    /// core; nothing depends on it.
    ReflectedLuminaires(const World&, std::uint32_t count, int max_reflections, int seed,
                        int threads);

    /// Which generation serves a sample.
    static std::uint32_t generation_of(std::uint32_t sample);

    /// So many samples from a first one on are served from memory.
    static constexpr std::uint32_t samples_at_once = 32;

    std::shared_ptr<const ReflectedSet> generation(std::uint32_t number);
    /// Makes what samples from `first` to before `last` need, by all threads.
    void prepare(std::uint32_t first, std::uint32_t last);

    /// The greatest geometry term by which they light; the rest is looked for. It is found from
    /// light that lights nothing else. 0: nothing is lit by them.
    double bound() const { return bound_; }

private:
    std::vector<ReflectedLuminaire> sent(const LightPaths&, std::uint32_t count,
                                         std::uint64_t stream) const;
    ReflectedSet made(std::uint32_t number) const;
    void find_bound();

    const World& world_;
    int max_reflections_;
    LightPaths paths_;
    std::uint32_t count_;
    std::uint64_t seed_;
    int threads_;
    double bound_ = 0;
    Generations<ReflectedSet> generations_;
};

/// Null where the scene asks for none, or no luminaire lights it.
std::shared_ptr<ReflectedLuminaires> reflected_luminaires_of(const World&, int seed, int threads);

}  // namespace candelabra
