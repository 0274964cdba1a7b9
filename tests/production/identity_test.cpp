// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/identity.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace candelabra {

TEST_CASE("what differs between two pictures has a name") {
    const std::vector<ReadFile> files = {{"/x/a.pov", "1"}, {"b.inc", "2"}};
    Options options;
    const Identity before = identity_of(options, files, {});
    CHECK(identity_from(to_text(before)) == before);
    CHECK(difference(before, before).empty());
    const auto now = [&](const auto& change) {
        Options changed = options;
        change(changed);
        return difference(before, identity_of(changed, files, {}));
    };
    CHECK(now([](Options& o) { o.render.width = 320; }) == "width was 640 and is 320");
    CHECK(now([](Options& o) { o.render.seed = 3; }) == "seed was 0 and is 3");
    CHECK(now([](Options& o) { o.render.light_sampler = EveryLight(); }) ==
          "light-sampler was not given and is every_light");
    CHECK(now([](Options& o) { o.declares.emplace_back("A", 2.0); }) ==
          "Declare=A was not given and is 2");
    CHECK(now([](Options& o) { o.facts.clock_given = true; }) == "Clock was not given and is 0");
    CHECK(now([](Options& o) { o.start_row = 3; }) == "Start_Row was not given and is 3");
    CHECK(now([](Options& o) { o.render.noise = 0.1; }) ==
          "sampling was adaptive: antialias_threshold 0.3, sampling_method 1, antialias_depth 3, "
          "antialias_gamma 2.5, jitter on, jitter_amount 1 and is until the noise is below 0.1");
    CHECK(now([](Options& o) { o.render.luminaires_above = INFINITY; }) ==
          "luminaires was not given and is none");
    CHECK(now([](Options& o) { o.alpha = true; }) == "Output_Alpha was not given and is on");
    CHECK(now([](Options& o) {
              o.layers = {PictureLayer::normal, PictureLayer::lights};
          }) == "layers was not given and is normal,lights");
    CHECK(now([](Options& o) { o.render.threads = 3; }).empty());
    CHECK(now([](Options& o) { o.render.samples = 64; }).empty());
    CHECK(now([](Options& o) { o.output = "other.png"; }).empty());

    const auto with = [&](std::vector<ReadFile> others) {
        return difference(before, identity_of(options, others, {}));
    };
    CHECK(with({{"/x/a.pov", "1"}, {"b.inc", "3"}}) == "`b.inc` has changed");
    CHECK(with({{"/y/a.pov", "1"}, {"/z/b.inc", "2"}}).empty());
    CHECK(with({{"a.pov", "1"}}) == "`b.inc` is not read any more");
    CHECK(with({{"a.pov", "1"}, {"b.inc", "2"}, {"c.inc", "2"}}) == "`c.inc` was not read then");
}

TEST_CASE("names of files may have any character") {
    const Identity identity = identity_of({}, {{"a\tb\nc.pov", "1"}}, {});
    CHECK(identity_from(to_text(identity)) == identity);
}

TEST_CASE("a picture says what it was made from, without folders") {
    Options options;
    options.render.samples = 4;
    const std::string text =
        description(identity_of(options, {{"/home/me/a.pov", "1"}}, {}), 4, {});
    CHECK(text.starts_with("Candelabra "));
    for (const char* part : {"scene a.pov, sha256 ", " width=640;", " seed=0;", " samples=4;"}) {
        CAPTURE(part, text);
        CHECK(text.find(part) != std::string::npos);
    }
    CHECK(text.find("/home") == std::string::npos);
}

}  // namespace candelabra
