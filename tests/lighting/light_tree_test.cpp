// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_tree.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <set>

namespace candelabra {

namespace {

std::vector<Luminaire> lamps(int count, std::uint64_t seed) {
    Draw draw(seed);
    std::vector<Luminaire> result;
    for (int i = 0; i < count; ++i)
        result.push_back(glowing(emitter(i % emitter_kinds, draw.point(10) + Vec3(1000, 0, 0),
                                         std::pow(10, draw.between(-3, 0)), draw),
                                 std::pow(10, draw.between(-2, 2))));
    return result;
}

/// Calls visit for every cluster of the tree.
template <class Visit>
void each_cluster(const LightTree& tree, const LightCluster& c, Visit visit) {
    visit(c);
    if (c.count == 1) return;
    const auto [first, second] = tree.halves(c);
    each_cluster(tree, first, visit);
    each_cluster(tree, second, visit);
}

}  // namespace

TEST_CASE("each luminaire has one place in the light tree", "[lighting]") {
    for (const int count : {1, 2, 3, 100}) {
        const std::vector<Luminaire> luminaires = lamps(count, 1);
        const LightTree tree(*choices(luminaires));
        REQUIRE(tree.lights() == luminaires.size());
        std::set<LightIndex> found;
        each_cluster(tree, tree.root(), [&](const LightCluster& c) {
            if (c.count == 1) found.insert(tree.light(c.first));
        });
        CHECK(found.size() == luminaires.size());
        for (LightIndex light = 0; light < luminaires.size(); ++light)
            CHECK(tree.light(tree.place_of(light)) == light);
    }
}

TEST_CASE("the sphere around a cluster holds its luminaires, its strength is theirs",
          "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(200, 2);
    const LightTree tree(*choices(luminaires));
    const LightProxy whole = tree.light_proxy(tree.root());
    // All luminaires share 2^48 places, and each has one more than its share.
    const double place = 0x1p-48 * whole.strength * whole.radius;
    each_cluster(tree, tree.root(), [&](const LightCluster& c) {
        const LightProxy all = tree.light_proxy(c);
        double intensity = 0, shares = 0;
        for (std::uint32_t i = c.first; i < c.first + c.count; ++i) {
            const LightBounds b = bounds(luminaires[tree.light(i)]);
            intensity += b.intensity;
            shares += tree.share(c, i);
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(tree.box(c).low[axis] <= b.box.low[axis]);
                CHECK(tree.box(c).high[axis] >= b.box.high[axis]);
            }
            CHECK(farthest_distance2(b.box, all.centre) <= all.radius * all.radius);
        }
        CHECK(all.strength * all.radius == Approx(intensity).epsilon(1e-5).margin(c.count * place));
        CHECK(shares == Approx(1));
    });
}

TEST_CASE("the axes of lamps at right angles are summed alike, however their product is rounded",
          "[lighting]") {
    const auto axis_of_both = [](double lean) {
        const auto lamp = [](const Vec3& at, const Vec3& one, const Vec3& other) {
            return glowing(TriangleEmitter{at, at + one, at + other});
        };
        const std::vector<Luminaire> both = {lamp(Vec3(0), Vec3(0, 0, 1), Vec3(1, 0, 0)),
                                             lamp(Vec3(3, 0, 0), Vec3(0, 0, 1), Vec3(-lean, 1, 0))};
        const LightTree tree(*choices(both));
        return tree.light_proxy(tree.root()).axis;
    };
    const Vec3 above = axis_of_both(1e-15), below = axis_of_both(-1e-15);
    CHECK(length(above) > 0.5);
    CHECK(length(above - below) < 0.1);
}

TEST_CASE("luminaires are drawn by their strength", "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(30, 3);
    const LightTree tree(*choices(luminaires));
    const auto [first, second] = tree.halves(tree.root());
    std::vector<double> counted(30);
    constexpr int draws = 20000;
    for (int i = 0; i < draws; ++i) ++counted[tree.draw(second, (i + 0.5) / draws)];
    for (std::uint32_t place = 0; place < 30; ++place) {
        const double share = second.holds(place) ? tree.share(second, place) : 0;
        CHECK(std::abs(counted[place] / draws - share) < 2.0 / draws);
    }
}

TEST_CASE("no luminaire that a ray meets is left out", "[lighting]") {
    const std::vector<Luminaire> luminaires = lamps(300, 4);
    const LightTree tree(*choices(luminaires));
    Draw draw(5);
    int met = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto light = static_cast<LightIndex>(draw.number() * 300);
        const Vec3 from = draw.point(12) + Vec3(1000, 0, 0);
        const auto s = sample(luminaires[light], from, {draw.number(), draw.number()});
        if (!s) continue;
        ++met;
        bool found = false;
        tree.along(from, s->direction, [&](LightIndex other) { found = found || other == light; });
        CHECK(found);
    }
    CHECK(met > 3000);
}

TEST_CASE("luminaires in geometric progression and in one place make a finite tree", "[lighting]") {
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 200; ++i)
        luminaires.push_back(glowing(SphereEmitter{Vec3(std::pow(2.0, -i), 0, 0), 1e-3}));
    for (int i = 0; i < 1000; ++i)
        luminaires.push_back(glowing(SphereEmitter{Vec3(1, 1, 1), 1}, 1));
    const LightTree tree(*choices(luminaires));
    int deepest = 0;
    const auto measure = [&](const auto& self, const LightCluster& c, int depth) -> void {
        deepest = std::max(deepest, depth);
        if (c.count == 1) return;
        const auto [first, second] = tree.halves(c);
        self(self, first, depth + 1);
        self(self, second, depth + 1);
    };
    measure(measure, tree.root(), 0);
    CHECK(deepest < 80);
    CHECK(tree.memory_bytes() < 96 * luminaires.size() + 40000);
}

}  // namespace candelabra
