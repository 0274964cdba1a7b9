// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/seen_faces.h"

#include "base/random.h"

#include <cmath>

namespace candelabra {

namespace {

/// Points nearer to the plane of a face than this, relative to all lengths, count as on it: only
/// rounding decides on which side they are.
constexpr double surface = 1e-9;

}  // namespace

SeenFaces::SeenFaces(const Box& box, const Transform* map, const Vec3& from, const Vec3* normal) {
    const Vec3 here = map ? map->inverse_point(from) : from, size = box.size();
    const double margin = surface * (max_component(size) + max_abs_component(here));
    const bool within = contains({box.low - margin, box.high + margin}, here);
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const double beyond = high ? here[axis] - box.high[axis] : box.low[axis] - here[axis];
            if (!(within ? beyond < -margin : beyond > margin)) continue;
            Vec3 corner = box.low, side1(0), side2(0);
            if (high) corner[axis] = box.high[axis];
            side1[(axis + 1) % 3] = size[(axis + 1) % 3];
            side2[(axis + 2) % 3] = size[(axis + 2) % 3];
            if (map) {
                corner = map->point(corner);
                side1 = map->direction(side1);
                side2 = map->direction(side2);
            }
            const auto& seen = face_[face(axis, high)].emplace(corner, side1, side2, from, normal);
            sum += share_[face(axis, high)] = seen.weight();
        }
    any_ = sum > 0;
    for (double& share : share_) share = any_ ? share / sum : 0;
}

double SeenFaces::density(int face, const Vec3& direction, double distance) const {
    return share_[face] > 0 ? share_[face] * face_[face]->density(direction, distance) : 0;
}

std::optional<SeenFaces::Drawn> SeenFaces::draw(Vec2 u) const {
    int last = 0;
    for (int face = 0; face < 6; ++face) {
        if (!(share_[face] > 0)) continue;
        last = face;
        if (u.x < share_[face]) break;
        u.x -= share_[face];
    }
    u.x = std::fmin(u.x / share_[last], below_1);
    auto point = face_[last]->draw(u);
    if (!point) return {};
    point->density *= share_[last];
    return Drawn{last, *point};
}

}  // namespace candelabra
