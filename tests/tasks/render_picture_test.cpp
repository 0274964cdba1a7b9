// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/render_picture.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("a part of the picture is rendered as the whole one has it") {
    Shell shell;
    REQUIRE(shell.render({"-V", "+O" + shell.path("whole.ppm")}) == 0);
    REQUIRE(shell.render({"-V", "+O" + shell.path("part.ppm"), "+SR4", "+ER6"}) == 0);
    const std::string whole = shell.content("whole.ppm"), part = shell.content("part.ppm");
    constexpr std::size_t row = 16 * 3;
    const auto rows = [&](const std::string& picture, std::size_t first) {
        return picture.substr(picture.size() - (12 - first) * row, 3 * row);
    };
    CHECK(rows(part, 3) == rows(whole, 3));
    CHECK(rows(part, 0) == std::string(3 * row, '\0'));
    CHECK(shell.render({"+SR6", "+ER4"}) == 2);
    CHECK(has(shell.err, "no row or column"));
}

TEST_CASE("a finished picture that keeps its state takes more samples") {
    Shell shell;
    const std::string file = "+O" + shell.path("a.png");
    REQUIRE(shell.render({"-V", file, "--samples", "5"}) == 0);
    const auto run = [&](std::vector<std::string> more) {
        more.insert(more.end(), {shell.path("lit.pov"), "+W16", "+H12", file, "-V"});
        return shell(more);
    };
    REQUIRE(run({"--samples", "9"}) == 0);
    const std::string nine = shell.content("a.png");
    CHECK_FALSE(fs::exists(shell.path("a.png.state.exr")));
    REQUIRE(run({"--samples", "4", "--keep-state"}) == 0);
    CHECK(fs::exists(shell.path("a.png.state.exr")));
    CHECK(shell.content("a.png") != nine);
    REQUIRE(run({"--samples", "9", "+C"}) == 0);
    CHECK(shell.content("a.png") == nine);
    CHECK_FALSE(fs::exists(shell.path("a.png.state.exr")));

    REQUIRE(run({"--samples", "8", "--keep-state"}) == 0);
    const auto refused = [&](std::vector<std::string> more, std::string_view why) {
        more.push_back("+C");
        CHECK(run(more) == 3);
        CAPTURE(shell.err, why);
        CHECK(has(shell.err, why));
    };
    refused({"--samples", "4"}, "it has up to 8 samples in a pixel already");
    refused({"--samples", "9", "--seed", "2"}, "seed was 0 and is 2");
    refused({"--samples", "9", "-A"}, "antialias was on and is off");
    shell.write("lit.pov", std::string(lit_scene) + " ");
    refused({"--samples", "9"}, "`lit.pov` has changed");
    shell.write("a.png.state.exr", "short");
    refused({"--samples", "9"}, "cannot read");
    CHECK(fs::exists(shell.path("a.png")));
}

TEST_CASE("pictures with a wish for noise or a limit of time are finished") {
    Shell shell;
    const std::string file = "+O" + shell.path("a.png");
    CHECK(shell({shell.path("lit.pov"), "+W16", "+H12", file, "--time", "0.1"}) == 0);
    CHECK(fs::exists(shell.path("a.png")));
    CHECK(shell({shell.path("lit.pov"), "+W16", "+H12", file, "--noise", "0.2"}) == 0);
    const std::string once = shell.content("a.png");
    CHECK(shell({shell.path("lit.pov"), "+W16", "+H12", file, "--noise", "0.2", "+WT1"}) == 0);
    CHECK(shell.content("a.png") == once);
}

TEST_CASE("a shutter that stays open blurs what the clock moves") {
    Shell shell;
    shell.write("moving.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
        camera { orthographic right 4*x up 4*y location -5*z look_at 0 shutter 2, 2 }
        box { <-2, -2, 0>, <-1, 2, 1> translate clock*x
              pigment { rgb 1 } finish { ambient 1 diffuse 0 } })");
    const std::string file = "+O" + shell.path("a.ppm");
    REQUIRE(shell({shell.path("moving.pov"), "+W4", "+H1", "-A", "-V", file}) == 0);
    // The box covers the first column at clock 0, the second at clock 1.
    const std::string picture = shell.content("a.ppm");
    const std::string row = picture.substr(picture.size() - 12);
    const auto grey = [&](std::size_t column) {
        return static_cast<int>(static_cast<unsigned char>(row[3 * column]));
    };
    CHECK(grey(0) == 188);
    CHECK(grey(1) == 188);
    CHECK(grey(2) == 0);
    CHECK(grey(3) == 0);
}

}  // namespace candelabra
