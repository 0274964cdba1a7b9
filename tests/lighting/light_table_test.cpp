// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_table.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <numeric>

namespace candelabra {

namespace {

std::vector<Luminaire> mixed(int count, bool spheres_only, Draw& draw) {
    std::vector<Luminaire> result;
    for (int i = 0; i < count; ++i)
        result.push_back(glowing(emitter(spheres_only ? 0 : i % emitter_kinds, draw.point(5),
                                         draw.between(0.01, 0.5), draw),
                                 draw.between(0.1, 10)));
    return result;
}

std::vector<LightIndex> some(std::size_t count, double share, Draw& draw) {
    std::vector<LightIndex> result;
    for (std::size_t i = 0; i < count; ++i)
        if (draw.number() < share) result.push_back(static_cast<LightIndex>(i));
    return result;
}

}  // namespace

TEST_CASE("a list's sum is the sum of its luminaires' estimates, and find() follows it",
          "[lighting]") {
    Draw draw(1);
    for (const bool spheres_only : {true, false})
        for (const int count : {1, 7, 8, 9, 65, 500, 513, 3000}) {
            const std::vector<Luminaire> luminaires = mixed(count, spheres_only, draw);
            LightTable table(choices(luminaires));
            table.append(some(luminaires.size(), 0.3, draw));
            const std::vector<LightIndex> lights =
                some(luminaires.size(), count == 1 ? 1 : 0.9, draw);
            const LightList list = table.append(lights);
            for (int i = 0; i < 20; ++i) {
                const Receiver point{draw.point(5), draw.direction(), lit_from(i % 4 == 0)};
                LightTable::Sums sums;
                table.sum(list, point, sums);
                double total = 0;
                for (const LightIndex light : lights) total += table.estimate(light, point);
                CHECK(sums.total == Approx(total).epsilon(1e-12));
                if (total == 0) continue;
                double before = 0;
                const double target = draw.number() * sums.total;
                const LightTable::Row row = table.find(list, point, sums, target);
                const LightIndex found = table.light(row.row);
                CHECK(row.estimate == table.estimate(found, point));
                CHECK(row.estimate > 0);
                for (const LightIndex light : lights)
                    if (light < found) before += table.estimate(light, point);
                CHECK(target > before - 1e-9 * total);
                CHECK(target < before + row.estimate + 1e-9 * total);
            }
        }
}

TEST_CASE("a vectorised loop and a single estimate agree to the last bit", "[lighting]") {
    Draw draw(2);
    const std::vector<Luminaire> luminaires = mixed(450, false, draw);
    LightTable table(choices(luminaires));
    std::vector<LightIndex> all(luminaires.size());
    std::iota(all.begin(), all.end(), LightIndex{0});
    const LightList list = table.append(all);
    for (int i = 0; i < 200; ++i) {
        const Receiver point{draw.point(5), draw.direction(), lit_from(i % 4 == 0)};
        LightTable::Sums sums;
        table.sum(list, point, sums);
        // The parts of so short a list are its rows.
        int different = 0;
        for (const LightIndex light : all)
            different += sums.part[light] != table.estimate(light, point);
        CHECK(different == 0);
    }
}

TEST_CASE("estimates for near triangles are exact", "[lighting]") {
    Draw draw(3);
    for (int i = 0; i < 200; ++i) {
        const std::vector<Luminaire> one = {glowing(emitter(1, Vec3(0), 1, draw))};
        const LightTable table(choices(one));
        const Receiver point{draw.point(1), draw.direction()};
        const double exact = unoccluded(one[0], point);
        CHECK(table.estimate(0, point) == exact);
    }
}

TEST_CASE("targets that rounding carried past the end find the last luminaire that shines",
          "[lighting]") {
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 700; ++i)
        luminaires.push_back(glowing(SphereEmitter{Vec3(0, 0, i < 600 ? 5 : -5), 1}));
    for (const std::size_t count : {20u, 700u}) {
        LightTable table(choices(luminaires));
        std::vector<LightIndex> lights(count);
        std::iota(lights.begin(), lights.end(), LightIndex{0});
        const LightList list = table.append(lights);
        const Receiver point{Vec3(0), Vec3(0, 0, 1)};
        LightTable::Sums sums;
        table.sum(list, point, sums);
        const LightTable::Row row = table.find(list, point, sums, sums.total * (1 + 1e-12));
        CHECK(table.light(row.row) == std::min<std::size_t>(count, 600) - 1);
        CHECK(row.estimate > 0);
    }
}

TEST_CASE("an empty list gives nothing", "[lighting]") {
    const LightTable table;
    LightTable::Sums sums;
    table.sum({}, {Vec3(0), Vec3(0, 0, 1)}, sums);
    CHECK(sums.total == 0);
}

}  // namespace candelabra
