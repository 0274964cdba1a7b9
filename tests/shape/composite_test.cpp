// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/composite.h"

#include "support/axes.h"
#include "support/draw.h"

#include <catch2/catch.hpp>

#include <functional>

namespace candelabra {

namespace {

constexpr Interval ahead{0};

constexpr auto everything = [](std::uint32_t) { return true; };

using Inside = std::function<bool(const Vec3&)>;

/// A part with the plain definition of its inside.
struct Tested {
    PartRef ref;
    Inside inside;
};

/// Builds composites together with their definitions.
struct Maker {
    CompositeBuilder builder;
    Draw draw;

    explicit Maker(std::uint64_t seed) : draw(seed) {}

    Tested leaf(const BuiltShape& shape, Handle<Transform> transform, bool inverse) {
        const PartRef ref = builder.add({shape, transform, inverse});
        return {ref, [=](const Vec3& p) {
                    return inside(shape, transform ? transform->inverse_point(p) : p) != inverse;
                }};
    }
    Tested node(Combination how, const std::vector<Tested>& parts) {
        std::vector<PartRef> refs;
        for (const Tested& each : parts) refs.push_back(each.ref);
        return {builder.add(how, refs), [=](const Vec3& p) {
                    const auto within = [&](const Tested& each) { return each.inside(p); };
                    return how == Combination::common ? std::ranges::all_of(parts, within)
                                                      : std::ranges::any_of(parts, within);
                }};
    }

    Tested drawn_leaf() {
        const Vec3 place = draw.point(2);
        Handle<Transform> transform;
        if (draw.number() < 0.4)
            transform = make_handle<Transform>(
                Transform::scaling(Vec3(1, 0.5, 2)).then(Transform::rotation(draw.point(90))));
        const bool inverse = draw.number() < 0.25;
        const double kind = draw.number();
        if (kind < 0.4) return leaf(Sphere{place, draw.between(0.3, 1.5)}, transform, inverse);
        if (kind < 0.8) return leaf(Cuboid{place, place + draw.point(1.5)}, transform, inverse);
        return leaf(Plane{draw.direction(), draw.between(-1, 1)}, transform, inverse);
    }
    Tested drawn(int depth) {
        if (depth == 0 || draw.number() < 0.2) return drawn_leaf();
        std::vector<Tested> parts;
        const auto count =
            static_cast<int>(draw.between(1, depth == 1 && draw.number() < 0.3 ? 14 : 4));
        for (int i = 0; i < count; ++i) parts.push_back(drawn(depth - 1));
        return node(draw.number() < 0.5 ? Combination::common : Combination::merged, parts);
    }
};

std::vector<Composite::Meeting> meetings(const Composite& composite, const Ray& ray) {
    std::vector<Composite::Meeting> met;
    composite.all(ray, {-100, 100}, everything,
                  [&](const Composite::Meeting& each) { met.push_back(each); });
    std::ranges::sort(met, {}, &Composite::Meeting::t);
    return met;
}

Composite made(CompositeBuilder& builder, Combination how,
               const std::vector<CompositeLeaf>& leaves) {
    std::vector<PartRef> parts;
    for (const CompositeLeaf& each : leaves) parts.push_back(builder.add(each));
    return builder.finish(builder.add(how, parts));
}

Composite made(Combination how, const std::vector<CompositeLeaf>& leaves) {
    CompositeBuilder builder;
    return made(builder, how, leaves);
}

/// Compares points and rays with the definition. Returns the number of meetings.
std::size_t check_surface(const Composite& composite, const Tested& whole, Draw& draw, int rays) {
    std::size_t met_in_all = 0;
    for (int i = 0; i < rays; ++i) {
        const Vec3 p = draw.point(3);
        CHECK(composite.inside(p) == whole.inside(p));
        const Ray ray{p, draw.between(0.5, 2) * draw.direction()};
        const auto met = meetings(composite, ray);
        met_in_all += met.size();
        // Between two successive meetings the inside does not change; at each it does.
        double before = -100;
        for (std::size_t k = 0; k <= met.size(); ++k) {
            const double after = k < met.size() ? met[k].t : 100;
            const bool first = whole.inside(ray.at(before + 1e-3 * (after - before)));
            for (const double at : {0.3, 0.8, 0.999})
                CHECK(whole.inside(ray.at(before + at * (after - before))) == first);
            if (k > 0 && after - before > 1e-6 &&
                met[k - 1].t - (k > 1 ? met[k - 2].t : -100) > 1e-6)
                CHECK(whole.inside(ray.at(met[k - 1].t - 1e-7)) !=
                      whole.inside(ray.at(met[k - 1].t + 1e-7)));
            before = after;
        }
        const auto nearest = composite.first(ray, {0, 100}, everything);
        const auto next = std::ranges::find_if(met, [](const auto& m) { return m.t > 0; });
        REQUIRE(nearest.has_value() == (next != met.end()));
        if (nearest) CHECK(nearest->t == next->t);
        for (const auto& each : met) {
            const Box box = composite.bounds();
            CHECK(contains({box.low - 1e-9, box.high + 1e-9}, ray.at(each.t)));
            CHECK(dot(each.normal, ray.direction) *
                      (whole.inside(ray.at(each.t + 1e-7)) ? 1 : -1) <=
                  0);
        }
    }
    return met_in_all;
}

}  // namespace

TEST_CASE("composites of solids have surface exactly where inside changes", "[shape]") {
    std::size_t met_in_all = 0;
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
        Maker maker(seed);
        const Tested whole = maker.drawn(1 + static_cast<int>(seed % 4));
        const Composite composite = maker.builder.finish(whole.ref);
        met_in_all += check_surface(composite, whole, maker.draw, 60);
    }
    CHECK(met_in_all > 2000);
}

