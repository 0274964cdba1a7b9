// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/survey_places.h"

#include "base/circle.h"
#include "lighting/survey_draw.h"
#include "lighting/tuning.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace candelabra {

namespace {

/// A place in the cell for a trial, by numbers of its own for each way of searching.
Vec3 place_in(const Box& cell, std::uint32_t trial, std::uint32_t way) {
    const Vec3 place(survey_number(trial, way, CellDraw::place_x),
                     survey_number(trial, way, CellDraw::place_y),
                     survey_number(trial, way, CellDraw::place_z));
    return cell.low + place * cell.size();
}

/// Hits of the lines in a cell: outsides of solids that do not glow, which are seen most, then
/// surfaces that glow, then insides.
using Found = std::array<std::vector<SurveyPlace>, 3>;

template <class Line>
Found met_by(const Box& cell, const LightProbe& probe, const Line& line) {
    Found found;
    for (std::uint32_t i = 0; i < tuning::place_lines && found[0].size() < tuning::enough_places;
         ++i) {
        const Ray ray = line(i, place_in(cell, i, on_lines));
        const auto sight = probe(ray, 0);
        if (!sight) continue;
        const Vec3 position = ray.at(sight->distance);
        if (!contains(cell, position)) continue;
        const bool within = dot(sight->normal, ray.direction) > 0;
        const Receiver point{position, within ? -sight->normal : sight->normal};
        found[within ? 2 : (sight->light ? 1 : 0)].push_back({point, sight->tolerance});
    }
    return found;
}

/// Whether a surface that lets no light pass is on the ray before a place.
bool is_hidden(const Vec3& position, const Ray& ray, const LightProbe& probe) {
    const double distance = length(position - ray.origin);
    bool blocked = false;
    look_along(ray, 0, probe, [&](const ProbeHit& sight, double) {
        if (sight.distance >= distance) return true;
        blocked = sight.passes == 0;
        return blocked;
    });
    return blocked;
}

}  // namespace

std::vector<double> balanced(std::span<const double> arriving) {
    double least = INFINITY;
    for (const double light : arriving)
        if (light > 0) least = std::fmin(least, light);
    std::vector<double> result;
    for (const double light : arriving)
        result.push_back(light > tuning::max_counted * least ? tuning::max_counted * least / light
                                                             : 1);
    return result;
}

std::optional<Ray> Viewer::ray_to(const Vec3& place) const {
    if (eye) return Ray{*eye, unit(place - *eye)};
    if (!axis) return std::nullopt;
    const Vec3& along = axis->direction;
    return Ray{place - dot(place - axis->origin, along) * along, along};
}

std::vector<SurveyPlace> air_places_in(const Box& cell, const Viewer& viewer,
                                       const LightProbe& probe) {
    std::vector<SurveyPlace> seen, hidden;
    for (std::uint32_t i = 0; i < tuning::place_lines && seen.size() < tuning::enough_places; ++i) {
        const Vec3 position = place_in(cell, i, anywhere);
        const auto ray = viewer.ray_to(position);
        (ray && is_hidden(position, *ray, probe) ? hidden : seen)
            .push_back({{position, Vec3(0), Horizon::none}, 0});
    }
    if (!seen.empty()) return seen;
    hidden.resize(tuning::enough_places);
    return hidden;
}

std::vector<SurveyPlace> survey_places_in(const Box& cell, const Viewer& viewer,
                                          const LightProbe& probe) {
    if (viewer.ray_to(cell.centre())) {
        Found seen = met_by(
            cell, probe, [&](std::uint32_t, const Vec3& place) { return *viewer.ray_to(place); });
        if (!seen[0].empty()) return std::move(seen[0]);
    }
    Found found = met_by(cell, probe, [&](std::uint32_t i, const Vec3& place) {
        const double height = 2 * survey_number(i, on_lines, CellDraw::line_height) - 1;
        const double turn = survey_number(i, on_lines, CellDraw::line_turn);
        const double across = std::sqrt(1 - height * height);
        return Ray{place, Vec3(across * on_circle(2 * std::numbers::pi * turn), height)};
    });
    for (auto& kind : found)
        if (!kind.empty()) return std::move(kind);
    std::vector<SurveyPlace> all;
    for (std::uint32_t i = 0; i < tuning::enough_places; ++i)
        all.push_back({{place_in(cell, i, anywhere), Vec3(0, 1, 0), Horizon::both_sides}, 0});
    return all;
}

}  // namespace candelabra
