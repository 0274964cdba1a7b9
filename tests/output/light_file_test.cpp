// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_file.h"

#include "picture/layers.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <bit>

namespace candelabra {

namespace {

struct Files : Shell {
    /// Writes a file of one pixel. Each plane has a value.
    LightFile made(const std::vector<std::pair<std::string, float>>& planes,
                   const std::string& film = "") {
        LayeredPicture picture{1, 1, {}, {}};
        for (const auto& [name, value] : planes)
            picture.planes.push_back({name, false, {std::bit_cast<std::uint32_t>(value)}});
        if (!film.empty()) picture.texts.emplace_back("candelabraFilm", film);
        write("x.exr", encode(picture, diagnostics).value());
        return LightFile::read(path("x.exr"), diagnostics).value();
    }
    std::string last() const {
        return diagnostics.all().empty() ? "" : diagnostics.all().back().message;
    }

    Diagnostics diagnostics;
};

}  // namespace

TEST_CASE("a file of light has pictures in colours and in grey, and alpha from 0 to 1") {
    Files files;
    const LightFile file = files.made(
        {{"R", 1}, {"G", 2}, {"B", 3}, {"A", 7}, {"dim.Y", 0.5F}, {"odd.R", 1}, {"odd.G", 1}});
    CHECK(file.image("")->at(0, 0) == Rgb(1, 2, 3));
    CHECK(file.image("dim")->at(0, 0) == Rgb(0.5));
    CHECK_FALSE(file.image("odd"));
    CHECK(file.alpha("") == std::vector<double>{1});
    CHECK(file.alpha("dim").empty());
    CHECK(file.layers().size() == 2);
    CHECK_FALSE(LightFile::read(files.path("no.exr"), files.diagnostics));
}

TEST_CASE("the lamps of a file of light add up to its picture") {
    Files files;
    const std::vector<std::pair<std::string, float>> planes = {{"Y", 3}, {"light.Top.Y", 2}};
    const auto lamps = [&](float rest) {
        auto all = planes;
        if (rest != 0) all.emplace_back("light.rest.Y", rest);
        const LightFile file = files.made(all);
        return lamps_of(file, "light.", *file.image(""), files.diagnostics);
    };
    CHECK(lamps(1) == std::vector<std::string>{"Top", "rest"});
    CHECK(lamps(0) == std::vector<std::string>{"Top"});  // the rest is not known
    CHECK_FALSE(lamps(2));
    CHECK(has(files.last(), "do not add up"));
    const LightFile plain = files.made({{"Y", 1}});
    CHECK_FALSE(lamps_of(plain, "light.", *plain.image(""), files.diagnostics));
    CHECK(has(files.last(), "has no layers of light"));
}

TEST_CASE("the film of a file is changed by options") {
    Files files;
    Options options;
    options.render.film = {{"exposure", "2"}};
    const LightFile file = files.made({{"Y", 1}}, "film=on response=agx exposure=1");
    const auto film = film_of(file, options, files.diagnostics);
    REQUIRE(film);
    CHECK(film->exposure == 2);
    CHECK(film->response == "agx");
    CHECK(film_of(file, {}, files.diagnostics)->exposure == 1);
    CHECK(files.diagnostics.all().empty());
    const LightFile strange = files.made({{"Y", 1}}, "film=on taste=7");
    CHECK(film_of(strange, {}, files.diagnostics)->response == "linear");
    CHECK(has(files.last(), "this version does not know"));
}

}  // namespace candelabra
