// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/transmittance.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Sample points of one estimate of an optical depth, per unit of the expected depth, and their
/// maximum. The expected depth is at least a fraction of the greatest depth, since densities are
/// mostly far below their bounds.
constexpr double points_per_depth = 1, max_points = 8, share_of_greatest = 0.1;
/// Maximum number of segments into which a longer interval is divided.
constexpr double max_parts = 16;
/// Number of terms after which each term may be the last.
constexpr double long_series = 64;
/// Maximum optical depths for the series, and for tracking, which takes as many steps even where
/// nearly all of the segment is clear. Only segments to the end of the air are deeper.
constexpr double max_series = 64, max_tracked = 4096;
/// Optical depth below which the series may end before its first term.
constexpr double thin = 0.005;
/// A term of the series that is smaller than one over this may be the last.
constexpr double kept_terms = 2;

/// Transmittance by ratio tracking (Novak, Selle and Jarosz, "Residual Ratio Tracking for
/// Estimating Attenuation in Participating Media", 2014).
Rgb tracked(MediaView media, const MediaSegment& segment, double greatest,
            const PatternScene& scene, RandomStream& random) {
    Rgb left(1);
    double t = segment.from;
    while ((t -= math::log1p(-random.next()) / greatest) < segment.to) {
        left *= Rgb(1) - coefficients(media, segment.ray.at(t), scene).extinction / greatest;
        if (!survives(left, random)) return Rgb(0);
    }
    return left;
}

}  // namespace

double max_extinction(MediaView media) {
    double sum = 0;
    for (const Media* each : media)
        sum += max_component(abs(each->extinction()) * max_density(*each));
    return sum;
}

bool homogeneous(MediaView media) {
    return std::ranges::all_of(media, [](const Media* each) { return each->homogeneous(); });
}

bool survives(Rgb& left, RandomStream& random) {
    constexpr double little = 0.01, chance = 0.1;
    if (max_abs_component(left) >= little) return true;
    if (random.next() >= chance) return false;
    left /= chance;
    return true;
}

Rgb segment_transmittance(MediaView media, const MediaSegment& segment, double greatest,
                          const PatternScene& scene, RandomStream& random) {
    const double way = segment.to - segment.from, depth = greatest * way;
    if (!(depth > 0)) return Rgb(1);
    if (depth > max_tracked)
        return math::exp(-0.5 * way * (segment.extinction_from + segment.extinction_to));
    if (depth > max_series) return tracked(media, segment, greatest, scene, random);
    const Rgb pivot = -0.5 * way * (segment.extinction_from + segment.extinction_to);
    const double expected = std::fmax(max_abs_component(pivot), share_of_greatest * depth);
    const double points = std::ceil(std::clamp(points_per_depth * expected, 1.0, max_points));
    const auto estimate = [&] {
        const double shift = random.next();
        Rgb sum(0);
        for (double i = 0; i < points; ++i) {
            const double t = segment.from + way * (i + shift) / points;
            sum += coefficients(media, segment.ray.at(t), scene).extinction;
        }
        return -way / points * sum;
    };
    Rgb sum(1), term(1);
    double goes_on = std::min(1.0, depth / thin);
    for (double order = 1; random.next() < goes_on; ++order) {
        term *= (estimate() - pivot) / (order * goes_on);
        sum += term;
        goes_on = std::min(order < long_series ? 1.0 : 0.5, kept_terms * max_abs_component(term));
    }
    return math::exp(pivot) * sum;
}

Rgb transmittance(MediaView media, const Ray& ray, const Interval& way, const PatternScene& scene,
                  const Key& key) {
    const double length = way.max - way.min, greatest = max_extinction(media);
    if (!(greatest > 0)) return Rgb(1);
    const Rgb first = coefficients(media, ray.at(way.min), scene).extinction;
    if (homogeneous(media)) return math::exp(-length * first);
    const double parts = std::ceil(std::clamp(std::sqrt(greatest * length), 1.0, max_parts));
    RandomStream random(key, Purpose::media_transmittance);
    Rgb left(1);
    MediaSegment segment{ray, way.min, way.min, first, first};
    for (double i = 1; i <= parts; ++i) {
        segment.from = segment.to;
        segment.extinction_from = segment.extinction_to;
        segment.to = way.min + length * i / parts;
        segment.extinction_to = coefficients(media, ray.at(segment.to), scene).extinction;
        left *= segment_transmittance(media, segment, greatest, scene, random);
        if (!survives(left, random)) return Rgb(0);
    }
    return left;
}

}  // namespace candelabra
