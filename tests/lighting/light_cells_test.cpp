// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_cells.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

namespace {

struct Setup {
    std::vector<Luminaire> luminaires;
    std::vector<Box> surfaces;
    std::vector<Plane> planes;
    std::vector<LightBounds> lights;

    LightCells build(const PaperOctree& settings, int threads = 1) {
        lights.clear();
        for (const Luminaire& luminaire : luminaires) lights.push_back(bounds(luminaire));
        return build_light_cells(settings, {choices(luminaires), surfaces, planes}, lights,
                                 threads);
    }
};

/// Small lamps all over a room, and surfaces in a part of it.
Setup room(int count, std::uint64_t seed) {
    Draw draw(seed);
    Setup result;
    for (int i = 0; i < count; ++i)
        result.luminaires.push_back(
            glowing(emitter(i % emitter_kinds, draw.point(10), draw.between(0.02, 0.2), draw),
                    draw.between(0.1, 20)));
    result.surfaces = {Box{Vec3(-10), Vec3(10, -9, 10)}, Box{Vec3(-10), Vec3(-9, 10, 10)},
                       Box{Vec3(2), Vec3(3)}};
    return result;
}

int depth(const LightCells& cells, std::uint32_t cell = 0) {
    if (cells.cells[cell].children == 0) return 0;
    int deepest = 0;
    for (std::uint32_t i = 0; i < 8; ++i)
        deepest = std::max(deepest, depth(cells, cells.cells[cell].children + i));
    return 1 + deepest;
}

/// Radiance of a white surface at the point, facing the luminaire.
double straight_on(const Luminaire& luminaire, const Vec3& position) {
    const Vec3 normal = unit(bounds(luminaire).centre - position);
    return unoccluded(luminaire, {position, normal}) / std::numbers::pi;
}

}  // namespace

TEST_CASE("no luminaire is left out of a list where it may be brighter than the threshold",
          "[lighting][claim-11]") {
    Setup setup = room(600, 1);
    PaperOctree settings;
    settings.threshold = 0.004;
    settings.max_bright = 8;
    const LightCells cells = setup.build(settings);
    Draw draw(2);
    int checked = 0;
    std::size_t bright = 0;
    for (int i = 0; i < 400; ++i) {
        const Box& box = setup.surfaces[static_cast<std::size_t>(i) % 3];
        const Vec3 point =
            glm::mix(box.low, box.high, Vec3(draw.number(), draw.number(), draw.number()));
        const std::uint32_t list = cells.list_at(point);
        REQUIRE(list != LightCell::no_list);
        bright += cells.lists[list].size();
        CHECK(std::ranges::is_sorted(cells.lists[list]));
        for (LightIndex light = 0; light < setup.luminaires.size(); ++light) {
            if (std::ranges::binary_search(cells.lists[list], light)) continue;
            ++checked;
            if (straight_on(setup.luminaires[light], point) > settings.threshold)
                CHECK(setup.luminaires.empty());
        }
    }
    CHECK(checked > 10000);
    CHECK(bright < 400 * 300);
}

TEST_CASE("the reach of a luminaire bounds what it can give beyond", "[lighting][claim-11]") {
    Draw draw(3);
    for (int i = 0; i < 20000; ++i) {
        const Luminaire luminaire = glowing(emitter(i % emitter_kinds, Vec3(0), 1, draw),
                                            std::pow(10, draw.between(-2, 3)));
        const double threshold = std::pow(10, draw.between(-3, 1));
        const LightBounds b = bounds(luminaire);
        const double reach = bright_reach(b, threshold);
        const Vec3 from =
            b.centre + std::fmax(reach, b.radius * 1.001) * (1 + draw.number()) * draw.direction();
        // The estimates of flat luminaires exceed the truth by their evenness.
        CHECK(straight_on(luminaire, from) <= threshold * (b.axis == Vec3(0) ? 1.0001 : 1.0501));
        if (i % emitter_kinds == 0 && reach > 1.01)
            CHECK(straight_on(luminaire, b.centre + 0.999 * reach * draw.direction()) <
                  threshold * std::numbers::pi);
    }
}

