// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/links.h"

#include "support/edited.h"

#include <filesystem>

namespace candelabra {

namespace {

/// Returns the strings that are links, each with the name of its file.
std::string linked(Edited& edited, const std::string& path) {
    std::string all;
    for (const Link& each : links(edited.workspace, path)) {
        const FileHandle file = edited.workspace.file(path);
        all += std::string(file->part(each.place)) + ">" +
               each.path.substr(each.path.rfind('/') + 1) + " ";
    }
    return all;
}

std::string linked(const std::string& text) {
    Edited edited(text);
    for (const char* name : {"b.inc", "c.png", "d.jpg", "e.df3", "f.ply", "g.csv", "h"})
        edited.folder.put(name, "");
    return linked(edited, edited.path);
}

}  // namespace

TEST_CASE("strings lead to the files that they name") {
    CHECK(linked("#include \"b.inc\" #include \"b\"") == "b.inc>b.inc b>b.inc ");
    CHECK(linked("#include \"colors.inc\"") == "colors.inc>colors.inc ");
    CHECK(linked("pigment { image_map { png \"c\" } } height_field { \"c.png\" }") ==
          "c>c.png c.png>c.png ");
    CHECK(linked("bump_map { jpeg \"d\" } density_file df3 \"e.df3\"") == "d>d.jpg e.df3>e.df3 ");
    CHECK(linked("mesh { file \"f.ply\" } read_csv(\"g.csv\") #fopen F \"h\" read") ==
          "f.ply>f.ply g.csv>g.csv h>h ");
}

TEST_CASE("other strings, and files that are not there, have no link") {
    CHECK(linked("#debug \"h\" text { ttf \"none.ttf\" \"h\" 1, 0 } concat(\"h\", \"\")").empty());
    CHECK(linked("#include \"\" #include \"none.inc\" #include concat(\"b\", \".inc\")").empty());
    CHECK(linked("\"h\"").empty());
}

TEST_CASE("what a scene may not open is not looked at") {
    const Folder elsewhere;
    elsewhere.put("far.inc", "");
    Edited edited("#include \"" + (elsewhere / "far.inc") + "\" #include \"link.inc\"");
    std::filesystem::create_symlink(elsewhere / "far.inc", edited.folder / "link.inc");
    CHECK(linked(edited, edited.path).empty());
    // Not even if another file of that folder is open.
    edited.workspace.open(elsewhere / "b.pov", "");
    CHECK(linked(edited, edited.path).empty());
}

TEST_CASE("an include file is looked at as its open scenes see it") {
    Edited edited;
    edited.folder.put("parts/b.inc", "#include \"c.inc\" #include \"d.inc\"");
    edited.folder.put("c.inc", "");
    edited.folder.put("parts/d.inc", "");
    const std::string part = edited.folder / "parts/b.inc";
    CHECK(linked(edited, part) == "d.inc>d.inc ");
    edited.open("#include \"parts/b.inc\"");
    CHECK(linked(edited, part) == "c.inc>c.inc d.inc>d.inc ");
    CHECK(links(edited.workspace, "/none/such.pov").empty());
}

}  // namespace candelabra
