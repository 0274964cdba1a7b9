// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/report.h"

#include "support/edited.h"

namespace candelabra {

namespace {

std::string first_message(Edited& edited) {
    Report result;
    report(edited.workspace, edited.path, edited.folder / "scratch", result);
    const auto& all = result.diagnostics.all();
    return all.empty() ? "" : all.front().message;
}

}  // namespace

TEST_CASE("scenes are evaluated, include files are parsed") {
    Edited edited("camera { location -5*z look_at 0 } sphere { 0, Size }");
    CHECK(first_message(edited) == "nothing is declared as `Size`");
    edited.path = edited.folder / "b.inc";
    edited.open("sphere { 0, Size }");
    CHECK(first_message(edited).empty());
    edited.open("sphere { 0, ");
    CHECK_FALSE(first_message(edited).empty());
}

TEST_CASE("what a scene writes does not touch its folder, and can be read again") {
    Edited edited(
        "camera { location -5*z look_at 0 } light_source { -9*z, 1 }\n"
        "#fopen F \"w.inc\" write #write (F, \"sphere { 0, 1 pigment { rgb 1 } }\") #fclose F\n"
        "#include \"w.inc\"");
    edited.folder.put("scratch/keep", "");
    CHECK(first_message(edited).empty());
    CHECK_FALSE(std::filesystem::exists(edited.folder / "w.inc"));
    CHECK(std::filesystem::exists(edited.folder / "scratch/w.inc"));
}

TEST_CASE("a loop without end ends with a message") {
    Edited edited("#while (true) #end");
    CHECK(first_message(edited).find("passes of loops") != std::string::npos);
}

}  // namespace candelabra
