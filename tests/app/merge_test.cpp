// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/merge.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <random>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

struct Farm : Shell {
    int share(const std::string& shard, std::vector<std::string> more = {}) {
        more.insert(more.end(), {path("lit.pov"), "-V", "+W40", "+H36", "+O" + path("a.png"),
                                 "--shard", shard});
        return (*this)(more);
    }
    int merge(const std::vector<std::string>& shards, std::vector<std::string> more = {}) {
        more.insert(more.begin(), "merge");
        for (const std::string& shard : shards)
            more.push_back(path("a.png." + shard + ".state.exr"));
        return (*this)(more);
    }
    std::string alone(std::vector<std::string> more) {
        more.insert(more.end(), {path("lit.pov"), "-V", "+W40", "+H36", "+O" + path("b.png")});
        REQUIRE((*this)(more) == 0);
        return content("b.png");
    }
};

}  // namespace

TEST_CASE("ten random partitions are merged to the bytes of the single run") {
    std::mt19937 random(11);
    for (int i = 0; i < 10; ++i) {
        Farm farm;
        const bool tiles = i % 3 == 0;
        const int count = 1 + static_cast<int>(random() % 6);
        const std::vector<std::string> way =
            tiles ? std::vector<std::string>{} : std::vector<std::string>{"--samples", "6"};
        const std::string whole = farm.alone(way);
        std::vector<std::string> shards;
        for (int k = 1; k <= count; ++k) {
            std::vector<std::string> more = way;
            if (tiles) more.insert(more.end(), {"--shard-by", "tiles"});
            REQUIRE(farm.share(std::to_string(k) + "/" + std::to_string(count), more) == 0);
            shards.push_back(shard_name({k, count}));
        }
        std::shuffle(shards.begin(), shards.end(), random);
        CHECK_FALSE(fs::exists(farm.path("a.png")));
        REQUIRE(farm.merge(shards) == 0);
        CAPTURE(i, count, tiles);
        CHECK(farm.content("a.png") == whole);
    }
}

TEST_CASE("merging refuses what does not fit together, and says what is missing") {
    Farm farm;
    const std::vector<std::string> six = {"--samples", "6"};
    for (const char* shard : {"1/3", "2/3", "3/3", "1/2"}) REQUIRE(farm.share(shard, six) == 0);
    CHECK(farm.merge({"1of3", "3of3"}) == 2);
    CHECK(has(farm.err, "samples 2 to 3 of 0 to 5 are missing"));
    CHECK_FALSE(fs::exists(farm.path("a.png")));
    CHECK(farm.merge({"1of3", "3of3"}, {"--partial"}) == 0);
    CHECK(fs::exists(farm.path("a.png")));
    fs::remove(farm.path("a.png"));
    CHECK(farm.merge({"3of3", "1of3"}, {"--status"}) == 2);
    CHECK(has(farm.out, "a.png.1of3.state.exr: samples 0 to 1 of 0 to 5, finished\n"));
    CHECK(has(farm.err, "samples 2 to 3 of 0 to 5 are missing"));
    CHECK(farm.merge({"1of3", "2of3", "3of3"}, {"--status"}) == 0);
    CHECK_FALSE(fs::exists(farm.path("a.png")));
    CHECK(farm.merge({"1of3", "2of3", "3of3", "1of2"}) == 2);
    CHECK(has(farm.err, "of which another shard has some, too"));
    REQUIRE(farm.share("2/2", {"--samples", "6", "--seed", "1"}) == 0);
    CHECK(farm.merge({"1of2", "2of2"}) == 2);
    CHECK(has(farm.err, "seed was 0 and is 1"));
    REQUIRE(farm.share("1/2", {"--shard-by", "tiles"}) == 0);
    CHECK(farm.merge({"1of2", "1of2"}) == 2);
    CHECK(has(farm.err, "is there twice"));
    CHECK(farm.merge({"1of2"}) == 2);
    CHECK(has(farm.err, "shard 2 of 2 is missing"));
    CHECK(farm.merge({"1of2"}, {"--status"}) == 2);
    CHECK(has(farm.out, "a.png.1of2.state.exr: part 1 of 2 by tiles, finished\n"));
    CHECK(farm.merge({}) == 2);
    CHECK(farm({"merge", farm.path("lit.pov")}) == 2);
    CHECK(farm({"merge", "--help"}) == 0);
    CHECK(has(farm.out, "usage: candelabra merge"));
    farm.write("a.png.1of2.state.exr", "nonsense");
    CHECK(farm.merge({"1of2"}) == 3);
}

