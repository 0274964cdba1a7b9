// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/file_access.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <sys/stat.h>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("without folders everything may be read and nothing written", "[file_access]") {
    const FileAccess access;
    CHECK(access.may_read("/etc/passwd"));
    CHECK_FALSE(access.destination("a.txt"));
}

TEST_CASE("reading takes place below the folders", "[file_access]") {
    const Folder folder;
    folder.put("scene/a.inc", "");
    folder.put("other/b.inc", "");
    folder.put("scenery/c.inc", "");
    fs::create_symlink(folder / "other", folder / "scene/link");
    fs::create_symlink("a.inc", folder / "scene/inner");
    const FileAccess access({folder / "scene/"}, {});
    struct Case {
        const char* path;
        bool allowed;
    };
    const Case cases[] = {
        {"scene", true},
        {"scene/a.inc", true},
        {"scene/none/x.inc", true},
        {"scene/./sub/../a.inc", true},
        {"scene/inner", true},
        {"scene/../other/b.inc", false},
        {"other/b.inc", false},
        {"scenery/c.inc", false},
        {"scene/link/b.inc", false},
        {"scene/link/../other/b.inc", false},
    };
    for (const Case& c : cases) {
        INFO(c.path);
        CHECK(access.may_read(folder / c.path) == c.allowed);
    }
    CHECK_FALSE(access.may_read(folder / std::string("scene/a\0.inc", 12)));
}

TEST_CASE("writing takes place below the writable folders", "[file_access]") {
    const Folder folder;
    folder.put("out/sub/old.txt", "");
    folder.put("other/b.txt", "");
    fs::create_symlink(folder / "other", folder / "out/link");
    fs::create_symlink(folder / "other/b.txt", folder / "out/file");
    const FileAccess access({folder / "scene"}, {folder / "out", folder / "more"});
    const std::string out = fs::canonical(folder.path()).string() + "/out/";
    CHECK(access.destination("a.txt") == out + "a.txt");
    CHECK(access.destination("sub/a.txt") == out + "sub/a.txt");
    CHECK(access.destination("sub/../a.txt") == out + "a.txt");
    CHECK(access.destination(folder / "out/a.txt") == out + "a.txt");
    CHECK(access.destination(folder / "more/a.txt"));
    CHECK(access.may_read(folder / "out/a.txt"));
    for (const std::string& name :
         {std::string("../a.txt"), folder / "scene/a.txt", std::string("link/b.txt"),
          std::string("file"), std::string(), std::string("sub/"), std::string("."),
          std::string(".bashrc"), std::string(".git/config"), std::string("sub/.x"),
          std::string("a\0b", 3)}) {
        INFO(name);
        CHECK_FALSE(access.destination(name));
    }
}

TEST_CASE("a hidden folder of the run's own choice can be written", "[file_access]") {
    const Folder folder;
    fs::create_directory(folder / ".cache");
    CHECK(FileAccess({}, {folder / ".cache"}).destination("a.txt"));
}

TEST_CASE("the rules name the folder of the picture", "[file_access]") {
    const std::string out = FileAccess({}, {"out"}).writing_rule("../a.txt");
    CHECK(out.find("`out`") != std::string::npos);
    const FileAccess here({}, {""});
    CHECK(here.writing_rule("/a.txt").find("the current directory") != std::string::npos);
    CHECK(here.writing_rule("a.ini").starts_with("INI files are never written"));
    CHECK(FileAccess().writing_rule("a.txt") == "this run writes no files");
    CHECK(FileAccess::reading_help("/data/a.inc") == "`--allow-read /data` allows it");
    CHECK(here.writing_help("../a.txt") == "`--allow-write ..` allows it");
    CHECK(here.writing_help("a.ini").empty());
    CHECK(here.writing_rule("a.sh").starts_with("a scene writes files of data"));
    CHECK(here.writing_help("a.sh") == "`--allow-write .` allows it");
    CHECK(here.writing_help("a.txt") ==
          "`--allow-write .` allows it, and to overwrite what others have made");
    CHECK(here.writing_help("a.inc") == "remove that file before, or choose another name");
}

TEST_CASE("no name of a file that others believe is a destination, whatever it is written like",
          "[file_access]") {
    const Folder folder;
    folder.put("out/candelabra.ini", "");
    fs::create_symlink("candelabra.ini", folder / "out/notes.txt");
    fs::create_symlink("none.ini", folder / "out/loose.txt");
    const FileAccess access({}, {folder / "out", folder / "more"});
    for (const std::string& name :
         {std::string("candelabra.ini"), std::string("CANDELABRA.INI"), std::string("new.ini"),
          std::string("sub/../new.ini"), std::string("new.ini/."), std::string("new.ini."),
          std::string("new.ini "), std::string("notes.txt"), std::string("loose.txt"),
          std::string("a.png.state.exr"), folder / "more/new.ini",
          folder / "out/../out/./candelabra.ini"}) {
        INFO(name);
        CHECK_FALSE(access.destination(name));
        CHECK_FALSE(access.writing_rule(name).empty());
    }
}

