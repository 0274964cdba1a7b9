// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/movie.h"

#include "app/child.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace candelabra {

TEST_CASE("frames are listed with their time, quotes in names and all", "[app]") {
    CHECK(movie_list({"/a/x1.png", "/a/it's.png"}, 25) ==
          "ffconcat version 1.0\nfile '/a/x1.png'\nduration 0.04\nfile '/a/it'\\''s.png'\n"
          "duration 0.04\n");
}

TEST_CASE("pictures that are made for a film only are hidden, one for each frame", "[app]") {
    CHECK(hidden_part("films/a.mp4", 7, ".png") == "films/.a.part.7.png");
    CHECK(hidden_part("a.mp4", 0, ".png") == ".a.part.0.png");
}

TEST_CASE("a film has even sizes, a moving picture of gif its own", "[app]") {
    const auto has = [](const std::string& film, const std::string& word) {
        for (const std::string& each : movie_arguments("list", film))
            if (each == word) return true;
        return false;
    };
    CHECK(has("a.mp4", "yuv420p"));
    CHECK_FALSE(has("a.gif", "yuv420p"));
    CHECK_FALSE(has("A.GIF", "yuv420p"));
    // A name that begins with a hyphen is not taken for an option of ffmpeg.
    CHECK(has("-a.mp4", "./-a.mp4"));
}

TEST_CASE("a film has the frames with less noise, if they were asked for", "[app][denoise]") {
    if (find_program("ffmpeg").empty()) return;
    Shell shell;
    const auto film_of = [&](const std::string& frames, std::vector<std::string> more) {
        std::vector<std::string> words = {"+KFF2", "+W32",       "+H24", "--samples",
                                          "4",     "--response", "agx"};
        words.insert(words.end(), {"+O" + shell.path(frames), "--movie", shell.path("film.gif")});
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(shell.render(words) == 0);
        return shell.content("film.gif");
    };
    const std::string exact = film_of("a.png", {}), quiet = film_of("a.png", {"--denoise"});
    CHECK(exact != quiet);
    // The denoised frames must exist as well as the exact ones.
    std::filesystem::remove(shell.path("a2.denoised.png"));
    CHECK(film_of("a.png", {"--denoise", "--skip-existing"}) == quiet);
    // OpenEXR frames are developed first.
    CHECK(film_of("b.exr", {}) == exact);
    CHECK(film_of("b.exr", {"--denoise"}) == quiet);
    for (const auto& each : std::filesystem::directory_iterator(shell.path("")))
        for (const char* left_over : {"film.gif.", ".part."})
            CHECK(each.path().string().find(left_over) == std::string::npos);
}

TEST_CASE("films are made whole, and kinds that are none are refused before the work", "[app]") {
    if (find_program("ffmpeg").empty()) return;
    Shell shell;
    const auto film = [&](const std::string& name) { return shell.path(name); };
    const std::vector<std::string> options = {"+KFF3", "+W15", "+H11", "+O" + film("f.png")};
    for (const char* name : {"it's a film.mp4", "a.gif"}) {
        std::vector<std::string> words = options;
        words.insert(words.end(), {"--movie", film(name)});
        REQUIRE(shell.render(words) == 0);
        CHECK(std::filesystem::file_size(film(name)) > 100);
    }
    for (const auto& each : std::filesystem::directory_iterator(shell.path("")))
        CHECK(each.path().string().find(".part") == std::string::npos);
    shell.write("f.xyz", "kept");
    Diagnostics diagnostics;
    CHECK_FALSE(can_make_movie(25, film("f.xyz"), diagnostics));
    CHECK_FALSE(make_movie({film("f1.png")}, 25, film("f.xyz"), diagnostics));
    CHECK(shell.content("f.xyz") == "kept");
    CHECK(diagnostics.failed());
}

}  // namespace candelabra
