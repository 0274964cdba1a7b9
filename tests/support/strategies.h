// SPDX-License-Identifier: GPL-3.0-or-later
// Every light sampling strategy, and a room with luminaires of all kinds to ask them about.
#pragma once

#include "lighting/sampler.h"
#include "support/choices.h"
#include "support/lights.h"

#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

/// Every alternative of LightSampler, and what one of them can ask for besides.
using Strategies =
    std::variant<EveryLight, ConstantAlpha, LinearAlpha, LightBvh, LightOctree, PaperOctree>;
static_assert(std::variant_size_v<Strategies> == std::variant_size_v<LightSampler> + 1);

/// Luminaires of all kinds in a room with some surfaces. A scaled room is the same in all but its
/// size.
struct Room {
    std::vector<Luminaire> luminaires;
    std::vector<Box> surfaces;
    double scale;

    Room(int count, std::uint64_t seed, double scaled = 1) : scale(scaled) {
        Draw draw(seed);
        for (int i = 0; i < count; ++i) {
            const Vec3 place = draw.point(4);
            const double size = std::pow(10, draw.between(-2, 0));
            luminaires.push_back(
                glowing(emitter(i % emitter_kinds, scale * place, scale * size, draw),
                        std::pow(10, draw.between(-1, 1.5))));
        }
        for (int i = 0; i < 6; ++i) {
            const Vec3 corner = scale * draw.point(4);
            surfaces.push_back({corner - scale * draw.number(), corner + scale * draw.number()});
        }
    }

    /// A point to be lit, mostly on a surface.
    Receiver point(Draw& draw) const {
        const Box& box = surfaces[static_cast<std::size_t>(draw.number() *
                                                           static_cast<double>(surfaces.size()))];
        const Vec3 within =
            glm::mix(box.low, box.high, Vec3(draw.number(), draw.number(), draw.number()));
        const Vec3 anywhere = scale * draw.point(6);
        const Vec3 position = draw.number() < 0.8 ? within : anywhere, normal = draw.direction();
        const double kind = draw.number();
        if (kind < 0.1) return {position, Vec3(0), Horizon::none};
        return {position, normal, lit_from(kind < 0.2)};
    }

    LightScene scene() const { return {choices(luminaires), surfaces}; }
};

/// The strategy itself, of which the settings of the light octree name two.
template <class Settings>
auto built_with(const Settings& settings, const LightScene& scene, int threads) {
    if constexpr (std::is_same_v<Settings, PaperOctree>)
        return BuiltPaperOctree(settings, scene, threads);
    else if constexpr (std::is_same_v<Settings, LightOctree>)
        return BuiltCutOctree(settings, scene);
    else
        return build(settings, scene, threads);
}

/// Settings with which a small room uses all that the strategy can do.
template <class T>
T settings() {
    T result;
    if constexpr (std::is_same_v<T, LightOctree>) result.cut = 6;
    if constexpr (std::is_same_v<T, PaperOctree>) {
        result.threshold = 0.01;
        result.max_bright = 6;
    }
    return result;
}

inline Key key_of(std::uint64_t pixel, int trial) {
    return {pixel, static_cast<std::uint32_t>(trial), 0, 0};
}

/// What a strategy answers to a receiver whose scattering and surroundings are not known.
template <class Built>
class Asked {
public:
    Asked(const Built& built, const Receiver& point)
        : point_(point), answer_(built.at({point_, lobes_, nullptr, nullptr})) {}
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;

    /// The luminaires that are picked with this key.
    LightPicks picks(const Key& key) const {
        LightSamples samples;
        answer_.sample(key, samples);
        return samples.picks;
    }
    double expected(const Key& key, LightIndex light) const { return answer_.expected(key, light); }

private:
    Receiver point_;
    BsdfLobes lobes_;
    decltype(std::declval<const Built&>().at(std::declval<const LightQuery&>())) answer_;
};

}  // namespace candelabra
