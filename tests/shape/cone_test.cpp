// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/cone.h"
#include "shape/cylinder.h"

#include "support/axes.h"
#include "support/draw.h"
#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const double w = std::sqrt(0.5);

}  // namespace

TEST_CASE("rays cross a cone where they should", "[shape]") {
    const Cone solid{Vec3(0), 1, y, 0, false}, open{Vec3(0), 1, y, 0, true};
    struct Row {
        Ray ray;
        std::vector<ExpectedHit> solid, open;
    };
    const std::vector<Row> table = {
        {{Vec3(0.5, 5, 0), -y},
         {{4.5, Vec3(w, w, 0), true}, {5, -y, false}},
         {{4.5, Vec3(w, w, 0), true}}},
        {{Vec3(-5, 0.5, 0), x},
         {{4.5, Vec3(-w, w, 0), true}, {5.5, Vec3(w, w, 0), false}},
         {{4.5, Vec3(-w, w, 0), true}, {5.5, Vec3(w, w, 0), false}}},
        {{Vec3(0, 3, 0), -2.0 * y}, {{1, y, true}, {1.5, -y, false}}, {{1, y, true}}},
        {{Vec3(-5, 1, 0), x}, {}, {}},
        {{Vec3(-5, 1.5, 0), x}, {}, {}},
        {{Vec3(0.5, -1, 0), Vec3(-1, 1, 0)},
         {{1, -y, true}, {1.25, Vec3(-w, w, 0), false}},
         {{1.25, Vec3(-w, w, 0), false}}},
        {{Vec3(2, -1, 0), Vec3(-1, 1, 0)}, {}, {}},
        {{Vec3(0), Vec3(0)}, {}, {}},
    };
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("row " << i);
        CHECK(answers(solid, {table[i].ray, table[i].solid}));
        CHECK(answers(open, {table[i].ray, table[i].open}));
    }
}

TEST_CASE("a cone with equal radii is a cylinder, and either end may be the wide one", "[shape]") {
    const Cone straight{Vec3(0), 1, y, 1, false};
    CHECK(answers(straight, {{Vec3(-5, 0.5, 0), x}, {{4, -x, true}, {6, x, false}}}));
    const Cone upside_down{Vec3(0), 0, y, 1, false};
    CHECK(answers(upside_down, {{Vec3(-5, 0.5, 0), x},
                                {{4.5, Vec3(-w, -w, 0), true}, {5.5, Vec3(w, -w, 0), false}}}));
    CHECK(answers(upside_down, {{Vec3(0, 5, 0), -y}, {{4, y, true}, {5, -y, false}}}));
}

TEST_CASE("inside and bounds of a cone", "[shape]") {
    const Cone cone{Vec3(0), 1, y, 0, false};
    CHECK(inside(cone, Vec3(0.5, 0.4, 0)));
    CHECK_FALSE(inside(cone, Vec3(0.5, 0.6, 0)));
    CHECK_FALSE(inside(cone, Vec3(0, 1, 0)));
    CHECK_FALSE(inside(cone, Vec3(0, 1.1, 0)));
    CHECK(inside(Cone{Vec3(0), 1, y, 0, true}, Vec3(0, 1, 0)));
    CHECK(bounds(cone).low == Vec3(-1, 0, -1));
    CHECK(bounds(cone).high == Vec3(1));
}

TEST_CASE("cones of all forms are met on their surface", "[shape]") {
    Draw draw(4);
    for (const double base_radius : {0.0, 1e-3, 1.0, 1e3})
        for (const double cap_radius : {0.0, 1e-2, 1.0})
            for (const double height : {1e-2, 1.0, 1e4}) {
                if (base_radius + cap_radius == 0) continue;
                INFO("radii " << base_radius << " " << cap_radius << " height " << height);
                const double size = base_radius + cap_radius + height;
                for (int i = 0; i < 100; ++i) {
                    const Vec3 base = draw.point(size), cap = base + height * draw.direction();
                    const Vec3 up = unit(cap - base);
                    const Cone cone{base, base_radius, cap, cap_radius, false};
                    const double along = draw.between(0.1, 0.9);
                    const double radius = base_radius + along * (cap_radius - base_radius);
                    const Vec3 aside = unit(cross(up, draw.direction()));
                    const Vec3 target =
                        base + along * height * up + draw.between(0, 0.9) * radius * aside;
                    const Vec3 origin =
                        target + std::pow(10, draw.between(-2, 3)) * size * draw.direction();
                    const Ray ray{origin, std::exp(draw.between(-9, 9)) * (target - origin)};
                    const std::vector<Crossing> found = hits(cone, ray);
                    REQUIRE(found.size() == 2);
                    for (const Crossing& c : found) {
                        const Vec3 p = ray.at(c.t) - base;
                        const double h = dot(p, up), off = length(p - h * up);
                        const double slope = (cap_radius - base_radius) / length(cap - base);
                        const double from_side =
                            std::abs(off - base_radius - slope * h) / std::hypot(1, slope);
                        const double from_end =
                            std::fmin(std::abs(h), std::abs(dot(ray.at(c.t) - cap, up)));
                        const bool at_end = std::abs(dot(c.normal, up)) > 1 - 1e-12;
                        const double far = length(origin - base) + size;
                        CHECK((at_end ? from_end : from_side) <= 1e-13 * far);
                    }
                }
            }
}

TEST_CASE("a cone needs two ends and a radius", "[shape]") {
    CHECK(problem(Cone{}) == "");
    CHECK(problem(Cone{y, 1, y, 0, false}) == "a `cone` needs two different end points");
    CHECK(vanishes(Cone{Vec3(0), 0, y, 0, false}) == "both its radii are 0");
    CHECK(vanishes(Cone{}).empty());
}

TEST_CASE("rays nearly along the ends of cylinders and cones are met on them, in order",
          "[shape]") {
    Draw draw(8);
    const auto whole = [&] { return std::floor(draw.between(-3, 4)); };
    int met = 0;
    for (int i = 0; i < 200'000; ++i) {
        const Vec3 base(whole(), whole(), whole());
        Vec3 cap(whole(), whole(), whole());
        if (i % 2 == 0) cap.x = base.x, cap.z = base.z;  // along an axis
        if (cap == base) continue;
        const Vec3 up = unit(cap - base);
        const auto [right, ahead] = perpendiculars(up);
        const auto across = [&] {
            return draw.between(-2, 2) * right + draw.between(-2, 2) * ahead;
        };
        const Vec3& end = i % 3 == 0 ? cap : base;
        const double off = std::pow(10.0, draw.between(-17, -9));
        const Vec3 from = end + across() + off * draw.between(-1, 1) * up;
        const Ray ray{from, end + across() + off * draw.between(-1, 1) * up - from};
        const auto check = [&](const auto& shape) {
            Crossings found;
            crossings(shape, ray, found);
            for (std::size_t k = 0; k < found.size(); ++k) {
                ++met;
                const Vec3 p = ray.at(found[k].t) - base;
                const double height = dot(p, up), length_up = length(cap - base);
                const bool on_it = height > -1e-7 && height < length_up + 1e-7 &&
                                   length(p - height * up) < 1 + 1e-7;
                if (!on_it || (k > 0 && !(found[k - 1].t <= found[k].t))) {
                    CAPTURE(i, k, found[k].t, height, length(p - height * up));
                    FAIL("beside the shape, or in the wrong order");
                }
            }
        };
        check(Cylinder{base, cap, 1, false});
        check(Cone{base, 1, cap, 0.5, false});
    }
    CHECK(met > 10'000);
}

}  // namespace candelabra