TEST_CASE("composites of long parts that lie aslant, too", "[shape]") {
    for (const bool holes : {false, true}) {
        Maker maker(7);
        std::vector<Tested> parts;
        if (holes) parts.push_back(maker.leaf(Cuboid{Vec3(-2.5), Vec3(2.5)}, {}, false));
        for (int i = 0; i < 200; ++i) {
            const Vec3 end = maker.draw.point(3);
            if (i % 2 == 0) {
                parts.push_back(maker.leaf(Cylinder{end, maker.draw.point(3), 0.05}, {}, holes));
                continue;
            }
            const auto turn = make_handle<Transform>(Transform::rotation(maker.draw.point(90)));
            parts.push_back(maker.leaf(Cuboid{end, end + Vec3(0.1, 4, 0.1)}, turn, holes));
        }
        const Tested whole = maker.node(holes ? Combination::common : Combination::merged, parts);
        const Composite composite = maker.builder.finish(whole.ref);
        CHECK(check_surface(composite, whole, maker.draw, 500) > 1000);
        std::size_t asked = 0;
        for (int i = 0; i < 500; ++i)
            composite.all(
                {maker.draw.point(3), maker.draw.direction()}, {0, 100},
                [&](std::uint32_t) { return ++asked > 0; }, [](const Composite::Meeting&) {});
        INFO(asked);
        CHECK(asked < 500 * 40);
    }
}

TEST_CASE("unions show all of their parts, merges only what is outside of the others", "[shape]") {
    const std::vector<CompositeLeaf> pair = {{Sphere{o, 1}}, {Sphere{x, 1}}};
    const Ray along{-5.0 * x, x};
    CHECK(meetings(made(Combination::together, pair), along).size() == 4);
    const auto merged = meetings(made(Combination::merged, pair), along);
    REQUIRE(merged.size() == 2);
    CHECK(merged[0].t == 4);
    CHECK(merged[0].leaf == 0);
    CHECK(merged[1].t == 7);
    CHECK(merged[1].leaf == 1);
}

TEST_CASE("the surface of an open tube is kept where it is inside the others", "[shape]") {
    const Composite cut = made(Combination::common, {{Cylinder{-y, y, 1, true}}, {Plane{x, 0}}});
    const auto met = meetings(cut, {Vec3(-5, 0.1, 0), x});
    REQUIRE(met.size() == 2);
    CHECK(met[0].t == 4);
    CHECK(met[1].t == 5);
    CHECK(met[1].leaf == 1);
    // Through the open end the ray hits the plane within the tube, which is solid all the same.
    const auto from_above = meetings(cut, {Vec3(-0.45, 5, 0), -y + 0.1 * x});
    REQUIRE(from_above.size() == 1);
    CHECK(from_above[0].leaf == 1);
}

