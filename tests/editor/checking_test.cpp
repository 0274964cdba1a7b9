// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/checking.h"

#include "support/folder.h"

#include <chrono>

namespace candelabra {

namespace {

struct Checked {
    Folder folder;
    Workspace workspace{CANDELABRA_SOURCE_DIR "/stdlib"};
    std::string path = folder / "a.pov";

    std::vector<Json> operator()(const std::string& text, const CheckLimits& limits = {}) {
        workspace.open(path, text);
        return check(workspace, path, folder / "scratch", limits)[path];
    }
};

}  // namespace

TEST_CASE("a check in another process finds what one in this finds") {
    Checked checked;
    const std::string text = "sphere { 0, Size }\n\xff";
    const auto found = checked(text);
    Report here;
    report(checked.workspace, checked.path, checked.folder / "scratch", here);
    CHECK_FALSE(found.empty());
    CHECK(found.size() == problems(here, checked.workspace, checked.path)[checked.path].size());
    CHECK(checked("camera { location -5*z look_at 0 }\nlight_source { 5*y, rgb 1 }\n"
                  "sphere { 0, 1 pigment { rgb 1 } }")
              .empty());
}

TEST_CASE("a check that takes long is ended, and says so") {
    Checked checked;
    const auto begin = std::chrono::steady_clock::now();
    // Few steps, each of which takes long.
    const auto found = checked(
        "#declare S = \"aaaaaaaaaaaaaaaa\";\n"
        "#for (I, 1, 21) #declare S = concat(S, S); #end\n"
        "#for (I, 1, 1e6) #declare T = concat(S, \"a\"); #end",
        {.milliseconds = 500});
    CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(8));
    REQUIRE(found.size() == 1);
    CHECK(found[0]["severity"] == 2);
    CHECK(found[0]["message"].get<std::string>().starts_with(
        "this scene is not checked: that takes more than 0.5 s\nhelp: "));
}

TEST_CASE("a check that takes much memory is ended, and says so") {
    Checked checked;
    const auto found = checked("#declare A = array[100000000];", {.bytes = std::uint64_t{1} << 26});
    REQUIRE(found.size() == 1);
    CHECK(found[0]["message"].get<std::string>().find("memory") != std::string::npos);
}

}  // namespace candelabra
