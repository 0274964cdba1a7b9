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

TEST_CASE("a scene writes files of data, under names that nobody obeys", "[file_access]") {
    for (const char* name : {"a.txt", "a.CSV", "lamps_2.json", "a.b-c.df3", "sub/a.inc",
                             "gr\xC3\xB6\xC3\x9F"
                             "e.obj",
                             "7.dat", "CMakeLists.txt"}) {
        INFO(name);
        CHECK(forbidden_data_name(name).empty());
    }
    for (const char* name : {"GNUmakefile",
                             "Makefile",
                             "json.py",
                             "x.sh",
                             "x.so",
                             "x.exe",
                             "x.desktop",
                             "x.html",
                             "x.lnk",
                             "autorun.inf",
                             "-rf",
                             "-rf.txt",
                             "sub/-a/b.txt",
                             "$(id).txt",
                             "`id`.txt",
                             "a;b.txt",
                             "a|b.txt",
                             "a b.txt",
                             "a'b.txt",
                             "a\nb.txt",
                             "a&b.txt",
                             "a=b.txt",
                             "*.txt",
                             "a.txt/b",
                             "a",
                             "txt",
                             ".txt",
                             "a.txt~",
                             "a.ini",
                             "a.state.exr",
                             "a\xE2\x80\xAEtxt.txt",
                             "a\xFF.txt",
                             "x.yml",
                             "x.toml",
                             "x.cfg",
                             "x.js",
                             "x.mk",
                             "x.d"}) {
        INFO(name);
        CHECK_FALSE(forbidden_data_name(name).empty());
    }
}

TEST_CASE("hidden names and names with control characters are not read", "[file_access]") {
    for (const char* name : {".netrc", ".ssh/id_rsa", "a/.git/config", "a\nb", "a\tb.inc", "a\x7F"})
        CHECK_FALSE(unread_name(name).empty());
    for (const char* name : {"", "a.inc", "a b.inc", "a/b.c",
                             "gr\xC3\xB6\xC3\x9F"
                             "e"})
        CHECK(unread_name(name).empty());
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
