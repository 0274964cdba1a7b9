// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_faces.h"

#include "base/ray.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Ratio of squared diagonal to squared distance above which a face is sampled by solid angle;
/// below, sampling by area is as good.
constexpr double large = 0.1;
/// Points nearer to the plane of a face than this, relative to all lengths, count as on it: only
/// rounding decides on which side they are.
constexpr double surface = 1e-9;
/// Sine that is added to a face's elevation, so that faces seen along the surface have a weight
/// too: they may light surfaces that are not matt.
constexpr double min_height = 0.05;

/// The part of a side that may be above the horizon, as fractions of the side; the maximum height
/// at a fraction is height + fraction * rise.
Interval above_horizon(double height, double rise) {
    if (rise == 0) return height > 0 ? Interval{0, 1} : Interval{1, 0};
    const double level = -height / rise;
    if (rise > 0) return {std::fmax(level - surface, 0), 1};
    return {0, std::fmin(level + surface, 1)};
}

}  // namespace

bool SeenFaces::Face::rise_above(const Vec3& from, const Vec3& normal) {
    const double height = dot(normal, corner - from), rise1 = dot(normal, side1),
                 rise2 = dot(normal, side2);
    const Interval part1 = above_horizon(height + std::fmax(rise2, 0), rise1),
                   part2 = above_horizon(height + std::fmax(rise1, 0), rise2);
    if (!(part1.min < part1.max && part2.min < part2.max)) return false;
    corner += part1.min * side1 + part2.min * side2;
    side1 *= part1.max - part1.min;
    side2 *= part2.max - part2.min;
    return true;
}

double SeenFaces::Face::height(const Vec3& from, const Vec3& normal) const {
    double sum = 0;
    for (const Vec3& end : {corner, corner + side1, corner + side2, corner + side1 + side2})
        sum += std::fmax(dot(normal, unit(end - from)), 0);
    return sum / 4;
}

double SeenFaces::weight(Face& f, const Vec3* normal) const {
    if (normal && !f.rise_above(from_, *normal)) return 0;
    // Solid angle of the face: exact, or as seen from its middle.
    const Vec3 offset = f.corner + 0.5 * (f.side1 + f.side2) - from_;
    const double distance2 = dot(offset, offset), distance = std::sqrt(distance2);
    const double side2 = dot(f.side1, f.side1) + dot(f.side2, f.side2);
    const bool is_large = side2 > large * distance2;
    double weight = std::abs(dot(cross(f.side1, f.side2), offset)) / (distance2 * distance);
    if (is_large && std::abs(dot(f.side1, f.side2)) < 1e-12 * side2) {
        const SphericalRectangle near(from_, f.corner, f.side1, f.side2);
        if (near.solid_angle() > 1e-3) {
            weight = near.solid_angle();
            f.near = near;
        }
    }
    if (!normal) return weight;
    return weight * (min_height + (is_large ? f.height(from_, *normal)
                                            : std::fmax(dot(*normal, offset) / distance, 0)));
}

SeenFaces::SeenFaces(const Box& box, const Transform* map, const Vec3& from, const Vec3* normal)
    : from_(from) {
    const Vec3 here = map ? map->inverse_point(from) : from, size = box.size();
    const double margin = surface * (max_component(size) + max_abs_component(here));
    const bool within = contains({box.low - margin, box.high + margin}, here);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const double beyond = high ? here[axis] - box.high[axis] : box.low[axis] - here[axis];
            if (!(within ? beyond < -margin : beyond > margin)) continue;
            Face& f = face_[face(axis, high)];
            f.corner = box.low;
            if (high) f.corner[axis] = box.high[axis];
            f.side1[(axis + 1) % 3] = size[(axis + 1) % 3];
            f.side2[(axis + 2) % 3] = size[(axis + 2) % 3];
            if (map) {
                f.corner = map->point(f.corner);
                f.side1 = map->direction(f.side1);
                f.side2 = map->direction(f.side2);
            }
            sum += share_[face(axis, high)] = weight(f, normal);
        }
    any_ = sum > 0;
    for (double& share : share_) share = any_ ? share / sum : 0;
}

double SeenFaces::density(int face, const Vec3& direction, double distance) const {
    if (!(share_[face] > 0)) return 0;
    const Face& f = face_[face];
    if (f.near) return share_[face] / f.near->solid_angle();
    const double seen = std::abs(dot(cross(f.side1, f.side2), direction));
    return seen > 0 ? share_[face] * distance * distance / seen : 0;
}

std::optional<SeenFaces::Drawn> SeenFaces::draw(Vec2 u) const {
    int last = 0;
    for (int face = 0; face < 6; ++face) {
        if (!(share_[face] > 0)) continue;
        last = face;
        if (u.x < share_[face]) break;
        u.x -= share_[face];
    }
    u.x = std::fmin(u.x / share_[last], 1 - 0x1p-53);
    const Face& f = face_[last];
    const Vec3 position = f.near ? f.near->sample(u) : f.corner + u.x * f.side1 + u.y * f.side2;
    const Vec3 offset = position - from_;
    const double distance = length(offset);
    if (!(distance > 0)) return {};
    const Vec3 direction = offset / distance;
    const double found = density(last, direction, distance);
    if (!(found > 0)) return {};
    return Drawn{last, {position, direction, distance, found}};
}

}  // namespace candelabra