TEST_CASE("shares can be joined to larger shares first") {
    Farm farm;
    const std::string whole = farm.alone({"--samples", "6"});
    for (const char* shard : {"1/3", "2/3", "3/3"})
        REQUIRE(farm.share(shard, {"--samples", "6"}) == 0);
    REQUIRE(farm.merge({"2of3", "1of3"}, {"--partial", "+O" + farm.path("a.png.1to2.state.exr")}) ==
            0);
    REQUIRE(farm.merge({"3of3", "1to2"}, {"+O" + farm.path("a.png")}) == 0);
    CHECK(farm.content("a.png") == whole);
    // A state stores a contiguous range of samples, so it cannot have a gap.
    const std::string gap = farm.path("gap.state.exr");
    CHECK(farm.merge({"1of3", "3of3"}, {"--partial", "+O" + gap}) == 2);
    CHECK(has(farm.err, "samples 2 to 3 of 0 to 5 are missing"));
    CHECK_FALSE(fs::exists(gap));
}

TEST_CASE("shards must know what they share") {
    Farm farm;
    CHECK(farm.share("1/2") == 2);
    CHECK(has(farm.err, "--samples N, or --shard-by tiles"));
    CHECK(farm.share("1/2", {"--time", "1"}) == 2);
    CHECK(farm.share("1/2", {"--shard-by", "frames"}) == 2);
    CHECK(farm.share("7/9", {"--samples", "2"}) == 2 + 1);
    CHECK(has(farm.err, "more shards than"));
}

TEST_CASE("options that mean nothing to merge are not passed over in silence") {
    Farm farm;
    for (const char* shard : {"1/2", "2/2"}) REQUIRE(farm.share(shard, {"--samples", "2"}) == 0);
    CHECK(farm.merge({"1of2", "2of2"}, {"+W99", "--samples", "5", "-V"}) == 0);
    CHECK(has(farm.err, "`Width=99` is ignored: the states have the way in which the picture "
                       "is made"));
    CHECK(has(farm.err, "`--samples=5` is ignored"));
    CHECK(farm.merge({"1of2", "2of2"}, {"-V", "+FN16", "+O" + farm.path("b.png")}) == 0);
    CHECK(farm.err.empty());
}

TEST_CASE("light that shards by tiles keep is merged to the bytes of the single run", "[relight]") {
    Farm farm;
    farm.write("lit.pov", std::string(lit_scene) +
                              "#for (I, 0, 99) sphere { <I/10 - 5, 1, 0>, 0.01 pigment { rgb 1 } "
                              "finish { ambient 0 diffuse 0 emission 30 } } #end\n"
                              "meter { \"M\" points { 2, <0, -0.9, 0>, <1, -0.9, 0> } }");
    const std::vector<std::string> way = {"--samples", "16", "--keep-lights-size", "80K"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), way.begin(), way.end());
        return more;
    };
    farm.alone(with({"--keep-lights", farm.path("whole.lights"), "+WT1"}));
    const std::string whole = farm.content("whole.lights");
    REQUIRE(whole != "");
    for (const char* shard : {"1/3", "2/3", "3/3"})
        REQUIRE(farm.share(shard, with({"--keep-lights", farm.path("part.lights"), "--shard-by",
                                        "tiles", "+WT2"})) == 0);
    CHECK_FALSE(fs::exists(farm.path("part.lights")));
    const std::vector<std::string> all = {"3of3", "1of3", "2of3"};
    REQUIRE(farm.merge(all, {"--keep-lights", farm.path("merged.lights")}) == 0);
    CHECK(farm.err == "");
    CHECK(farm.content("a.png") == farm.content("b.png"));
    CHECK(farm.content("merged.lights") == whole);
    // A state that they make has it, too.
    REQUIRE(farm.merge({"1of3", "2of3", "3of3"}, {"+O" + farm.path("c.state.exr")}) == 0);
    REQUIRE(farm({"merge", farm.path("c.state.exr"), "+O" + farm.path("c.png"), "--keep-lights",
                  farm.path("again.lights")}) == 0);
    CHECK(farm.content("again.lights") == whole);
    // Of some of the shards there is their light, and the rest is dark.
    REQUIRE(farm.merge({"1of3", "3of3"},
                       {"--partial", "--keep-lights", farm.path("some.lights")}) == 0);
    const auto pixels = [&](const std::string& lights) {
        REQUIRE(farm({"relight", farm.path(lights), "--exposure", "0", "--glare", "off",
                      "+O" + farm.path("some.ppm")}) == 0);
        return farm.content("some.ppm").substr(farm.content("some.ppm").size() - 40 * 36 * 3);
    };
    const std::string some = pixels("some.lights"), right = pixels("whole.lights");
    int dark = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        dark += some[i] == 0 && right[i] != 0;
        CHECK((some[i] == 0 || some[i] == right[i]));
    }
    CHECK(dark > 100);
    CHECK(farm.merge({"1of3", "3of3"}, {"--keep-lights", farm.path("none.lights")}) != 0);
    // Without the option there is the picture alone, and without light there is none to merge.
    REQUIRE(farm.merge(all) == 0);
    REQUIRE(farm.share("2/3", {"--samples", "16", "--shard-by", "tiles"}) == 0);
    CHECK(farm.merge(all, {"--keep-lights", farm.path("none.lights")}) != 0);
    CHECK(has(farm.err, "not all of the states have kept light"));
}

}  // namespace candelabra
