// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/area.h"

#include "shape/area.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using std::numbers::pi;

struct Lamp {
    std::string name;
    BuiltShape shape;
    bool solid;
};

/// A pyramid without its base, with normals that make it look round.
BuiltShape shade() {
    Mesh mesh;
    for (int i = 0; i < 4; ++i) {
        const Vec3 corner(i % 2 ? 0.7 : -0.7, -0.5, i / 2 ? 0.6 : -0.6);
        mesh.vertices.push_back(corner);
        mesh.normals.push_back(corner);
    }
    mesh.vertices.push_back(Vec3(0.1, 0.6, 0));
    mesh.normals.push_back(Vec3(0, 1, 0));
    mesh.faces = {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}};
    return Shared<BuiltMesh>(build(mesh));
}

const std::vector<Lamp>& lamps() {
    static const std::vector<Lamp> all = {
        {"box", Cuboid{Vec3(-1, -0.5, -0.3), Vec3(0.7, 0.5, 0.3)}, true},
        {"disc", Disc{Vec3(0.1, 0, 0), Vec3(1, 2, 0), 1, 0}, false},
        {"ring", Disc{Vec3(0.1, 0, 0), Vec3(0, 0, 1), 1, 0.5}, false},
        {"cylinder", Cylinder{Vec3(0, -1, 0), Vec3(0.2, 1, 0), 0.4, false}, true},
        {"tube", Cylinder{Vec3(0, -1, 0), Vec3(0.2, 1, 0), 0.4, true}, false},
        {"cone", Cone{Vec3(0, -1, 0), 0.8, Vec3(0, 1, 0), 0.2, false}, true},
        {"open cone", Cone{Vec3(0, -1, 0), 0.8, Vec3(0, 1, 0), 0, true}, false},
        {"sphere", Sphere{Vec3(0.2, 0, 0), 0.8}, true},
        {"shade", shade(), false},
    };
    return all;
}

std::vector<Handle<Transform>> maps() {
    const Transform turn = Transform::rotation(Vec3(20, 50, 70));
    return {nullptr, make_handle<Transform>(turn.then(Transform::translation(Vec3(0.3, 0.2, 0.1)))),
            make_handle<Transform>(Transform::scaling(Vec3(0.5, 1.5, -1)).then(turn))};
}

/// Cut-off of densities: they have poles at the rim, which sums over directions resolve slowly.
constexpr double highest = 1;

/// Sums over evenly spread directions: of the density, and of the cosine over the density of each
/// crossing.
struct ByDirection {
    double density = 0, irradiance = 0;
};

ByDirection by_direction(const AreaEmitter& e, const Receiver& point, bool solid) {
    constexpr int steps = 160;
    // From outside, only directions to the bounding sphere are tested; from inside, all.
    const LightBounds b = bounds(e, 1);
    const bool outside = length(b.centre - point.position) > b.radius * 1.01;
    const Luminaire around =
        glowing(outside ? SphereEmitter{b.centre, b.radius} : SphereEmitter{point.position, 1});
    ByDirection sum;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const auto looked =
                sample(around, point.position, {(i + 0.5) / steps, (j + 0.5) / steps});
            const double found = density(e, point.position, looked->direction);
            if (found == 0) continue;
            sum.density += std::fmin(found, highest) / looked->density;
            Crossings met;
            const Ray ray{point.position, looked->direction};
            crossings(e.shape, e.transform ? e.transform->inverse_ray(ray) : ray, met);
            int ahead = 0;
            for (std::size_t c = 0; c < met.size(); ++c) ahead += met[c].t > 0;
            // Only the near side of a solid counts; every layer of an open surface does, as if it
            // did not shadow itself.
            sum.irradiance += (solid ? 1 : ahead) *
                              std::fmax(0, dot(looked->direction, point.normal)) / looked->density;
        }
    return {sum.density / (steps * steps), sum.irradiance / (steps * steps)};
}

}  // namespace

