// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/refined_cut.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

const Box refined_cell{Vec3(-1), Vec3(1)};

std::vector<Luminaire> many() {
    Draw draw(1);
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 500; ++i)
        luminaires.push_back(glowing(SphereEmitter{20.0 * draw.direction() + draw.point(5), 0.1}));
    return luminaires;
}

}  // namespace

TEST_CASE("a refined cut holds every luminaire that is not dark once", "[lighting]") {
    std::vector<Luminaire> luminaires = many();
    for (std::size_t i = 0; i < 3; ++i) luminaires[100 * i].radiance = Rgb(0);
    const LightTree tree(*choices(luminaires));
    for (const int most : {1, 16, 100, 256}) {
        const RefinedCut cut = refined_cut(tree, refined_cell, {1e-9, most});
        CHECK(cut.clusters.size() <= static_cast<std::size_t>(most));
        std::uint32_t next = 0;
        std::size_t held = 0;
        for (const LightCluster& c : cut.clusters) {
            CHECK(c.first >= next);
            CHECK_FALSE(tree.dark(c));
            for (; next < c.first; ++next) CHECK(luminaires[tree.light(next)].radiance == Rgb(0));
            next = c.first + c.count;
            held += c.count;
        }
        CHECK(held >= 497);
    }
}

TEST_CASE("a finer cut has less noise, and a coarse rule is content with few entries",
          "[lighting]") {
    const std::vector<Luminaire> luminaires = many();
    const LightTree tree(*choices(luminaires));
    const RefinedCut coarse = refined_cut(tree, refined_cell, {1e-9, 16}),
                     fine = refined_cut(tree, refined_cell, {1e-9, 256}),
                     content = refined_cut(tree, refined_cell, {10, 256});
    CHECK(fine.noise < 0.5 * coarse.noise);
    CHECK(fine.clusters.size() > coarse.clusters.size());
    CHECK(content.clusters.size() < 64);
}

TEST_CASE("a long row of lamps that begins at the cell is divided down to its nearest lamps",
          "[lighting]") {
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 2000; ++i)
        for (const double side : {-2.5, 2.5})
            luminaires.push_back(glowing(SphereEmitter{{side, 4, 6.0 * i}, 0.12}));
    const LightTree tree(*choices(luminaires));
    const RefinedCut cut = refined_cut(tree, {Vec3(0, -8, 0), Vec3(12, 4, 12)}, {0.02, 64});
    for (LightIndex near = 0; near < 4; ++near) {
        const std::uint32_t place = tree.place_of(near);
        const auto holder = std::ranges::find_if(
            cut.clusters, [&](const LightCluster& c) { return c.holds(place); });
        REQUIRE(holder != cut.clusters.end());
        CHECK(holder->count <= 2);
    }
}

}  // namespace candelabra
