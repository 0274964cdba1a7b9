// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/phase_function.h"

#include "base/elementary.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Draws a cosine from a lobe in proportion to a power of (1 + cosine) / 2, mixed with a uniform
/// lobe that has the fraction `even`.
double even_or_power(double u, double even, double power) {
    if (u < even) return 2 * (u / even) - 1;
    return 2 * math::pow((u - even) / (1 - even), 1 / (power + 1)) - 1;
}

/// Draws the cosine between the view and a direction, in proportion to phase().
double drawn_cosine(const Scattering& s, double u) {
    switch (static_cast<PhaseKind>(s.type)) {
        case PhaseKind::mie_haze:
            return even_or_power(u, 0.5, 8);
        case PhaseKind::mie_murky:
            return even_or_power(u, 33.0 / 83, 32);
        case PhaseKind::rayleigh:
            return u < 0.75 ? 2 * (u / 0.75) - 1 : math::cbrt(2 * (u - 0.75) / 0.25 - 1);
        case PhaseKind::henyey_greenstein: {
            const double g = s.eccentricity;
            if (std::abs(g) < 1e-4) break;
            const double root = (1 - g * g) / (1 - g + 2 * g * u);
            return std::clamp((1 + g * g - root * root) / (2 * g), -1.0, 1.0);
        }
        case PhaseKind::isotropic:
            break;
    }
    return 2 * u - 1;
}

}  // namespace

bool collects_photons(MediaView media) {
    return std::ranges::any_of(media, [](const Media* each) { return each->scatters(); }) &&
           std::ranges::all_of(
               media, [](const Media* each) { return each->collect || !each->scatters(); });
}

PhaseFunction::PhaseFunction(MediaView media, const Vec3& position, const Vec3& view,
                             const PatternScene& scene, const Rgb& weight, LightInAir light)
    : position_(position), view_(view), collects_(collects_photons(media)) {
    for (const Media* each : media) {
        if (!each->scatters(light)) continue;
        const Rgb coefficient = weight * density(*each, position, scene) * each->scattering.colour *
                                unit_of_light(each->scattering);
        const double share = max_abs_component(coefficient) * mean_phase(each->scattering);
        if (!(share > 0)) continue;
        parts_.push_back({coefficient, &each->scattering, share});
        total_ += share;
        if (each->scattering.multiple) multiple_ += share;
    }
    if (total_ > 0) multiple_ /= total_;
    for (Part& part : parts_) part.share /= total_;
}

Rgb PhaseFunction::evaluate(const Vec3& to_light) const {
    const double cosine = dot(view_, to_light);
    Rgb sum(0);
    for (const Part& part : parts_) sum += part.evaluate(cosine);
    return sum;
}

Rgb PhaseFunction::mean() const {
    Rgb sum(0);
    for (const Part& part : parts_) sum += part.coefficient * mean_phase(*part.scattering);
    return sum;
}

double PhaseFunction::Part::draw_cosine(double u) const { return drawn_cosine(*scattering, u); }

double PhaseFunction::Part::pdf(double cosine) const {
    return phase(*scattering, cosine) / (4 * pi * mean_phase(*scattering));
}

const PhaseFunction::Part& PhaseFunction::chosen(double& u) const {
    std::size_t number = 0;
    while (number + 1 < parts_.size() && u >= parts_[number].share) u -= parts_[number++].share;
    u = std::fmin(u / parts_[number].share, below_1);
    return parts_[number];
}

const PhaseFunction::Part& PhaseFunction::part(double u) const { return chosen(u); }

Vec3 PhaseFunction::sample(Vec2 u) const {
    const Part& part = chosen(u.x);
    return turned_from(view_, part.draw_cosine(u.x), 2 * pi * u.y);
}

double PhaseFunction::pdf(const Vec3& direction) const {
    const double cosine = dot(view_, direction);
    double sum = 0;
    for (const Part& part : parts_)
        sum += part.share * phase(*part.scattering, cosine) / mean_phase(*part.scattering);
    return sum / (4 * pi);
}

}  // namespace candelabra
