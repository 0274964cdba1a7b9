// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/blob.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"
#include "support/line_parts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

BlobSphere ball(const Vec3& centre, double radius, double strength, const Transform& map = {}) {
    return {centre, radius, strength, map, -1};
}

Blob blob(double threshold, const std::vector<BlobSphere>& balls,
          const std::vector<BlobCylinder>& rods = {}) {
    return {threshold, balls, rods, {}};
}

double first(const Blob& blob, const Vec3& from, const Vec3& direction) {
    return hits(build(blob), {from, direction}).at(0).t;
}

double field(const BuiltBlob& blob, const Vec3& p) {
    double sum = 0;
    for (const auto& source : blob.sources) sum += strength_at(source, p);
    return sum;
}

}  // namespace

TEST_CASE("blobs are met where POV-Ray meets them", "[shape]") {
    CHECK(first(blob(0.5, {ball(o, 1, 1)}), -5.0 * z, z) == Approx(5 - 0.5412).margin(1e-4));
    const Blob pair = blob(0.6, {ball(-0.5 * x, 1, 1), ball(0.5 * x, 1, 1)});
    CHECK(first(pair, -5.0 * z, z) == Approx(5 - 0.4498).margin(1e-4));
    CHECK(first(pair, -5.0 * x, x) == Approx(5 - 0.9748).margin(1e-4));
    const Blob rod = blob(0.5, {}, {{-x, x, 1, 1, {}, -1}});
    CHECK(first(rod, -5.0 * z, z) == Approx(5 - 0.5412).margin(1e-4));
    CHECK(first(rod, -5.0 * x, x) == Approx(5 - 1.5412).margin(1e-4));
    CHECK(first(blob(0.3, {ball(o, 1, 1), ball(-0.6 * z, 0.5, -1)}), -5.0 * z, z) ==
          Approx(5 - 0.3282).margin(1e-4));
    const Transform map = Transform::scaling(Vec3(1, 2, 3)).then(Transform::translation(x));
    const Blob stretched = blob(0.5, {ball(o, 1, 1, map)});
    CHECK(first(stretched, Vec3(1, 0, -5), z) == Approx(5 - 1.6236).margin(1e-4));
    CHECK(first(stretched, Vec3(1, 5, 0), -y) == Approx(5 - 1.0824).margin(1e-4));
    CHECK(first({0.5, {}, {}, {{1, 2, o}}}, -5.0 * z, z) == Approx(5 - 1.0824).margin(1e-4));
}

TEST_CASE("the surface of a blob is where the fields reach the threshold", "[shape]") {
    Draw draw(1);
    for (const std::size_t count : {3u, 40u}) {
        Blob many = blob(0.4, {});
        for (std::size_t i = 0; i < count; ++i) {
            const Transform turn = Transform::rotation(draw.point(180));
            const Vec3 a = draw.point(2), b = draw.point(2);
            if (i % 3 == 0)
                many.cylinders.push_back(
                    {a, b, draw.between(0.3, 1), draw.between(-1, 2), turn, -1});
            else
                many.spheres.push_back(ball(a, draw.between(0.3, 1.5), draw.between(-1, 2), turn));
        }
        const BuiltBlob built = build(many);
        const BuiltShape shape = Shared<BuiltBlob>(built);
        std::size_t met = 0;
        for (int i = 0; i < 600; ++i) {
            const Vec3 from = draw.point(4);
            const Ray ray{from, draw.between(0.2, 5) * (draw.point(1) - from)};
            const auto found = hits(built, ray);
            met += found.size();
            const double some = draw.between(0, 2);
            CHECK(agree_in({some, some + draw.between(0, 2)}, shape, ray));
            for (std::size_t k = 0; k < found.size(); ++k) {
                const Vec3 p = ray.at(found[k].t);
                CHECK(field(built, p) == Approx(0.4).margin(1e-6));
                CHECK(found[k].entering == (k % 2 == 0));
                const double step = 1e-6;
                const Vec3 slope = Vec3(field(built, p + step * x) - field(built, p - step * x),
                                        field(built, p + step * y) - field(built, p - step * y),
                                        field(built, p + step * z) - field(built, p - step * z));
                CHECK(length(found[k].normal + unit(slope)) < 1e-4);
            }
            const Vec3 p = draw.point(2);
            CHECK(inside(built, p) == (field(built, p) > 0.4));
        }
        CHECK(met > 50);
    }
}

TEST_CASE("a blob needs a component", "[shape]") {
    CHECK(problem(Blob{}) == "a `blob` needs a component");
    CHECK(problem(blob(1, {ball(o, 1, 1)})).empty());
    CHECK(vanishes(blob(1, {ball(o, 1, 1)})).empty());
    CHECK(vanishes(blob(1, {ball(o, 0, 1), ball(o, 1, -1)})) ==
          "no component has a radius and a strength above 0");
    // A blob whose fields are all 0 is never hit.
    CHECK(hits(build(blob(1, {ball(o, 1, 0)})), {-5.0 * x, x}).empty());
}

TEST_CASE("components far apart are met as well as near ones", "[shape]") {
    const double r = std::sqrt(1 - std::sqrt(0.5));
    for (const double far : {1.0, 40.0, 200.0, 1e4}) {
        const Blob apart = blob(0.5, {ball(-far * x, 1, 1), ball(far * x, 1, 1)},
                                {{Vec3(-3 * far, -1, 0), Vec3(-3 * far, 1, 0), 1, 1, {}, -1}});
        const auto met = hits(build(apart), {-5.0 * far * x, x});
        INFO(far);
        REQUIRE(met.size() == 6);
        const double places[] = {2, 4, 6};
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(met[2 * i].t == Approx(places[i] * far - r).epsilon(1e-13));
            CHECK(met[2 * i + 1].t == Approx(places[i] * far + r).epsilon(1e-13));
        }
    }
}

}  // namespace candelabra
