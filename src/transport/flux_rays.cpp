// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/flux_rays.h"

#include "light/spreading.h"
#include "lighting/draw.h"
#include "photometry/light_colour.h"
#include "transport/source_rays.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candelabra {

bool sends_flux(const World& world, std::uint32_t source) {
    const PointLight& light = world.lights.sources[source];
    return has_flux(light) && !light.shadowless && world.lights.reach[source].group == 0;
}

FluxRays::FluxRays(const World& world) : world_(world) {
    std::vector<double> weights;
    for (std::uint32_t i = 0; i < world.lights.sources.size(); ++i) {
        const PointLight& light = world.lights.sources[i];
        weights.push_back(sends_flux(world, i) ? std::fmax(light_luminance(light.colour), 0) *
                                                     filled_steradians(light)
                                               : 0);
        light_ += weights.back();
    }
    places_ = WeightedIndex(weights);
}

std::optional<FluxRay> FluxRays::draw(const Key& key) const {
    const std::uint32_t source = places_.at_share(uniform(key, Purpose::sender_choice));
    const PointLight& light = world_.lights.sources[source];
    const LightCone cone = cone_around(light);
    const Vec3 direction = direction_in_cone(cone, place_on_light(key));
    FluxRay drawn{source, {}, Rgb(0)};
    PathState& path = drawn.path;
    path.ray = {light.location, direction};
    if (light.is_area()) path.ray.origin = drawn_grid_point(light, place_in_grid(key), -direction);
    const Handle<Composite>& window = world_.lights.reach[source].window;
    const auto any = [](std::uint32_t) { return true; };
    if (window && !window->first(path.ray, Interval{0}, any)) return std::nullopt;
    const double chance = places_.share_of(source);
    // At a unit of distance, the colour is that of the intensity.
    drawn.power =
        cone.steradians() / chance * incidence(light, path.ray.origin, path.ray.at(1)).colour;
    path.kind = RayKind::gathering;
    path.key = key;
    path.media = world_.containing(path.ray.origin);
    return drawn;
}

}  // namespace candelabra
