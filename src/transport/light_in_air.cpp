// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_in_air.h"

#include "base/elementary.h"
#include "transport/light_left.h"
#include "world/volumes.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Fraction of the places that are drawn by the distance that light gets.
constexpr double by_distance = 0.5;

bool scatters(std::span<const Media> media) {
    return std::ranges::any_of(media, [](const Media& each) { return each.scatters(); });
}

/// Whether media scatter light alike in all directions.
bool is_even(const Media& media) {
    return !media.scatters() ||
           static_cast<PhaseKind>(media.scattering.type) == PhaseKind::isotropic;
}

/// Places about the point of a line that is nearest to a centre: their density falls with the
/// square of the distance from a point beside it.
class PlacesAbout {
public:
    PlacesAbout(const Ray& ray, double end, const LitRegion& region)
        : middle_(dot(region.centre - ray.origin, ray.direction)),
          wide_(std::fmax(length(ray.at(middle_) - region.centre), region.radius)),
          first_(math::atan(-middle_ / wide_)),
          angle_(math::atan((end - middle_) / wide_) - first_) {}

    double distance(double u) const {
        const double angle = first_ + u * angle_;
        return middle_ + wide_ * math::sin(angle) / math::cos(angle);
    }
    double density(double distance) const {
        const double away = distance - middle_;
        return angle_ > 0 ? wide_ / (angle_ * (away * away + wide_ * wide_)) : 0;
    }

private:
    double middle_, wide_, first_, angle_;
};

}  // namespace

bool stands_for_scattering(const World& world) {
    if (!world.facts.has_media || !world.sky.fogs.empty() || !world.sky.rainbows.empty() ||
        !world.photon_targets.empty())
        return false;
    bool found = scatters(world.sky.media), even = std::ranges::all_of(world.sky.media, is_even),
         inside = false;
    for (const Material& material : world.appearance.materials) {
        if (!material.interior || !scatters(material.interior->media)) continue;
        if (material.no_shadow) return false;
        found = inside = true;
        even &= std::ranges::all_of(material.interior->media, is_even);
    }
    if (inside && has_openings(world)) return false;
    // The direction from which light of such a source comes is not that of its path.
    const auto is_wide = [](const PointLight& light) {
        return light.is_area() || light.disc_edge < 1;
    };
    return found && (even || std::ranges::none_of(world.lights.sources, is_wide));
}

bool lamps_light_air(const World& world) {
    const auto glows = [](const Media& media) {
        return media.emission != Rgb(0) && !media.luminaire;
    };
    return !world.facts.has_other_sky && std::ranges::none_of(world.sky.media, glows) &&
           std::ranges::none_of(world.appearance.materials, [&](const Material& material) {
               return material.interior && std::ranges::any_of(material.interior->media, glows);
           });
}

std::optional<PlaceOnLine> place_on_line(MediaView media, const Ray& ray, double distance,
                                         const LitRegion& region, const PatternScene& scene,
                                         const Key& key) {
    const double end = std::fmin(distance, end_of_air);
    if (!(end > 0)) return std::nullopt;
    const PlacesAbout about(ray, end, region);
    const double rate = grey(coefficients(media, ray.origin, scene).extinction);
    const double reached = rate > 0 ? -math::expm1(-rate * end) : 0;
    const double share = reached > 0 ? by_distance : 0;
    const double u = uniform(key, Purpose::media_distance);
    double place = u < share ? -math::log1p(-reached * (u / share)) / rate
                             : about.distance((u - share) / (1 - share));
    place = std::clamp(place, 0.0, end);
    double density = (1 - share) * about.density(place);
    if (share > 0) density += share * rate * math::exp(-rate * place) / reached;
    if (!(density > 0)) return std::nullopt;
    return PlaceOnLine{place, 1 / density};
}

}  // namespace candelabra
