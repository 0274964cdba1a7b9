// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/luminaire_list.h"

#include "lighting/light_tree.h"
#include "support/draw.h"
#include "support/twins.h"
#include "world/luminaire_choices.h"
#include "world/prototype.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace candelabra {

namespace {

/// Lamps of some kinds in unions that stand in many places, beside others.
const std::string lamps = R"(
    #declare Glow = texture { pigment { rgb 1 } finish { ambient 0 emission 4 } }
    #declare Dim = texture { pigment { rgb <1, 0.5, 0> } finish { ambient 0 emission 0.5 } }
    #declare Stand = union {
        #for (I, 0, 6) sphere { <0.3*I, 0.1*I, 0>, 0.05 + 0.01*I texture { Glow } } #end
        box { <-0.5, 0, 0.4>, <-0.3, 0.2, 0.5> texture { Dim } rotate 20*y }
        triangle { <0, 1, 0>, <0.4, 1, 0>, <0, 1, 0.4> texture { Glow } }
        cylinder { 0, 0.9*y, 0.02 pigment { rgb 0.5 } }
    }
    #declare One = union { sphere { 0, 0.1 texture { Dim } } box { <-0.3, -0.4, -0.3>, <0.3, -0.3, 0.3> } }
    #for (I, 0, 8)
        object { Stand rotate 40*I*y scale 0.5 + 0.1*I scale <1, 1, pow(-1, I)> translate <2*I, 0, mod(I, 3)> }
        object { One translate <2*I, 3, 1> }
    #end
    union { object { One translate <1, 5, 1> } light_name "Left" }
    sphere { <3, 4, 0>, 0.2 texture { Glow } }
    sphere { <5, 4, 0>, 0.2 texture { Dim } }
    box { <-50, -1.1, -50>, <50, -1, 50> pigment { rgb 0.8 } }
)";

using LampPlace = std::tuple<long, long, long, long>;
LampPlace lamp_place(const Luminaire& luminaire) {
    const LightBounds b = bounds(luminaire);
    const auto round = [](double x) { return std::lround(1e6 * x); };
    return {round(b.centre.x), round(b.centre.y), round(b.centre.z), round(b.intensity)};
}

std::multiset<LampPlace> lamp_places(const World& world) {
    std::multiset<LampPlace> all;
    world.lights.luminaires.for_each(
        [&](const Luminaire& luminaire) { all.insert(lamp_place(luminaire)); });
    return all;
}

/// All clusters below one, with itself.
void list_clusters(const LightTree& tree, const LightCluster& c, std::vector<LightCluster>& all) {
    all.push_back(c);
    if (c.count == 1) return;
    const auto [first, second] = tree.halves(c);
    REQUIRE(first.count > 0);
    REQUIRE(second.count > 0);
    REQUIRE(first.first == c.first);
    REQUIRE(second.first == first.first + first.count);
    REQUIRE(second.first + second.count == c.first + c.count);
    list_clusters(tree, first, all);
    list_clusters(tree, second, all);
}

}  // namespace

TEST_CASE("luminaires of instances are those that are taken apart", "[instances]") {
    const Twins twins = twins_of(lamps);
    const LuminaireList& all = twins.shared->lights.luminaires;
    REQUIRE(all.placed().size() == 19);
    REQUIRE(all.own().size() == 2);
    REQUIRE(all.size() == twins.apart->lights.luminaires.size());
    CHECK(lamp_places(*twins.shared) == lamp_places(*twins.apart));
    CHECK(twins.shared->provenance.lights_of_statements() ==
          twins.apart->provenance.lights_of_statements());
    // Each is met under its number, and belongs to the statement that placed it.
    std::map<LampPlace, std::uint32_t> statements;
    for (LightIndex i = 0; i < all.size(); ++i)
        statements[lamp_place(*twins.apart->lights.luminaires[i])] =
            twins.apart->provenance.luminaire_statement(i);
    for (LightIndex i = 0; i < all.size(); ++i) {
        const LuminaireAt lamp = all[i];
        CHECK(twins.shared->luminaire_of(lamp->primitive) == i);
        CHECK(twins.shared->provenance.luminaire_statement(i) == statements.at(lamp_place(*lamp)));
    }
}

