// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/lookalikes.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using LookNames = std::vector<std::string>;

/// The text of the first warning about a scene, or nothing.
std::string warning_about(const std::string& scene, const std::string& povray) {
    SourceStore sources;
    sources.add("scene.pov", scene);
    sources.add("/library/woods.inc",
                "// Woods.\n// Only alike to POV-Ray's: Water, T_Wood1 to T_Wood3\nT_Wood1");
    Diagnostics diagnostics;
    const auto in_library = [](std::string_view path) { return path.starts_with("/library/"); };
    review_lookalikes(sources, in_library, povray, diagnostics);
    CHECK(diagnostics.all().size() < 2);
    return diagnostics.all().empty() ? "" : diagnostics.all()[0].message;
}

}  // namespace

TEST_CASE("an include file lists the names that are only alike", "[session]") {
    const std::pair<std::string, LookNames> rows[] = {
        {"", {}},
        {"// Woods.\n#declare A = 1;", {}},
        {"// Only alike to POV-Ray's: Water", {"Water"}},
        {"// x\n// Only alike to POV-Ray's: A, B,\n// Only alike to POV-Ray's: C\n",
         {"A", "B", "C"}},
        {"// Only alike to POV-Ray's: T9 to T11", {"T9", "T10", "T11"}},
        {"// Only alike to POV-Ray's: T1A to T2A, T0a", {"T1A", "T2A", "T0a"}},
        {"// Only alike to POV-Ray's: T1 to U2", {"T1"}},
        {"// Only alike to POV-Ray's: T3 to T1", {"T3"}},
    };
    for (const auto& [text, expected] : rows) {
        CAPTURE(text);
        CHECK(only_alike(text) == expected);
    }
}

TEST_CASE("a name that is only alike is warned of where POV-Ray's is at hand", "[session]") {
    const Folder folder;
    const std::string povray = folder.path().string();
    const std::string use = "sphere { 0, 1 texture { T_Wood3 } } texture { Water }";
    CHECK(warning_about(use, povray).empty());  // it has no such file
    folder.put("woods.inc", "");
    CHECK(warning_about(use, povray).starts_with("`T_Wood3` of woods.inc"));
    CHECK(warning_about("texture { T_Wood4 }", povray).empty());
    CHECK(warning_about("// T_Wood3\n/* Water */ #debug \"Water\" My_Water", povray).empty());
    CHECK(warning_about("/* no end Water", povray).empty());
    CHECK(warning_about("\"no end Water", povray).empty());
    CHECK(warning_about("1/2 Water", povray).starts_with("`Water`"));
    CHECK(warning_about(use, "").empty());
}

}  // namespace candelabra
