// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/places.h"

#include "base/elementary.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Nearest whole number, from 1 up to more than a meter may have.
std::size_t whole(double number) {
    const double most = 2.0 * most_meter_places;
    return static_cast<std::size_t>(std::clamp(std::round(number), 1.0, most));
}

/// Least number of equal steps that are no longer than `longest`.
std::size_t steps_of(double length, double longest) {
    constexpr double rounding = 1e-9;
    return whole(std::ceil(length / longest - rounding));
}

/// Where the planes of the meter face, and observers without an eye look.
Vec3 faced(const Meter& meter) {
    if (meter.direction) return unit(*meter.direction);
    if (meter.across == Vec3(0)) return unit(meter.up);
    const Vec3 normal = unit(cross(meter.along, meter.across));
    return dot(normal, meter.up) < 0 ? -normal : normal;
}

}  // namespace

GridCounts points_by_en_12464(double along, double across) {
    constexpr double strip = 2, widest = 10;
    const double longer = std::fmax(along, across), shorter = std::fmin(along, across);
    const double side = shorter > 0 && longer >= strip * shorter ? shorter : longer;
    const double step = std::fmin(0.2 * math::pow(5, math::log10(side)), widest);
    return {whole(along / step), whole(across / step)};
}

GridCounts points_by_en_13201(double along, double across, int lanes) {
    constexpr double near_lamps = 30, longest_step = 3, widest_step = 1.5;
    constexpr std::size_t usual_along = 10, least_across = 3;
    GridCounts counts;
    counts.along = along <= near_lamps ? usual_along : steps_of(along, longest_step);
    if (across > 0)
        counts.across = lanes > 0 ? least_across * static_cast<std::size_t>(lanes)
                                  : std::max(least_across, steps_of(across, widest_step));
    return counts;
}

GridCounts counts_of(const Meter& meter, double metres) {
    if (meter.counts) {
        const std::size_t along = whole(meter.counts->x), across = whole(meter.counts->y);
        return {along, meter.across == Vec3(0) ? 1 : across};
    }
    const double along = metres * length(meter.along), across = metres * length(meter.across);
    if (static_cast<GridRule>(meter.rule) != GridRule::en_13201)
        return points_by_en_12464(along, across);
    return points_by_en_13201(along, across,
                              meter.measures() == Quantity::luminance ? meter.lanes : 0);
}

std::vector<MeterPlace> places_of(const Meter& meter, double metres) {
    const Vec3 faces = faced(meter);
    std::vector<MeterPlace> places;
    for (const Vec3& point : meter.points) places.push_back({point, faces});
    if (meter.has_grid()) {
        const GridCounts counts = counts_of(meter, metres);
        if (counts.along > most_meter_places / counts.across) return {};
        const auto middle = [](std::size_t i, std::size_t count) {
            return (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        };
        const bool line = meter.across == Vec3(0);
        for (std::size_t j = 0; j < counts.across; ++j)
            for (std::size_t i = 0; i < counts.along; ++i)
                places.push_back({meter.corner + middle(i, counts.along) * meter.along +
                                      (line ? 0 : middle(j, counts.across)) * meter.across,
                                  faces});
    }
    if (places.size() > most_meter_places) return {};
    if (meter.eye)
        for (MeterPlace& place : places)
            if (place.position != *meter.eye) place.direction = unit(place.position - *meter.eye);
    return places;
}

}  // namespace candelabra