TEST_CASE("cells are no deeper than allowed, and lists that are short enough are not cut",
          "[lighting][claim-12]") {
    for (const int deepest : {0, 1, 3}) {
        Setup setup = room(300, 4);
        PaperOctree settings;
        settings.max_depth = deepest;
        settings.max_bright = 1;
        CHECK(depth(setup.build(settings)) == deepest);
    }
    Setup setup = room(300, 4);
    PaperOctree settings;
    settings.max_bright = 300;
    CHECK(depth(setup.build(settings)) == 0);
}

TEST_CASE("a cell in which everything is bright everywhere is not cut", "[lighting][claim-12]") {
    Setup setup;
    for (int i = 0; i < 50; ++i)
        setup.luminaires.push_back(glowing(SphereEmitter{Vec3(0.01 * i, 50, 0), 1}, 100));
    setup.surfaces = {Box{Vec3(-1), Vec3(1)}};
    PaperOctree settings;
    settings.max_bright = 10;
    const LightCells cells = setup.build(settings);
    CHECK(cells.cells.size() == 1);
    CHECK(cells.lists.at(0).size() == 50);
}

TEST_CASE("cells without surfaces have no list", "[lighting]") {
    Setup setup = room(300, 5);
    PaperOctree settings;
    settings.max_bright = 4;
    CHECK(setup.build(settings).list_at(Vec3(8, 8, -8)) == LightCell::no_list);
    setup.planes = {Plane{Vec3(0, 2, 0), 8}};
    const LightCells cells = setup.build(settings);
    for (const double x : {-9.0, 3.0, 9.0, 1e6})
        CHECK(cells.list_at(Vec3(x, 8, 1)) != LightCell::no_list);
}

TEST_CASE("cells do not depend on the number of threads", "[lighting]") {
    Setup setup = room(500, 6);
    PaperOctree settings;
    settings.max_bright = 10;
    const LightCells one = setup.build(settings, 1), seven = setup.build(settings, 7);
    CHECK(one.lists == seven.lists);
    REQUIRE(one.cells.size() == seven.cells.size());
    for (std::size_t i = 0; i < one.cells.size(); ++i) {
        CHECK(one.cells[i].children == seven.cells[i].children);
        CHECK(one.cells[i].list == seven.cells[i].list);
    }
}

TEST_CASE("nothing to light, or nothing that lights, makes no cells", "[lighting]") {
    Setup setup;
    CHECK(setup.build({}).list_at(Vec3(1)) == LightCell::no_list);
    setup.surfaces = {Box{Vec3(0), Vec3(1)}};
    CHECK(setup.build({}).list_at(Vec3(1)) == LightCell::no_list);
    setup.luminaires = {glowing(SphereEmitter{Vec3(3), 1})};
    CHECK(setup.build({}).list_at(Vec3(0.5)) != LightCell::no_list);
    setup.surfaces = {Box()};
    CHECK(setup.build({}).cells.size() == 1);
}

TEST_CASE("cells get small where the luminaires are, however wide the scene", "[lighting]") {
    // All of the luminaires stay together in one part for many cuts.
    Draw draw(7);
    Setup setup;
    for (int i = 0; i < 400; ++i)
        setup.luminaires.push_back(glowing(SphereEmitter{Vec3(300) + draw.point(2), 0.02}));
    setup.surfaces = {Box{Vec3(-1000), Vec3(1000)}};
    PaperOctree settings;
    settings.threshold = 0.001;
    settings.max_depth = 14;
    CHECK(depth(setup.build(settings)) > 10);
}

TEST_CASE("cutting ends where it does not make lists shorter", "[lighting]") {
    // Equally bright from everywhere in the room, but not so bright that the whole room is known to
    // be lit.
    Draw draw(8);
    Setup setup;
    for (int i = 0; i < 400; ++i)
        setup.luminaires.push_back(
            glowing(SphereEmitter{0.5 * draw.point() + Vec3(0, 60, 0), 1}, 1000));
    setup.surfaces = {Box{Vec3(-40), Vec3(40)}};
    setup.luminaires.push_back(glowing(SphereEmitter{Vec3(0, -30, 0), 0.01}));
    PaperOctree settings;
    settings.threshold = 0.02;
    settings.max_bright = 8;
    CHECK(depth(setup.build(settings)) <= 4);
}

}  // namespace candelabra
