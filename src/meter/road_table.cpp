// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/road_table.h"

#include "base/between.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace candelabra {

namespace {

bool rises(const std::vector<double>& list, double most) {
    // No number is beside one that is none.
    const auto falls = [](double a, double b) { return !(a < b); };
    return !list.empty() && list.front() >= 0 && list.back() <= most &&
           std::ranges::adjacent_find(list, falls) == list.end();
}

}  // namespace

double RoadTable::coefficient(const Vec3& up, const Vec3& sight, const Vec3& light) const {
    const double cosine = dot(light, up);
    if (!(cosine > 0)) return 0;
    const Vec3 ahead = sight - dot(sight, up) * up, incoming = light - cosine * up;
    const double tangent = length(incoming) / cosine;
    if (!(tangent <= tangents.back())) return 0;
    const double lengths = length(ahead) * length(incoming);
    const double beta =
        lengths > 0 ? math::acos(std::clamp(dot(ahead, incoming) / lengths, -1.0, 1.0)) : 0;
    const Between row = place_between(tangents, tangent),
                  column = place_between(angles, beta * (180 / std::numbers::pi));
    const auto in_row = [&](std::size_t number) {
        return column.of(std::span(entries).subspan(number * angles.size(), angles.size()));
    };
    const double entry = (1 - row.fraction) * in_row(row.low) + row.fraction * in_row(row.high);
    return 1e-4 * entry / (cosine * cosine * cosine);
}

std::string problem(const RoadTable& table) {
    constexpr double most_tangent = 1000, most_entry = 1e6;
    if (!rises(table.angles, 180))
        return "the first row has the angles beta, which rise strictly from 0 to 180 degrees";
    if (!rises(table.tangents, most_tangent))
        return "the first column has tangents of angles of incidence, which rise strictly from 0";
    const auto wrong = [](double entry) { return !(entry >= 0 && entry <= most_entry); };
    if (std::ranges::any_of(table.entries, wrong))
        return "entries are numbers from 0 to 1000000, 10000 times r";
    return {};
}

}  // namespace candelabra
