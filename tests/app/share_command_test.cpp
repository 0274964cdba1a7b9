// SPDX-License-Identifier: GPL-3.0-or-later
// tests/production/share_page.py looks at pages in a browser.
#include "app/share_command.h"

#include "app/sandbox.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

constexpr auto two_named_lamps = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 }
plane { y, -1 pigment { rgb 0.7 } }
#declare Top = light_source { <0, 3, -2>, rgb <0.3, 0.2, 0.1> }
#declare Low = light_source { <3, 1, -1>, rgb <0.1, 0.3, 0.4> }
light_source { Top }
light_source { Low }
)";

struct Sharing : Shell {
    Sharing() { write("two.pov", two_named_lamps); }
    int share(std::vector<std::string> words) {
        words.insert(words.begin(), "share");
        return (*this)(words);
    }
    int share_scene(std::vector<std::string> words) {
        words.insert(words.begin(), {path("two.pov"), "+W24", "+H18", "--samples", "2"});
        return share(words);
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& each : fs::directory_iterator(folder))
            names.push_back(each.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
};

}  // namespace

TEST_CASE("share makes one page of a scene, and leaves nothing else") {
    Sharing shell;
    REQUIRE(shell.share_scene({"-o", shell.path("page.html")}) == exit_status::done);
    CHECK(has(shell.err, "page.html: 2 lamps, "));
    CHECK(shell.files() == std::vector<std::string>{"lit.pov", "page.html", "two.pov"});
    const std::string page = shell.content("page.html");
    CHECK(has(page, R"("names":["Low","Top","rest"])"));
    CHECK(has(page, "<title>page</title>"));
    CHECK(page.size() < 100'000);
    // The ending is added, and -V says nothing.
    REQUIRE(shell.share_scene({"-V", "-o", shell.path("other")}) == exit_status::done);
    CHECK(shell.err == "");
    CHECK(fs::exists(shell.path("other.html")));
}

TEST_CASE("a page of a file has the light that a page of the scene has") {
    Sharing shell;
    REQUIRE(shell.share_scene({"-o", shell.path("page.html")}) == exit_status::done);
    REQUIRE(shell({shell.path("two.pov"), "+W24", "+H18", "--samples", "2", "--layers", "lights",
                   "+O" + shell.path("page.exr")}) == exit_status::done);
    const std::string made = shell.content("page.html");
    REQUIRE(shell.share({shell.path("page.exr")}) == exit_status::done);  // beside the file
    CHECK(shell.content("page.html") == made);
    REQUIRE(shell.share({shell.path("page.exr"), "--exposure", "1", "+W99"}) == exit_status::done);
    CHECK(has(shell.err, "`Width=99` is ignored"));
    CHECK(has(shell.content("page.html"), R"("exposure":1.0)"));
    fs::create_directory(shell.path("out"));
    REQUIRE(shell.share({shell.path("page.exr"), "-o", shell.path("out")}) == exit_status::done);
    CHECK(fs::exists(shell.path("out/page.html")));
}

TEST_CASE("a denoised picture is shared denoised") {
    Sharing shell;
    const auto page = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"-o", shell.path("page.html")});
        REQUIRE(shell.share_scene(more) == exit_status::done);
        return shell.content("page.html");
    };
    CHECK(page({"--denoise"}) != page({}));
}

TEST_CASE("share says what it cannot do") {
    Sharing shell;
    CHECK(shell.share({"--help"}) == exit_status::done);
    CHECK(has(shell.out, "usage: candelabra share"));
    CHECK(shell.share({}) == exit_status::usage);
    CHECK(has(shell.err, "share needs a scene"));
    CHECK(shell.share({shell.path("no.exr")}) == exit_status::file);
    CHECK(shell.share({shell.path("a.exr"), shell.path("b.exr")}) == exit_status::usage);
    CHECK(has(shell.err, "a page has one picture"));
    CHECK(shell.share_scene({"+KFF3"}) == exit_status::usage);
    CHECK(has(shell.err, "there are frames"));
    CHECK(shell.share_scene({"--check"}) == exit_status::usage);
    CHECK(shell.share_scene({"--shard", "1/2"}) == exit_status::usage);
    CHECK(shell.share_scene({"-o", shell.path("no/such/page.html")}) == exit_status::usage);
    shell.write("wrong.pov", "sphere { 0 }\n");
    CHECK(shell.share({shell.path("wrong.pov"), "-o", shell.path("w.html")}) == exit_status::scene);
    CHECK_FALSE(fs::exists(shell.path("w.html")));
    REQUIRE(shell({shell.path("two.pov"), "+W8", "+H6", "+O" + shell.path("plain.exr")}) == 0);
    CHECK(shell.share({shell.path("plain.exr")}) == exit_status::file);
    CHECK(has(shell.err, "render it with --layers lights"));
    std::string many = two_named_lamps;
    for (int i = 0; i < 40; ++i) many += "light_source { 9, rgb 0.01 }\n";
    shell.write("many.pov", many);
    CHECK(shell.share({shell.path("many.pov"), "+W8", "+H6", "-o", shell.path("m.html")}) ==
          exit_status::file);
    CHECK(has(shell.err, "a page has up to 32 lamps, and there are 42"));
    CHECK(has(shell.err, "is kept in"));
    CHECK(fs::exists(shell.path(".m.share.exr")));
}

TEST_CASE("the sandbox of share lets the page be written where it goes") {
    Sharing shell;
    fs::create_directory(shell.path("out"));
    std::vector<std::string> writable;
    shell.confine = [&](const SandboxRules& rules) {
        writable = rules.writable;
        return true;
    };
    REQUIRE(shell.share_scene({"-o", shell.path("out/page.html")}) == exit_status::done);
    CHECK(std::ranges::count(writable, shell.path("out")) == 1);
}

}  // namespace candelabra
