// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/problems.h"

#include "support/edited.h"

namespace candelabra {

namespace {

std::map<std::string, std::vector<Json>> found(Edited& edited) {
    Report result;
    report(edited.workspace, edited.path, edited.folder / "scratch", result);
    return problems(result, edited.workspace, edited.path);
}

}  // namespace

TEST_CASE("a problem is shown where it is, with all that a message has") {
    Edited edited("camera { location -5*z look_at 0 }\nsphere { 0, 1 finish { emision 3 } }");
    const auto all = found(edited);
    REQUIRE(all.at(edited.path).size() == 1);
    const Json& one = all.at(edited.path)[0];
    CHECK(one["severity"] == 1);
    CHECK(one["range"]["start"]["line"] == 1);
    CHECK(one["message"].get<std::string>().find("help: did you mean `emission`?") !=
          std::string::npos);
}

TEST_CASE("a problem in a file that is not open is shown where an open one leads there") {
    Edited edited("camera { location -5*z look_at 0 }\n#include \"b.inc\"");
    edited.folder.put("b.inc", "\n\nsphere { 0, Size }");
    auto all = found(edited);
    REQUIRE(all.at(edited.path).size() == 1);
    CHECK(all.at(edited.path)[0]["range"]["start"]["line"] == 1);
    const Json related = all.at(edited.path)[0]["relatedInformation"];
    REQUIRE(related.size() >= 1);
    CHECK(related[0]["location"]["range"]["start"]["line"] == 2);
    edited.workspace.open(edited.folder / "b.inc", "\n\nsphere { 0, Size }");
    all = found(edited);
    CHECK(all.at(edited.path).empty());
    CHECK(all.at(edited.folder / "b.inc").size() == 1);
}

}  // namespace candelabra
