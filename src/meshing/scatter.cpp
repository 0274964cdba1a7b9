// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/scatter.h"

#include "base/random.h"
#include "base/work_watch.h"
#include "shape/mesh_area.h"
#include "shape/tessellation.h"

#include <algorithm>
#include <unordered_map>

namespace candelabra {

namespace {

/// Number of darts per square of the distance. Doubling it would place about one percent more
/// points.
constexpr double darts = 24;

/// Points by the cube that contains them; the side of a cube is the distance.
class Cubes {
public:
    explicit Cubes(double distance) : distance_(distance) {}

    bool near(const Vec3& p, double distance) const {
        const Vec3 cube = glm::floor(p / distance_);
        for (int i = 0; i < 27; ++i) {
            const auto found = cubes_.find(key(cube + Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
            if (found == cubes_.end()) continue;
            for (const Vec3& other : found->second)
                if (length(other - p) < distance) return true;
        }
        return false;
    }
    void add(const Vec3& p) { cubes_[key(glm::floor(p / distance_))].push_back(p); }

private:
    static std::uint64_t key(const Vec3& cube) {
        const auto whole = [](double x) {
            return static_cast<std::uint64_t>(
                static_cast<std::int64_t>(std::clamp(x, -1e15, 1e15)));
        };
        return mix(whole(cube.x) + mix(whole(cube.y) + mix(whole(cube.z))));
    }

    double distance_;
    std::unordered_map<std::uint64_t, std::vector<Vec3>> cubes_;
};

}  // namespace

std::vector<SurfacePoint> scattered(const Composite& surface, const Mesh& triangles,
                                    double distance, std::uint64_t seed) {
    std::vector<SurfacePoint> points;
    const MeshArea area(triangles);
    if (!(area.total() > 0)) return points;
    const double count = std::ceil(darts * area.total() / (distance * distance)) + darts;
    Cubes taken(distance);
    Key key{mix(seed)};
    for (double thrown = 0; thrown < count; ++thrown) {
        ++key.pixel;
        count_work(6);
        const std::size_t number = area.at(uniform(key, Purpose::scatter_face)).index;
        const auto corners = face(triangles, number).corners;
        const Vec2 u(uniform(key, Purpose::scatter_u), uniform(key, Purpose::scatter_v));
        const auto [dart, across] = sample_area(Triangle{corners[0], corners[1], corners[2]}, u);
        // Skips the test of the surface where there is no room anyway.
        if (taken.near(dart, 0.9 * distance)) continue;
        const auto met = surface_near(surface, corners, dart, [](std::uint32_t) { return true; });
        if (!met) continue;
        const double reach = length(corners[1] - corners[0]) + length(corners[2] - corners[0]);
        const Vec3 position = dart + (met->t - reach) * across;
        if (taken.near(position, distance)) continue;
        taken.add(position);
        points.push_back({position, met->normal});
    }
    return points;
}

}  // namespace candelabra
