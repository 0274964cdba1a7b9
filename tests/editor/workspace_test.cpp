// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/workspace.h"

#include "support/edited.h"

#include <algorithm>

namespace candelabra {

namespace {

std::string names_of(const std::vector<FileHandle>& files) {
    std::string all;
    for (const FileHandle& file : files) all += file->path.substr(file->path.rfind('/') + 1) + " ";
    return all;
}

}  // namespace

TEST_CASE("documents come before the disk, and the disk again when they are closed") {
    Edited edited;
    edited.folder.put("a.pov", "A");
    CHECK(edited.workspace.file(edited.path)->text == "A");
    edited.open("B");
    CHECK(edited.workspace.file(edited.path)->text == "B");
    CHECK(edited.workspace.is_open(edited.path));
    edited.workspace.close(edited.path);
    CHECK(edited.workspace.file(edited.path)->text == "A");
    CHECK(edited.workspace.file(edited.folder / "none.pov") == nullptr);
}

TEST_CASE("files that include each other belong together") {
    Edited edited("#include \"b.inc\" #include \"missing.inc\" #include \"colors.inc\"");
    edited.folder.put("b.inc", "#include \"c.inc\"");
    edited.folder.put("c.inc", "#include \"b.inc\" #include \"a.pov\"");
    CHECK(names_of(edited.workspace.around(edited.path)) == "a.pov b.inc c.inc colors.inc ");
    // While editing an include file, users have the scene's names if the scene is open.
    CHECK(names_of(edited.workspace.around(edited.folder / "c.inc")) ==
          "c.inc b.inc a.pov colors.inc ");
    CHECK(edited.workspace.in_library(CANDELABRA_SOURCE_DIR "/stdlib/colors.inc"));
    CHECK_FALSE(edited.workspace.in_library(edited.path));
}

TEST_CASE("only what belongs to open scenes is read for them") {
    const Folder elsewhere;
    elsewhere.put("far.inc", "");
    Edited edited("#include \"" + (elsewhere / "far.inc") + "\"");
    CHECK(names_of(edited.workspace.around(edited.path)) == "a.pov ");
    edited.workspace.open(elsewhere / "b.pov", "");
    CHECK(names_of(edited.workspace.around(edited.path)) == "a.pov far.inc b.pov ");
}

TEST_CASE("a chain of files that has no end is cut") {
    Edited edited("#include \"0.inc\"");
    for (int i = 0; i < 1100; ++i)
        edited.folder.put(std::to_string(i) + ".inc",
                          "#include \"" + std::to_string(i + 1) + ".inc\"");
    CHECK(edited.workspace.around(edited.path).size() == 1000);
}

TEST_CASE("of several declarations the nearest above comes first") {
    Edited edited("#declare A = 1;\n#declare A = 2;\n|A\n#declare A = 3;");
    edited.workspace.open(edited.folder / "other.pov", "#declare A = 4;");
    const NameId a = edited.workspace.names().intern("A");
    std::vector<std::uint32_t> places;
    for (const auto& each : edited.workspace.declarations(a, edited.path, edited.offset))
        places.push_back(each.declaration->place.first);
    CHECK(places == std::vector<std::uint32_t>{25, 9, 43, 9});
}

}  // namespace candelabra
