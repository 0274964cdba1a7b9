// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/movie.h"

#include <catch2/catch.hpp>

TEST_CASE("frames are listed with their time, quotes in names and all", "[app]") {
    CHECK(movie_list({"/a/x1.png", "/a/it's.png"}, 25) ==
          "ffconcat version 1.0\nfile '/a/x1.png'\nduration 0.04\nfile '/a/it'\\''s.png'\n"
          "duration 0.04\n");
}

TEST_CASE("a film has even sizes, a moving picture of gif its own", "[app]") {
    const auto has = [](const std::string& film, const std::string& word) {
        for (const std::string& each : movie_arguments("list", film))
            if (each == word) return true;
        return false;
    };
    CHECK(has("a.mp4", "yuv420p"));
    CHECK_FALSE(has("a.gif", "yuv420p"));
    // A name that begins with a hyphen is no option of ffmpeg.
    CHECK(has("-a.mp4", "./-a.mp4"));
}