TEST_CASE("what clips cuts, and closes nothing", "[shape]") {
    CompositeBuilder builder;
    PartRef ball = builder.add({Sphere{o, 2}}), half = builder.add({Plane{x, 0}});
    half.clips = true;
    const Composite clipped = builder.finish(builder.add(Combination::common, {ball, half}));
    const auto met = meetings(clipped, {Vec3(-5, 0, 0), x});
    REQUIRE(met.size() == 1);
    CHECK(met[0].t == 3);
    CHECK(clipped.inside(-x));
    CHECK_FALSE(clipped.inside(x));
    CHECK(clipped.bounds().high == Vec3(0, 2, 2));
}

TEST_CASE("inverse parts show the same surface from its other side", "[shape]") {
    const Composite hollow =
        made(Combination::common, {{Cuboid{Vec3(-2), Vec3(2)}}, {Sphere{o, 1}, {}, true}});
    const auto met = hollow.first({o, z}, ahead, everything);
    REQUIRE(met);
    CHECK(met->t == 1);
    CHECK(met->normal == -z);
    CHECK(met->leaf == 1);
    CHECK_FALSE(hollow.inside(o));
    CHECK(hollow.bounds().high == Vec3(2));
}

TEST_CASE("rays that miss a limit see nothing, inside tests do not ask it", "[shape]") {
    CompositeBuilder around;
    const PartRef box = around.add({Cuboid{Vec3(-1), Vec3(1)}});
    const auto limit = make_handle<Composite>(around.finish(box));
    CompositeBuilder builder;
    const PartRef ball = builder.add({Sphere{o, 2}});
    const Composite limited = builder.finish(builder.add(Combination::together, {ball}, limit));
    CHECK(meetings(limited, {Vec3(1.5, 0, -5), z}).empty());
    CHECK(meetings(limited, {Vec3(0.5, 0, -5), z}).size() == 2);
    CHECK(limited.inside(Vec3(1.5, 0, 0)));
}

TEST_CASE("leaves that are not wanted are not there, but still cut", "[shape]") {
    const Composite pair = made(Combination::common, {{Sphere{o, 1}}, {Sphere{x, 1}}});
    const auto only_first = [](std::uint32_t leaf) { return leaf == 0; };
    std::vector<Composite::Meeting> met;
    pair.all({-5.0 * x, x}, ahead, only_first,
             [&](const Composite::Meeting& each) { met.push_back(each); });
    REQUIRE(met.size() == 1);
    CHECK(met[0].t == 6);
    CHECK(pair.first({-5.0 * x, x}, ahead, only_first)->t == 6);
}

TEST_CASE("planes that face each other bound what is between", "[shape]") {
    std::vector<CompositeLeaf> planes;
    for (const Vec3& normal : {x, -x, y, -y, z, -z}) planes.push_back({Plane{normal, 1}});
    CHECK(made(Combination::common, planes).bounds().low == Vec3(-1));
    CHECK(made(Combination::common, planes).bounds().high == Vec3(1));
    planes.pop_back();
    CHECK_FALSE(finite(made(Combination::common, planes).bounds()));
    const auto turn = make_handle<Transform>(Transform::rotation(90.0 * z));
    planes.push_back({Plane{-z, 1}, turn});
    CHECK(made(Combination::common, planes).bounds().high == Vec3(1));
}