TEST_CASE("files of others are overwritten only where the run permits it", "[file_access]") {
    const Folder folder;
    folder.put("out/old.txt", "");
    folder.put("more/old.txt", "");
    folder.put("more/old.inc", "");
    const FileAccess access({}, {folder / "out", folder / "more"});
    const auto opens = [&](const std::string& name) {
        const auto place = access.destination(name);
        REQUIRE(place);
        CHECK(access.rule_of_file(*place).empty() == bool(access.open(*place, true)));
        return bool(access.open(*place, false));
    };
    CHECK(opens("new.txt"));
    CHECK(opens("new.txt"));
    CHECK_FALSE(opens("old.txt"));
    CHECK(opens(folder / "more/old.txt"));
    CHECK_FALSE(opens(folder / "more/old.inc"));
    CHECK(opens(folder / "more/new.inc"));
    CHECK(opens(folder / "more/new.inc"));
}

TEST_CASE("where the user permits it a scene writes as from the current folder, under freer names",
          "[file_access]") {
    const Folder folder;
    folder.put("out/a.txt", "");
    folder.put("more/a.txt", "");
    const FileAccess access({}, {folder / "out", folder / "more"});
    CHECK_FALSE(access.destination("run.sh"));
    CHECK(access.destination(folder / "more/run.sh"));
    CHECK_FALSE(access.destination(folder / "more/.bashrc"));
    const fs::path before = fs::current_path();
    fs::current_path(folder / "more");
    CHECK(access.destination("b.txt") == fs::canonical(folder / "more").string() + "/b.txt");
    fs::current_path(before);
}

TEST_CASE("the scene's own folder is made when it is needed, and is no link", "[file_access]") {
    const Folder folder;
    folder.put("other/a.txt", "mine");
    const FileAccess access({}, {folder / "scene.files"});
    CHECK(access.own_folder().empty());
    const auto place = access.destination("a.txt");
    REQUIRE(place);
    CHECK_FALSE(fs::exists(folder / "scene.files"));
    CHECK(access.open(*place, false));
    CHECK(fs::exists(folder / "scene.files/a.txt"));
    CHECK(access.own_folder() == folder / "scene.files");
    for (const char* target : {"other", "none"}) {
        const std::string link = folder / (std::string(target) + ".files");
        fs::create_symlink(target, link);
        const FileAccess linked({}, {link});
        CHECK_FALSE(linked.destination("a.txt"));
        CHECK(linked.writing_rule("a.txt").ends_with("is a link"));
    }
    CHECK(folder.get("other/a.txt") == "mine");
}

TEST_CASE("hidden files are not read, and of some folders only what lies directly in them",
          "[file_access]") {
    const Folder folder;
    FileAccess access({folder / "scene"}, {});
    access.reads({{folder / "more"}, {{folder / "home"}, {folder / "out", "pic"}}, "/"});
    // As scene_folders() does, the folders above have no links.
    const std::string here = fs::canonical(folder.path()).string() + "/";
    access.reads({{here + "more"}, {{here + "home"}, {here + "out", "pic"}}, "/"});
    for (const char* name : {"scene/a.inc", "more/sub/a.inc", "home/a.inc", "out/pic.png",
                             "out/pic07.png", "out/pic-1.layers.exr"}) {
        INFO(name);
        CHECK(access.may_read(folder / name));
    }
    for (const char* name :
         {"scene/.a.inc", "scene/.git/a.inc", "home/.netrc", "home/sub/a.inc", "home",
          "out/other.png", "out/picture.png", "out/pic/a.png", "scene/a\nb.inc"}) {
        INFO(name);
        CHECK_FALSE(access.may_read(folder / name));
    }
    CHECK(access.left_out_note().find("`/`") != std::string::npos);
    CHECK(FileAccess({"/"}, {}).left_out_note().empty());
}

TEST_CASE("pipes and devices are odd", "[file_access]") {
    const Folder folder;
    folder.put("a.txt", "");
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    const FileAccess access({folder / "."}, {});
    CHECK(access.is_special(folder / "pipe"));
    CHECK_FALSE(access.is_special(folder / "a.txt"));
    CHECK_FALSE(access.is_special(folder / "."));
    CHECK_FALSE(access.is_special(folder / "none"));
    CHECK_FALSE(access.is_special("/dev/zero"));  // may not be read
}

}  // namespace candelabra
