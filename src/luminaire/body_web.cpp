// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/body_web.h"

#include "base/circle.h"
#include "base/elementary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Bodies with more different normals get a table.
constexpr std::size_t max_facets = 12;
/// Normals are the same if they differ by less.
constexpr double same_normal = 1e-6;
/// Cells of a table, by the angle to the y axis and around it.
constexpr std::size_t table_rows = 32, table_columns = 64;
/// Bodies whose area differs less than this from side to side, such as balls, need no table.
constexpr double alike = 0.02;
/// Directions that the bounds are found by: the factor may be greater between them.
constexpr int bound_directions = 4096;
constexpr double bound_room = 1.1;

/// Facets with the same normal as one; more than max_facets if there are more normals.
std::vector<Facet> merged(const std::vector<Facet>& facets) {
    std::vector<Facet> result;
    for (const Facet& facet : facets) {
        const auto same = std::ranges::find_if(result, [&](const Facet& other) {
            return dot(facet.normal - other.normal, facet.normal - other.normal) <
                   same_normal * same_normal;
        });
        if (same != result.end())
            same->area += facet.area;
        else
            result.push_back(facet);
        if (result.size() > max_facets) break;
    }
    return result;
}

double facing_area(const std::vector<Facet>& facets, const Vec3& direction) {
    double sum = 0;
    for (const Facet& facet : facets)
        sum += facet.area * std::fmax(dot(facet.normal, direction), 0);
    return sum;
}

Vec3 spread_direction(int i, int count) {
    constexpr double turn = 0.6180339887498949;
    return at_height(1 - (2 * i + 1.0) / count, i * turn - std::floor(i * turn));
}

}  // namespace

WebbedBody::WebbedBody(Handle<PhotometricWeb> web, const FacetedBody& body)
    : web_(std::move(web)), facets_(merged(body.facets)), round_(body.round / 4) {
    const std::vector<Facet>& facets = body.facets;
    if (facets_.size() > max_facets) {
        facets_.clear();
        for (std::size_t row = 0; row <= table_rows; ++row)
            for (std::size_t column = 0; column < table_columns; ++column) {
                const auto [sine, cosine] =
                    math::sin_cos(pi * static_cast<double>(row) / table_rows);
                const Vec2 round = on_circle(2 * pi * static_cast<double>(column) / table_columns);
                facing_.push_back(facing_area(facets, {sine * round.x, cosine, sine * round.y}));
            }
    }
    if (!facing_.empty()) {
        const auto [low, high] = std::ranges::minmax(facing_);
        if (high < (1 + alike) * low) {
            round_ += 0.5 * (low + high);
            facing_.clear();
        }
    }
    double most = 0;
    for (int i = 0; i < bound_directions; ++i)
        most = std::fmax(most, facing(spread_direction(i, bound_directions)));
    least_ = std::fmax(least_area * most, 1e-300);
    double sum = 0;
    const auto bound = [&](const Vec3& direction) {
        const double here = factor(direction);
        greatest_ = std::fmax(greatest_, here);
        return here;
    };
    for (int i = 0; i < bound_directions; ++i) sum += bound(spread_direction(i, bound_directions));
    // Beams narrower than the directions above have their greatest intensity at an entry.
    for (const double h : web_->horizontal())
        for (const double v : web_->vertical()) bound(direction_of(web_->type(), {v, h}));
    mean_share_ = greatest_ > 0 ? std::fmax(sum / bound_directions / greatest_, 1e-3) : 1;
    greatest_ *= bound_room;
}

double WebbedBody::facing(const Vec3& direction) const {
    if (facing_.empty()) return round_ + facing_area(facets_, direction);
    const double polar = math::acos(std::clamp(direction.y, -1.0, 1.0)) / pi * table_rows;
    double round = math::atan2(direction.z, direction.x) / (2 * pi) * table_columns;
    if (round < 0) round += table_columns;
    const auto row = std::min(static_cast<std::size_t>(polar), table_rows - 1);
    const auto column = static_cast<std::size_t>(round);
    const double down = polar - static_cast<double>(row),
                 along = round - static_cast<double>(column);
    const auto at = [&](std::size_t r, std::size_t c) {
        return facing_[r * table_columns + c % table_columns];
    };
    const auto mixed = [&](std::size_t r) {
        return (1 - along) * at(r, column) + along * at(r, column + 1);
    };
    return round_ + (1 - down) * mixed(row) + down * mixed(row + 1);
}

double WebbedBody::factor(const Vec3& direction) const {
    return web_->intensity(direction) / std::fmax(facing(direction), least_);
}

BodyWeb::BodyWeb(const AimedWeb& web, const std::vector<Facet>& facets)
    : BodyWeb(web, make_handle<WebbedBody>(web.shared_web(), FacetedBody{in_frame(web, facets)})) {}

std::vector<Facet> in_frame(const AimedWeb& web, std::vector<Facet> facets) {
    for (Facet& facet : facets) facet.normal = web.own(facet.normal);
    return facets;
}

}  // namespace candelabra