TEST_CASE("unions whose luminaires cannot be moved are taken apart", "[instances]") {
    const auto placed = [](const std::string& part, const std::string& move) {
        const Twins twins = twins_of("#declare U = union { sphere { 0, 0.1 } " + part +
                                     " } #for (I, 0, 4) object { U " + move +
                                     " translate 3*I*x } #end plane { y, -3 }");
        CHECK(lamp_places(*twins.shared) == lamp_places(*twins.apart));
        return twins.shared->geometry.instances.size();
    };
    const std::string glow = " pigment { rgb 1 } finish { emission 3 } }";
    CHECK(placed("sphere { y, 0.1" + glow, "") == 5);
    CHECK(placed("sphere { y, 0.1" + glow, "scale -2") == 5);
    CHECK(placed("sphere { y, 0.1" + glow, "scale <1, 2, 1>") == 0);
    CHECK(placed("torus { 1, 0.1" + glow, "") == 0);
    CHECK(placed("difference { sphere { y, 0.3 } box { 0, 1 }" + glow, "") == 0);
    CHECK(placed("sphere { y, 0.1 luminaire { flux 100 }" + glow, "") == 0);
    CHECK(placed("union { sphere { y, 0.1" + glow + " light_name \"Left\" }", "") == 0);
}

TEST_CASE("the tree of luminaires goes through instances", "[instances]") {
    const Twins twins = twins_of(lamps);
    const LuminaireList& luminaires = twins.shared->lights.luminaires;
    const LuminaireChoices choices(luminaires);
    const LightTree tree(choices);
    REQUIRE(tree.lights() == luminaires.size());
    for (std::uint32_t place = 0; place < tree.lights(); ++place)
        CHECK(tree.place_of(tree.light(place)) == place);
    std::vector<LightCluster> clusters;
    list_clusters(tree, tree.root(), clusters);
    CHECK(clusters.size() == 2 * luminaires.size() - 1);
    for (const LightCluster& c : clusters) {
        Box box = tree.box(c);
        box.low -= Vec3(1e-9);
        box.high += Vec3(1e-9);
        double sum = 0, intensity = 0;
        for (std::uint32_t place = c.first; place < c.first + c.count; ++place) {
            const LightBounds own = bounds(*luminaires[tree.light(place)]);
            CHECK(contains(box, own.box.low));
            CHECK(contains(box, own.box.high));
            sum += tree.share(c, place);
            intensity += own.intensity;
        }
        CHECK(sum == Approx(1).epsilon(1e-6));
        const LightProxy proxy = tree.light_proxy(c);
        CHECK(proxy.strength * proxy.radius == Approx(intensity).epsilon(1e-4));
        // Draws come as often as their shares say.
        std::map<std::uint32_t, int> drawn;
        constexpr int draws = 4000;
        for (int i = 0; i < draws; ++i) ++drawn[tree.draw(c, (i + 0.5) / draws)];
        for (const auto& [place, count] : drawn) {
            REQUIRE(c.holds(place));
            CHECK(std::abs(count - draws * tree.share(c, place)) <= 2);
        }
    }
    Draw draw(3);
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from(draw.between(-2, 18), draw.between(-1, 5), draw.between(-5, 5));
        const LuminaireAt lamp =
            luminaires[static_cast<LightIndex>(draw.number() * static_cast<double>(tree.lights()))];
        const Vec3 direction = unit(bounds(*lamp).centre + 0.05 * draw.direction() - from);
        std::set<LightIndex> found;
        tree.along(from, direction, [&](LightIndex light) { found.insert(light); });
        for (LightIndex light = 0; light < tree.lights(); ++light) {
            LightHits hits;
            intersect(*luminaires[light], {from, direction}, direction, hits);
            if (hits.empty()) continue;
            ++met;
            CHECK(found.contains(light));
        }
    }
    CHECK(met > 1000);
}

}  // namespace candelabra