TEST_CASE("density and samples of area emitters tell the same story", "[luminaire][claim-23]") {
    for (const Lamp& lamp : lamps())
        for (const auto& map : maps())
            for (const Vec3& from : {Vec3(0.05, 0.1, 0.02), Vec3(2, 1, 1.5), Vec3(-1.5, 2, 0)}) {
                if (!lamp.solid && length(from) < 1) continue;
                INFO(lamp.name << " from " << from.x);
                const AreaEmitter e{lamp.shape, map};
                const Receiver point{from, unit(Vec3(1, -2, 0.5) - from)};
                const ByDirection expected = by_direction(e, point, lamp.solid);
                constexpr int steps = 120;
                double given = 0;
                for (int i = 0; i < steps; ++i)
                    for (int j = 0; j < steps; ++j)
                        if (const auto s = sample(e, from, {(i + 0.5) / steps, (j + 0.5) / steps}))
                            given += std::fmin(1, highest / s->density);
                // Open shapes have several layers in one direction, each with its own density.
                if (lamp.solid || bounds(e, 1).axis != Vec3(0))
                    CHECK(expected.density == Approx(given / (steps * steps)).epsilon(0.05));
                CHECK(sampled_irradiance(glowing(e), point, steps) ==
                      Approx(expected.irradiance).epsilon(0.06).margin(0.01));
            }
}

TEST_CASE("each sample of an area emitter has the density that its direction has", "[luminaire]") {
    Draw draw(2);
    for (const Lamp& lamp : lamps())
        for (const auto& map : maps())
            for (int i = 0; i < 200; ++i) {
                const AreaEmitter e{lamp.shape, map};
                const Vec3 from = 3.0 * draw.point();
                const auto s = sample(e, from, {draw.number(), draw.number()});
                if (!s) continue;
                INFO(lamp.name);
                CHECK(length(s->direction) == Approx(1));
                CHECK(length(from + s->distance * s->direction - s->position) < 1e-12);
                // The line may meet other layers, which can be sampled as well. A grazing one may
                // be missed by rounding.
                const double all = density(e, from, s->direction);
                CHECK((all >= s->density * (1 - 1e-6) || s->density > 100));
            }
}

TEST_CASE("a solid does not light what lies on it", "[luminaire]") {
    Draw draw(3);
    for (const Lamp& lamp : lamps()) {
        if (!lamp.solid) continue;
        for (int i = 0; i < 300; ++i) {
            const SurfacePoint on = sample_area(lamp.shape, {draw.number(), draw.number()});
            const auto s =
                sample(AreaEmitter{lamp.shape, {}}, on.position, {draw.number(), draw.number()});
            if (s) CHECK(dot(s->direction, on.normal) < 1e-6);
        }
    }
}

TEST_CASE("the sphere around an area emitter holds it, and its axis is its normal", "[luminaire]") {
    Draw draw(4);
    for (const Lamp& lamp : lamps())
        for (const auto& map : maps()) {
            const AreaEmitter e{lamp.shape, map};
            const LightBounds b = bounds(e, 1);
            for (int i = 0; i < 200; ++i) {
                const SurfacePoint on = sample_area(lamp.shape, {draw.number(), draw.number()});
                const Vec3 position = map ? map->point(on.position) : on.position;
                CHECK(length(position - b.centre) <= b.radius);
                CHECK(nearest_distance2(b.box, position) < 1e-20);
                const Vec3 normal = unit(map ? map->normal(on.normal) : on.normal);
                if (b.axis != Vec3(0)) CHECK(std::abs(dot(b.axis, normal)) == Approx(1));
            }
        }
}

TEST_CASE("area under a map: exact for similarities and flat shapes, near for others",
          "[luminaire]") {
    const auto scaled = [](const Vec3& factors) {
        return make_handle<Transform>(Transform::scaling(factors));
    };
    CHECK(emitting_area(AreaEmitter{Sphere{Vec3(0), 1}, scaled(Vec3(3))}) == Approx(36 * pi));
    CHECK(emitting_area(AreaEmitter{Disc{Vec3(0), Vec3(0, 0, 1), 1, 0}, scaled(Vec3(2, 3, 5))}) ==
          Approx(6 * pi));
    CHECK(emitting_area(AreaEmitter{Cuboid{Vec3(0), Vec3(1)}, scaled(Vec3(1, 2, 3))}) ==
          Approx(22).epsilon(0.05));
    // A prolate spheroid with axes 1, 1, 2.
    CHECK(emitting_area(AreaEmitter{Sphere{Vec3(0), 1}, scaled(Vec3(1, 1, 2))}) ==
          Approx(21.4784).epsilon(0.01));
    CHECK(emitting_area(AreaEmitter{Plane{}, {}}) == 0);
}

}  // namespace candelabra
