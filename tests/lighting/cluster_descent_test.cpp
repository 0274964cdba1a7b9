// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cluster_descent.h"

#include "support/choices.h"
#include "support/lights.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <vector>

namespace candelabra {

namespace {

/// Lamps in a long row that begins above the receiver.
std::vector<Luminaire> row_of_lamps() {
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 300; ++i)
        luminaires.push_back(glowing(SphereEmitter{{0, 4, 6.0 * i}, 0.1}));
    return luminaires;
}
const Receiver below_row{Vec3(0), Vec3(0, 1, 0)};

}  // namespace

TEST_CASE("members of a cluster are drawn with their probabilities", "[lighting]") {
    const LightTree tree(*choices(row_of_lamps()));
    const Key key = Key::of(Survey::cell, 1, 2, 3);
    double sum = 0;
    for (std::uint32_t place = 0; place < 300; ++place)
        sum += probability_of(tree, tree.root(), below_row, place);
    CHECK(sum == Approx(1));
    Draw draw(1);
    for (int i = 0; i < 200; ++i) {
        const DrawnMember drawn = member_of(tree, tree.root(), below_row, key, draw.between(0, 1));
        CHECK(drawn.probability ==
              Approx(probability_of(tree, tree.root(), below_row, drawn.place)));
    }
}

TEST_CASE("members that are drawn together are those that are drawn alone", "[lighting]") {
    const LightTree tree(*choices(row_of_lamps()));
    std::vector<MemberDraw> draws;
    std::vector<MemberDraw*> together;
    const auto number = [](std::size_t i) { return (static_cast<double>(i) + 0.5) / 16; };
    const auto key = [](std::size_t i) {
        return Key::of(Survey::cell, 1, static_cast<std::uint32_t>(i), 3);
    };
    for (std::size_t i = 0; i < draws_together; ++i)
        draws.emplace_back(tree, tree.root(), below_row, key(i), number(i));
    for (MemberDraw& draw : draws) together.push_back(&draw);
    descend_together(together);
    for (std::size_t i = 0; i < draws_together; ++i) {
        const DrawnMember here = draws[i].draw(),
                          alone = member_of(tree, tree.root(), below_row, key(i), number(i));
        CHECK(here.place == alone.place);
        CHECK(here.probability == alone.probability);
    }
}

TEST_CASE("members that are near are drawn most", "[lighting]") {
    const std::vector<Luminaire> luminaires = row_of_lamps();
    const LightTree tree(*choices(luminaires));
    double light = 0, nearest = 0;
    for (const Luminaire& each : luminaires) light += unoccluded(each, below_row);
    for (LightIndex i = 0; i < 3; ++i)
        nearest += probability_of(tree, tree.root(), below_row, tree.place_of(i));
    CHECK(nearest > 0.5 * unoccluded(luminaires[0], below_row) / light);
    CHECK(nearest > 0.3);
}

TEST_CASE("members that face a point are drawn from farther away", "[lighting]") {
    std::vector<Luminaire> luminaires;
    std::vector<Vec3> bent_normals;
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < 8; ++i) {
            luminaires.push_back(glowing(SphereEmitter{{0, 0.1 * i, side}, 0.01}));
            bent_normals.emplace_back(0.5 * side, 0, 0);
        }
    const LuminaireChoices lights(luminaires, bent_normals);
    const LightTree tree(lights);
    // In radii of the cluster: below tuning::near_radii_turned, and above tuning::near_radii.
    const double radius = 0.5 * length(tree.box(tree.root()).size());
    const Receiver point{Vec3(9 * radius, 0, 0), Vec3(-1, 0, 0)};
    double facing = 0;
    for (LightIndex i = 8; i < 16; ++i)
        facing += probability_of(tree, tree.root(), point, tree.place_of(i));
    CHECK(facing > 0.75);

    const LightTree even(*choices(luminaires));
    CHECK(probability_of(even, even.root(), point, 3) == Approx(1.0 / 16));
}

TEST_CASE("members in a lobe are drawn from farther away", "[lighting]") {
    std::vector<Luminaire> luminaires;
    for (int i = 0; i < 16; ++i)
        luminaires.push_back(glowing(SphereEmitter{{0.5 * i - 4, 40, 0}, 0.01}));
    const LightTree tree(*choices(luminaires));
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    const auto probability = [&](LightIndex light, GlossyLobes lobes) {
        return probability_of(tree, tree.root(), point, tree.place_of(light), lobes);
    };
    CHECK(probability(5, nullptr) == Approx(1.0 / 16));
    const Vec3 to_light = unit(Vec3(0.5 * 5 - 4, 40, 0)), viewer(-to_light.x, to_light.y, 0);
    for (const Highlight& h :
         {Highlight{Vec3(0, 1, 0), 1e4, 1e5, viewer}, Highlight{to_light, 1e4, 1e5}}) {
        const LobeWeights<double> metal({0, {h}, 1});
        double sum = 0;
        for (LightIndex light = 0; light < 16; ++light) sum += probability(light, &metal);
        CHECK(sum == Approx(1));
        CHECK(probability(5, &metal) > 0.6);
        const Key key = Key::of(Survey::cell, 1, 2, 3);
        for (int i = 0; i < 20; ++i) {
            const DrawnMember drawn =
                member_of(tree, tree.root(), point, key, (i + 0.5) / 20, &metal);
            CHECK(drawn.probability == Approx(probability(tree.light(drawn.place), &metal)));
        }
    }
}

}  // namespace candelabra
