// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation_run.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace fs = std::filesystem;

TEST_CASE("shards of an animation have every so many frames") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    REQUIRE(shell.render({"-V", file, "+KFF5", "--shard", "2/3"}) == 0);
    for (const int frame : {1, 2, 3, 4, 5})
        CHECK(fs::exists(shell.path("f" + std::to_string(frame) + ".png")) ==
              (frame == 2 || frame == 5));
    CHECK(shell.render({"-V", file, "+KFF5", "--shard", "4/3"}) == 2);
}

TEST_CASE("+C goes on with an animation at the frame that was begun") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    int calls = 0;
    shell.interrupts.take = [&] { return ++calls == 32 ? Interrupt::stop : Interrupt::none; };
    CHECK(shell.render({"-V", file, "+KFF3", "+WT1", "+C"}) == exit_status::stopped);
    CHECK(fs::exists(shell.path("f1.png")));
    CHECK(fs::exists(shell.path("f2.png.state.exr")));
    shell.write("f1.png", "kept");
    CHECK(shell.render({"-V", file, "+KFF3", "+C"}) == 0);
    CHECK(shell.content("f1.png") == "kept");
    CHECK(fs::exists(shell.path("f2.png")));
    CHECK(fs::exists(shell.path("f3.png")));
    CHECK_FALSE(fs::exists(shell.path("f2.png.state.exr")));
}

TEST_CASE("what is wrong with the command line is said once, whichever frames a run has") {
    for (const char* shard : {"1/1", "2/3"}) {
        Shell shell;
        REQUIRE(shell.render(
                    {"-V", "+O" + shell.path("f.png"), "+KFF3", "--shard", shard, "+BS16"}) == 0);
        const std::size_t said = shell.err.find("`+BS16` is ignored");
        CHECK(said != std::string::npos);
        CHECK(shell.err.find("is ignored", said + 20) == std::string::npos);
    }
}

TEST_CASE("a film that cannot be made is refused before the first frame") {
    Shell shell;
    const auto refused = [&](std::vector<std::string> more, std::string_view why) {
        more.insert(more.begin(), {"--movie", shell.path("f.mp4"), "+O" + shell.path("f.png")});
        CHECK(shell.render(more) == exit_status::usage);
        CAPTURE(shell.err, why);
        CHECK(has(shell.err, why));
        CHECK_FALSE(fs::exists(shell.path("f1.png")));
    };
    refused({}, "a film needs the frames of an animation");
    refused({"+KFF2", "--shard", "1/2"}, "of which a shard has some");
    refused({"+KFF2", "-F"}, "frames in files");
    refused({"+KFF2", "--movie", shell.path("none/f.mp4")}, "there is no folder");
    // A check makes no film.
    CHECK(shell.render({"--check", "+KFF2", "--movie", shell.path("f.mp4")}) == 0);
    CHECK_FALSE(fs::exists(shell.path("f.mp4")));
}

TEST_CASE("programs hear one progress of all frames, and each frame has its own figures") {
    Shell shell;
    REQUIRE(shell.render({"-V", "+O" + shell.path("f.png"), "+KFF2", "--progress", "openjd",
                          "--stats", shell.path("s.json"), "--depfile", shell.path("d")}) == 0);
    std::vector<int> heard;
    for (std::size_t at = 0; (at = shell.out.find(": ", at)) != std::string::npos; ++at)
        heard.push_back(std::stoi(shell.out.substr(at + 2)));
    CHECK(std::is_sorted(heard.begin(), heard.end()));
    CHECK(std::count(heard.begin(), heard.end(), 50) == 1);
    CHECK(std::count(heard.begin(), heard.end(), 100) == 1);
    for (const char* name : {"s1.json", "s2.json", "d1", "d2"}) CHECK(fs::exists(shell.path(name)));
}