TEST_CASE("a composite of many parts asks few of them", "[shape]") {
    std::vector<CompositeLeaf> leaves = {{Cuboid{Vec3(-1, 0, -1), Vec3(41, 1, 41)}}};
    for (int i = 0; i < 41; ++i)
        for (int j = 0; j < 41; ++j)
            leaves.push_back({Cylinder{Vec3(i, -1, j), Vec3(i, 2, j), 0.3, false}, {}, true});
    const Composite sieve = made(Combination::common, leaves);
    std::size_t asked = 0;
    const auto count = [&](std::uint32_t) { return ++asked > 0; };
    Draw draw(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 target(draw.between(0, 40), 1, draw.between(0, 40));
        const auto met = sieve.first({target + Vec3(0, 3, 0.1), Vec3(0, -1, 0)}, ahead, count);
        const double dx = target.x - std::round(target.x),
                     dz = target.z + 0.1 - std::round(target.z + 0.1);
        const bool hole = std::hypot(dx, dz) < 0.3;
        REQUIRE(met.has_value() == !hole);
        if (met) CHECK(met->t == 3);
    }
    CHECK(asked < 500 * 12);
    CHECK(sieve.inside(Vec3(0.5, 0.5, 0.5)));
    CHECK_FALSE(sieve.inside(Vec3(7.1, 0.5, 8)));
}

TEST_CASE("faces of two parts in one place leave no holes in the skin between them", "[shape]") {
    // The second box is scaled, so that rounding decides where its faces are hit.
    for (const double scale : {1.0, 1.001, 1.1}) {
        CompositeBuilder builder;
        const PartRef body = builder.add({Cuboid{Vec3(0), Vec3(1)}, nullptr, false});
        const PartRef cut =
            builder.add({Cuboid{Vec3(0), Vec3(1, 0.5, 0.5)},
                         make_handle<Transform>(Transform::scaling(Vec3(scale))), true});
        const Composite made = builder.finish(builder.add(Combination::common, {body, cut}));
        Draw draw(7);
        for (int i = 0; i < 20000; ++i) {
            const Vec3 to(draw.between(0.01, 0.99), draw.between(0.01, 0.49), 0);
            const Vec3 from(draw.between(-3, 3), draw.between(-3, 3), draw.between(-5, -1));
            const auto met = made.first({from, unit(to - from)}, ahead, everything);
            REQUIRE(met);
            REQUIRE(met->t == Approx(length(to - from)));
        }
    }
}

TEST_CASE("of faces of two parts in one place that of the later part is met", "[shape]") {
    const Cuboid whole{Vec3(-1), Vec3(1)}, lower{Vec3(-1), Vec3(1, 0.5, 1)};
    for (const bool lower_last : {false, true}) {
        CompositeBuilder builder;
        std::vector<PartRef> parts = {builder.add({lower_last ? whole : lower}),
                                      builder.add({lower_last ? lower : whole})};
        const Composite made = builder.finish(builder.add(Combination::common, parts));
        const auto met = made.first({Vec3(0.25, 0.125, -5), z}, ahead, everything);
        REQUIRE(met);
        CHECK(met->t == 4);
        CHECK(met->leaf == 1);
    }
}

TEST_CASE("a composite without parts is empty", "[shape]") {
    CompositeBuilder builder;
    const Composite nothing = builder.finish(builder.add(Combination::together, {}));
    CHECK_FALSE(nothing.inside(o));
    CHECK(nothing.bounds().empty());
    CHECK_FALSE(nothing.first({o, x}, ahead, everything));
}

TEST_CASE("quadrics without end have bounds where planes cut them", "[shape]") {
    CompositeBuilder builder;
    const PartRef waist =
        builder.add({Shared<Quadric>(Quadric{Vec3(1, -1, 1), o, o, -1}),
                     make_handle<Transform>(Transform::rotation(Vec3(0, 30, 0)))});
    const PartRef above = builder.add({Plane{y, 2}}), below = builder.add({Plane{-y, 1}});
    const Composite cut = builder.finish(builder.add(Combination::common, {waist, above, below}));
    const double reach = std::sqrt(5) * (std::cos(0.5236) + std::sin(0.5236));
    CHECK(cut.bounds().high.x == Approx(reach).margin(1e-4));
    CHECK(cut.bounds().high.y == Approx(2));
    const auto met = cut.first({Vec3(0, 1.9, -9), z}, ahead, everything);
    REQUIRE(met);
    CHECK(met->t == Approx(9 - std::sqrt(1 + 1.9 * 1.9)));
}

}  // namespace candelabra
