// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/written_name.h"

#include "support/folder.h"

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("names that programs believe are not written", "[file_access]") {
    for (const char* name : {"candelabra.ini",
                             "a.INI",
                             "a.iNi",
                             ".ini",
                             "a.ini.",
                             "a.ini ",
                             "a.ini. .",
                             "a.txt.",
                             "a.ini::$DATA",
                             "a.txt:x",
                             "sub\\a.txt",
                             "a.i\xE2\x80\x8Cni",
                             "a.ini\xE2\x80\x8C",
                             "a\x01.txt",
                             "a.tx\x7F",
                             "out.png.state.exr",
                             "out.State.EXR",
                             ".bashrc",
                             "sub/.x/a.txt",
                             ".git/config"}) {
        INFO(name);
        CHECK_FALSE(forbidden_name(name).empty());
    }
    for (const char* name : {"a.txt", "ini", "a.inix", "aini", "a.ini.txt", "a b.c-d.txt", "a.exr",
                             "gr\xC3\xB6\xC3\x9F"
                             "e.txt",
                             "sub.ini/a.txt", "a.inc", "a.pov"}) {
        INFO(name);
        CHECK(forbidden_name(name).empty());
    }
    CHECK(names_source("A.Pov"));
    CHECK(names_source("b.INC"));
    CHECK_FALSE(names_source("a.pov.txt"));
    CHECK(names_settings("a.InI"));
}

TEST_CASE("a path has no links, and none that leads to nothing", "[file_access]") {
    const Folder folder;
    const fs::path here = fs::canonical(folder.path());
    folder.put("a/b.txt", "");
    fs::create_symlink("a", folder / "link");
    fs::create_symlink("none", folder / "loose");
    CHECK(path_without_links(folder / "link/b.txt") == here / "a/b.txt");
    CHECK(path_without_links(folder / "a/../x/./y") == here / "x/y");
    CHECK(path_without_links(folder / "a/") == here / "a");
    CHECK_FALSE(path_without_links(folder / "loose"));
    CHECK_FALSE(path_without_links(folder / "loose/b.txt"));
    CHECK(part_below(here.string(), here / "x/y") == fs::path("x/y"));
    CHECK_FALSE(part_below((here / "a").string(), here / "ab"));
}

}  // namespace candelabra
