// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sources.h"

#include "base/degrees.h"
#include "world/source_choices.h"

#include <algorithm>
#include <map>
#include <memory>

namespace candelabra {

namespace {

/// Radius of sources without size, as a fraction of the extent of all sources.
constexpr double min_radius = 1e-6;

bool same_direction_everywhere(const PointLight& light) {
    return light.along_axis() && light.kept_to() != parallel_beam;
}

/// Whether the light can be sampled: one with negative colour has no probability.
bool can_be_chosen(const PointLight& light) {
    return std::isfinite(light.colour.r + light.colour.g + light.colour.b) &&
           std::min({light.colour.r, light.colour.g, light.colour.b}) >= 0;
}

Falloff falloff(const PointLight& light) {
    Falloff result;
    // A fading from the source itself is only estimated: it is within a factor of 2 beyond 1.
    const bool from_source = light.fades_from_source && light.fade_distance == 0;
    result.fade_distance = from_source ? 1 : light.fade_distance;
    result.fade_power = light.fade_power;
    const double dark = light.falloff.value_or(45) * radians_per_degree,
                 bright = light.radius.value_or(30) * radians_per_degree;
    const bool turned = light.is_area() && light.area_illumination;
    if (light.web && !turned) {
        const AimedWeb web(light);
        result.axis = web.aim();
        result.dark = web.dark();
        result.bright = std::min(web.bright(), web.dark());
        return result;
    }
    if (light.kept_to() != cone || light.parallel || turned) return result;
    // Without a bright part, or with one that is wider than a half space, the cone has no edge but
    // that of the half space.
    const bool edged = bright < std::numbers::pi / 2 && bright >= 0 && dark >= 0;
    result.axis = unit(light.point_at - light.location);
    result.dark = edged ? std::clamp(dark, bright, std::numbers::pi / 2) : std::numbers::pi / 2;
    result.bright = edged ? bright : result.dark;
    return result;
}

/// Radius of a ball around all points that emit light; for a beam, around those where it starts.
double radius(const PointLight& light) {
    if (light.kept_to() == parallel_beam) return std::abs(light.falloff.value_or(1));
    if (!light.is_area() || !light.area_illumination) return 0;
    return length(light.area1) + length(light.area2);
}

ChoosableSource choosable(const PointLight& light) {
    // A light with one direction is a point of the sphere of directions.
    if (same_direction_everywhere(light))
        return {unit(light.location - light.point_at), 0, {}, luminance(light.colour)};
    return {light.location, radius(light), falloff(light), luminance(light.colour)};
}

class Sets {
public:
    Sets(std::span<const PointLight> lights, const LightSampler& sampler, std::size_t max_asked)
        : lights_(lights), settings_(sampler), max_asked_(max_asked) {}

    void add(std::uint32_t group, std::vector<std::uint32_t> members) {
        if (members.size() <= max_asked_ || !traits(settings_).draws) {
            result.push_back({group, std::move(members)});
            return;
        }
        std::vector<std::uint32_t> asked, placed, directed;
        for (const std::uint32_t i : members) {
            const PointLight& light = lights_[i];
            if (!can_be_chosen(light))
                asked.push_back(i);
            else if (light.colour != Rgb(0))
                (same_direction_everywhere(light) ? directed : placed).push_back(i);
        }
        if (!asked.empty()) result.push_back({group, std::move(asked)});
        add_drawn({group, std::move(placed)});
        SourceSet parallel{group, std::move(directed)};
        parallel.parallel = true;
        add_drawn(std::move(parallel));
    }

    std::vector<SourceSet> result;

private:
    void add_drawn(SourceSet set) {
        if (set.lights.empty()) return;
        if (set.lights.size() > max_asked_) {
            std::vector<ChoosableSource> sources;
            for (const std::uint32_t i : set.lights) sources.push_back(choosable(lights_[i]));
            give_size(sources);
            set.choices = std::make_shared<SourceChoices>(std::move(sources));
        }
        result.push_back(std::move(set));
    }

    /// Sets a minimum radius: without one, rounding would decide which sources are above a horizon.
    static void give_size(std::vector<ChoosableSource>& sources) {
        Box all;
        for (const ChoosableSource& source : sources) all = join(all, source.centre);
        const double least =
            min_radius * max_component(all.size()) + 1e-12 * max_abs_component(all.centre());
        for (ChoosableSource& source : sources)
            source.radius = std::max({source.radius, least, 1e-100});
    }

    std::span<const PointLight> lights_;
    const LightSampler& settings_;
    std::size_t max_asked_;
};

}  // namespace

std::vector<SourceSet> source_sets(std::span<const PointLight> lights,
                                   std::span<const std::uint32_t> group_of,
                                   const LightSampler& sampler, std::size_t max_asked) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
    for (std::uint32_t i = 0; i < lights.size(); ++i) groups[group_of[i]].push_back(i);
    Sets sets(lights, sampler, max_asked);
    for (auto& [group, members] : groups) sets.add(group, std::move(members));
    return std::move(sets.result);
}

LightScene light_scene(const SourceSet& set, const LightScene& of_luminaires) {
    LightScene scene = set.parallel ? LightScene() : of_luminaires;
    scene.lights = set.choices;
    return scene;
}

}  // namespace candelabra
