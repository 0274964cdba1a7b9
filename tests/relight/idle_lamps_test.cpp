// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/idle_lamps.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// One tile of six lamps: bright and alone, faint and alone, two in a bright node, two in a faint
/// one.
LightRecords six_lamps() {
    LightRecords records;
    records.width = records.height = 8;
    records.lamps = LampList({{"A", 1}, {"B", 5}}, {0, 4, 0, 1, 2, 3}, std::vector<float>(6, 1));
    records.tiles.resize(1);
    TileRecords& tile = records.tiles[0];
    std::vector<TilePlanes> light(2);
    light[0].fill(0.2F);
    light[1].fill(0.0005F);
    tile.nodes = {{2, 4}, {4, 6}};
    tile.own = {{0, 9, false, {0.1F, 0, 0}}, {1, 9, false, {0.0002F, 0, 0}}};
    tile.residual = {{2, 9, false, {0.2F, 0.2F, 0.2F}}};
    round_to_file(tile, light);
    return records;
}

const std::vector<bool> all_lit(6, true);

}  // namespace

TEST_CASE("a lamp is idle if the most that it may give changes no displayed value", "[relight]") {
    LightRecords records = six_lamps();
    CHECK(idle_lamps(records, all_lit, 2) ==
          std::vector<bool>{false, true, false, false, true, true});
    CHECK(idle_lamps_report(records.lamps, idle_lamps(records, all_lit, 1)) ==
          "could be off alone, since no pixel changes by 1/255 without it: B[2..4]\n");
    // The third lamp has no light, whatever there is in its node.
    std::vector<bool> lit = all_lit;
    lit[2] = false;
    CHECK(idle_lamps_report(records.lamps, idle_lamps(records, lit, 1)) ==
          "could be off alone, since no pixel changes by 1/255 without it: B[0], [2..4]\n");
    // A ray met a lamp that is in a faint node as well, and the sum is seen.
    records.tiles[0].own.push_back({4, 20, false, {0.0001F, 0, 0}});
    records.tiles[0].own.push_back({4, 20, true, {0.2F, 0, 0}});
    CHECK_FALSE(idle_lamps(records, all_lit, 1)[4]);
}

TEST_CASE("a film shows which lamps are idle as it shows their light", "[relight]") {
    LightRecords records = six_lamps();
    records.film = "film=on exposure=10";
    // All is white; it is so without the first lamp, but not without the light of its first node.
    CHECK(idle_lamps(records, all_lit, 1) ==
          std::vector<bool>{true, true, false, false, true, true});
    records.film = "film=on exposure=-10";
    CHECK(idle_lamps(records, all_lit, 1) == std::vector<bool>(6, true));  // all is black
    records.film = "film=on exposure=-1";
    CHECK(idle_lamps(records, all_lit, 1) ==
          std::vector<bool>{false, true, false, false, true, true});
    // Glare brings light to pixels of which the records do not tell.
    records.film = "film=on glare=on";
    CHECK(idle_lamps(records, all_lit, 1) == std::vector<bool>(6, false));
    CHECK(idle_lamps(records, {true, false, true, true, true, true}, 1)[1]);
}

TEST_CASE("lamps that have names of their own are told without numbers", "[relight]") {
    const LampList lamps({{"A", 1}, {"B", 5}}, {0, 4, 0, 1, 2, 3}, std::vector<float>(6, 1));
    CHECK(idle_lamps_report(lamps, std::vector<bool>(6, false)).empty());
    CHECK(idle_lamps_report(lamps, std::vector<bool>(6, true)) ==
          "could be off alone, since no pixel changes by 1/255 without it: A\n"
          "could be off alone, since no pixel changes by 1/255 without it: B[0..4]\n");
}

}  // namespace candelabra
