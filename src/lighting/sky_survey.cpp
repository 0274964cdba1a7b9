// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/sky_survey.h"

#include "base/circle.h"
#include "base/cosine_direction.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

/// A direction as a diffuse surface, or a point in the air, scatters.
Vec3 scattered(const Receiver& point, const Vec2& u) {
    if (point.horizon == Horizon::none) return at_height(1 - 2 * u.x, u.y);
    const bool below = point.horizon == Horizon::both_sides && u.x < 0.5;
    const double x = point.horizon == Horizon::both_sides ? 2 * u.x - (below ? 0 : 1) : u.x;
    return cosine_direction(below ? -point.normal : point.normal, {x, u.y});
}

double scattering_density(const Receiver& point, double cosine) {
    if (point.horizon == Horizon::none) return 1 / (4 * pi);
    return std::fmax(cosine, 0) / (point.horizon == Horizon::both_sides ? 2 * pi : pi);
}

/// Density of the directions in which direct light of the sky is sampled: either where the sky is
/// bright, or as a diffuse surface scatters.
double density_of_draws(const ChoosableSky& sky, const Receiver& point, const Vec3& direction,
                        double cosine) {
    return 0.5 * (sky.density(direction) + scattering_density(point, cosine));
}

}  // namespace

SkySurvey::SkySurvey(const ChoosableSky& sky, std::span<const SkyRay> rays) {
    double square = 0;
    for (const SkyRay& ray : rays) {
        const Receiver& point = ray.from->point;
        const double cosine = point.cosine(ray.direction), irradiance = ray.luminance * cosine;
        mean_ += irradiance / ray.chance;
        square += irradiance * irradiance /
                  (density_of_draws(sky, point, ray.direction, cosine) * ray.chance);
        for (int axis = 0; axis < 3; ++axis) {
            const double along = ray.direction[axis];
            facing_[2 * static_cast<std::size_t>(axis) + (along < 0)] +=
                ray.luminance * std::abs(along) / ray.chance;
        }
    }
    root_ = std::fmax(std::sqrt(square), mean_);
}

DrawnLight SkySurvey::at(const Receiver& point) const {
    if (point.horizon == Horizon::none) return there();
    double irradiance = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = point.normal[axis];
        const std::size_t first = 2 * static_cast<std::size_t>(axis), behind = along < 0;
        irradiance += along * along * facing_[first + behind];
        if (point.horizon == Horizon::both_sides)
            irradiance += along * along * facing_[first + 1 - behind];
    }
    return {irradiance, mean_ > 0 ? root_ / mean_ * irradiance : 0};
}

SkySurvey brighter(const SkySurvey& a, const SkySurvey& b) {
    SkySurvey result = a;
    for (std::size_t i = 0; i < result.facing_.size(); ++i)
        result.facing_[i] = std::fmax(a.facing_[i], b.facing_[i]);
    result.mean_ = std::fmax(a.mean_, b.mean_);
    result.root_ = std::fmax(a.root_, b.root_);
    return result;
}

std::vector<SkyRay> rays_to_sky(const ChoosableSky& sky, std::span<const SurveyPlace> places,
                                const LightProbe& probe) {
    std::vector<SkyRay> rays;
    for (std::uint32_t i = 0; i < tuning::sky_rays; ++i) {
        const auto number = [&](SkyDraw draw) { return survey_number(i, draw); };
        const SurveyPlace& from = places[i % places.size()];
        const Vec2 u{number(SkyDraw::u), number(SkyDraw::v)};
        const Vec3 direction = number(SkyDraw::way) < 0.5 ? sky.draw(u) : scattered(from.point, u);
        const double cosine = from.point.cosine(direction);
        if (!(cosine > 0)) continue;
        const double left = look_along({from.point.position, direction}, from.tolerance, probe,
                                       [](const ProbeHit&, double) { return false; });
        if (left > 0)
            rays.push_back(
                {&from, direction, left * sky.luminance(direction),
                 tuning::sky_rays * density_of_draws(sky, from.point, direction, cosine)});
    }
    return rays;
}

SharedDraw shared_draw(const DrawnLight& sky, const std::optional<DrawnLight>& lamps) {
    SharedDraw result;
    const DrawnLight others = lamps.value_or(DrawnLight());
    const double roots = sky.root + others.root;
    const double best = roots > 0 ? sky.root / roots : 0.5;
    constexpr double least = tuning::min_of_either;
    result.sky = lamps ? std::clamp(best, least, 1 - least) : 1;
    result.mean = sky.mean + others.mean;
    const double square = sky.root * sky.root / result.sky +
                          (lamps ? others.root * others.root / (1 - result.sky) : 0);
    result.noise =
        result.mean > 0 ? std::fmax(square / (result.mean * result.mean) - 1, 0) : INFINITY;
    return result;
}

}  // namespace candelabra
