// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/loader.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <sys/stat.h>

namespace candelabra {

namespace {

using Paths = std::vector<std::string>;

/// Returns a reader of files that contain their own path, so that the text identifies the file.
Reader files(const Paths& paths) {
    return [paths](const std::string& path) -> std::optional<std::string> {
        for (const std::string& each : paths) {
            if (each == path) return "text of " + path;
        }
        return {};
    };
}

std::string found(const Paths& paths, const std::string& name, const std::string& from = "parts",
                  FileKind kind = FileKind::include) {
    const Loader loader(files(paths), "scenes", {"lib", "more/"});
    const auto result = loader.load(name, from, kind);
    if (!result) CHECK_FALSE(loader.located(name, from, kind));
    if (!result) return "";
    CHECK(result->text == "text of " + result->path);
    CHECK(loader.located(name, from, kind) == result->path);
    return result->path;
}

}  // namespace

TEST_CASE("places are searched in order") {
    Paths paths = {"parts/a.inc", "scenes/a.inc", "a.inc", "lib/a.inc", "more/a.inc"};
    while (!paths.empty()) {
        CHECK(found(paths, "a.inc") == paths.front());
        paths.erase(paths.begin());
    }
    CHECK(found(paths, "a.inc") == "");
}

TEST_CASE("the extension may be left out, and unknown ones are tried last") {
    CHECK(found({"lib/a.inc"}, "a") == "lib/a.inc");
    CHECK(found({"lib/a.INC"}, "a") == "lib/a.INC");
    CHECK(found({"lib/a.INC", "more/a.inc"}, "a") == "more/a.inc");
    CHECK(found({"parts/a", "lib/a.inc"}, "a") == "lib/a.inc");
    CHECK(found({"parts/a"}, "a") == "parts/a");
    CHECK(found({"a.txt", "a.txt.inc"}, "a.txt") == "a.txt.inc");
    CHECK(found({"a.inc", "a.inc.inc"}, "a.inc") == "a.inc");
    CHECK(found({"a.inc.inc"}, "a.inc") == "a.inc.inc");
    CHECK(found({"a.INC", "a.inc"}, "a.INC") == "a.INC");
    CHECK(found({"a.inc"}, "A.inc") == "");
    CHECK(found({"a.Inc", "a.Inc.inc"}, "a.Inc") == "a.Inc.inc");
    CHECK(found({"x/y.inc"}, "x/y") == "x/y.inc");
}

TEST_CASE("data files are found under their exact name only") {
    CHECK(found({"a.inc", "lib/a"}, "a", "parts", FileKind::data) == "lib/a");
    CHECK(found({"a.inc"}, "a", "parts", FileKind::data) == "");
}

TEST_CASE("absolute names are taken as they are") {
    CHECK(found({"/lib/a.inc"}, "/lib/a") == "/lib/a.inc");
    CHECK(found({"parts//a.inc", "a.inc"}, "/a.inc") == "");
}

TEST_CASE("a name of nothing or of a folder finds nothing") {
    CHECK(found({".inc", "parts/.inc", ""}, "") == "");
    CHECK(found({"x/", "x/.inc"}, "x/") == "");
}

TEST_CASE("searched paths are listed once each") {
    const Loader loader(files({}), "./scenes/", {"lib", "scenes", "."});
    CHECK(loader.searched("a.inc", "scenes") ==
          Paths{"scenes/a.inc", "a.inc", "lib/a.inc", "scenes/a.inc.inc", "a.inc.inc",
                "lib/a.inc.inc", "scenes/a.inc.INC", "a.inc.INC", "lib/a.inc.INC"});
    CHECK(loader.searched("b", "", FileKind::data) == Paths{"scenes/b", "b", "lib/b"});
    CHECK(loader.searched("b", ".", FileKind::data) == Paths{"b", "scenes/b", "lib/b"});
    CHECK(loader.searched("/b", "scenes", FileKind::data) == Paths{"/b"});
    CHECK(loader.searched("b", "/", FileKind::data).front() == "/b");
}

TEST_CASE("the message about a missing file names the places and what was perhaps meant") {
    const auto list = [](const std::string& folder) {
        return folder == "lib" ? Paths{"Aa.inc"} : Paths{};
    };
    const Loader loader(files({}), "scenes", {"lib"}, {}, list);
    const auto note = [&](const std::string& name, const std::string& from = {}) {
        const Diagnostic problem = loader.problem(name, {}, FileKind::include, from);
        CHECK(problem.fault == Fault::include_not_found);
        CHECK(problem.message == "there is no file `" + name + "`");
        return problem.notes.at(0);
    };
    CHECK(note("a") == "looked in `scenes`, the current directory, `lib`");
    CHECK(note("a", "parts") == "looked in `parts`, `scenes`, the current directory, `lib`");
    CHECK(note("/a") == "an absolute name is looked for in its own place only");
    CHECK(loader.problem("aa.inc", {}).help == "did you mean `Aa.inc`?");
    CHECK(loader.problem("zz.inc", {}).help.empty());
}

TEST_CASE("what may not be read is not read, and the message names the option") {
    const Folder folder;
    folder.put("scene/a.inc", "inside");
    folder.put("b.inc", "outside");
    const Loader loader(disk_reader(), folder / "scene", {}, FileAccess({folder / "scene"}, {}));
    CHECK(loader.load("a.inc")->text == "inside");
    CHECK_FALSE(loader.load("../b.inc"));
    CHECK(loader.refused("../b.inc"));
    CHECK_FALSE(loader.refused("c.inc"));
    // Do not reveal whether the file exists.
    CHECK(loader.refused("../c.inc"));
    const Diagnostic problem = loader.problem("../b.inc", {});
    CHECK(problem.fault == Fault::file_access);
    CHECK(problem.help == "`--allow-read " + folder / "scene/.." + "` allows it");
}

TEST_CASE("a file that the scene has written is found before others of its name") {
    const Folder folder;
    folder.put("scene/a.inc", "old");
    folder.put("out/a.inc", "new");
    Loader loader(disk_reader(), folder / "scene", {},
                  FileAccess({folder / "scene"}, {folder / "out"}));
    CHECK(loader.load("a.inc")->text == "old");
    loader.written(*loader.file_access().destination("a.inc"));
    CHECK(loader.load("a.inc")->text == "new");
    CHECK(loader.load("a")->text == "new");
}

TEST_CASE("the folder of a path") {
    const std::map<std::string, std::string> cases = {
        {"a.pov", "."}, {"x/a.pov", "x"}, {"/x/y/a", "/x/y"}, {"/a", "/"}, {"", "."}, {"x/", "x"},
    };
    for (const auto& [path, folder] : cases) CHECK(directory_of(path) == folder);
}

TEST_CASE("the disk reader reads files byte for byte and nothing else") {
    const auto folder = std::filesystem::temp_directory_path() / "candelabra_loader_test";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    const std::string path = folder / "a.inc";
    const std::string text = std::string("a\r\n\0b\xFF", 6) + std::string(200'000, 'x');
    std::ofstream(path, std::ios::binary) << text;
    std::ofstream(folder / "empty.inc");

    const Reader read = disk_reader();
    CHECK(read(path) == text);
    CHECK(read(folder / "empty.inc") == std::string());
    CHECK_FALSE(read(folder));
    CHECK_FALSE(read(folder / "none.inc"));
    CHECK_FALSE(read(path + '\0'));
    CHECK_FALSE(read(""));
    CHECK_FALSE(read("/dev/zero"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("files of a library include from the libraries in their order", "[text]") {
    const Reader reader = [](const std::string& path) -> std::optional<std::string> {
        if (path == "std/a.inc" || path == "old/a.inc" || path == "old/b.inc") return path;
        return {};
    };
    const Loader loader(reader, "scenes", {"std", "old"});
    CHECK(loader.load("a.inc", "old")->text == "std/a.inc");
    CHECK(loader.load("b.inc", "old")->text == "old/b.inc");
}

TEST_CASE("the library's file that declares a name is known", "[text]") {
    const Reader reader = [](const std::string& path) -> std::optional<std::string> {
        if (path == "lib/b.inc") return "#declare Redder = 1; #macro M(a) #end\n#declare  Red=2;";
        if (path == "lib/a.inc") return "// Red\n#declare X = Red; #ifndef (Red) #end";
        return {};
    };
    const Lister lister = [](const std::string&) {
        return std::vector<std::string>{"b.inc", "c.txt", "a.inc"};
    };
    const Loader loader(reader, "scenes", {"lib"}, {}, lister);
    CHECK(loader.library_file_declaring("Red") == "b.inc");
    CHECK(loader.library_file_declaring("M") == "b.inc");
    CHECK(loader.library_file_declaring("X") == "a.inc");
    CHECK(loader.library_file_declaring("Re").empty());
    CHECK(Loader(reader, "scenes", {"lib"}).library_file_declaring("Red").empty());
}

TEST_CASE("what a scene may not read is not opened, and existence is not asked by reading",
          "[text]") {
    const Folder folder;
    folder.put("scene/a.inc", "inside");
    folder.put("b.inc", "outside");
    std::vector<std::string> read, asked;
    const Reader disk = disk_reader();
    const Reader noting(
        [&](const std::string& path) {
            read.push_back(path);
            return disk(path);
        },
        [&](const std::string& path) {
            asked.push_back(path);
            return disk.holds(path);
        });
    const Loader loader(noting, folder / "scene", {}, FileAccess({folder / "scene"}, {}),
                        disk_lister());
    CHECK(loader.finds("a.inc"));
    CHECK_FALSE(loader.finds("../b.inc"));
    CHECK(loader.refused("../b.inc"));
    CHECK(loader.problem("../b.inc", {}).fault == Fault::file_access);
    CHECK(loader.problem("/dev/zero", {}).fault == Fault::file_access);
    CHECK(read.empty());
    for (const std::string& path : asked) CHECK(path.find("..") == std::string::npos);
}

TEST_CASE("a scene reads regular files only", "[text]") {
    const Folder folder;
    folder.put("scene/a.inc", "inside");
    folder.put("b.inc", "outside");
    REQUIRE(mkfifo((folder / "scene/pipe.inc").c_str(), 0600) == 0);
    std::filesystem::create_symlink("../b.inc", folder / "scene/link.inc");
    std::filesystem::create_symlink("a.inc", folder / "scene/inner.inc");
    const FileAccess access({folder / "scene"}, {});
    const Reader read = scene_reader(access);
    CHECK(read(folder / "scene/a.inc") == "inside");
    CHECK(read(folder / "scene/inner.inc") == "inside");
    for (const char* name : {"b.inc", "scene/link.inc", "scene/pipe.inc", "scene", "scene/none"}) {
        INFO(name);
        CHECK_FALSE(read(folder / name));
        CHECK_FALSE(read.holds(folder / name));
    }
    CHECK_FALSE(read(""));
    CHECK_FALSE(scene_reader(FileAccess())("/dev/zero"));
    const Loader loader(read, folder / "scene", {}, access);
    CHECK_FALSE(loader.load("pipe.inc"));
    const Diagnostic problem = loader.problem("pipe.inc", {});
    CHECK(problem.fault == Fault::file_access);
    CHECK(problem.notes.at(0) == "it is a pipe or a device, and a scene reads regular files only");
}

TEST_CASE("what was perhaps meant tells of no name outside of the folders", "[text]") {
    const Folder folder;
    folder.put("scene/wood.inc", "");
    folder.put("scene/sub/x.inc", "");
    folder.put("secret.inc", "");
    folder.put("vault/gold.inc", "");
    std::filesystem::create_symlink("../vault", folder / "scene/way");
    const Loader loader(scene_reader(FileAccess({folder / "scene"}, {})), folder / "scene", {},
                        FileAccess({folder / "scene"}, {}), disk_lister());
    const auto help = [&](const std::string& name) {
        return loader.problem(name, {}, FileKind::data).help;
    };
    CHECK(help("Wood.inc") == "did you mean `wood.inc`?");
    CHECK(help("Sub/x.inc") == "did you mean `sub/x.inc`?");
    CHECK(help(folder / "scene/Wood.inc") == "did you mean `" + folder / "scene/wood.inc" + "`?");
    for (const std::string& name :
         {std::string("../Secret.inc"), std::string("sub/../../secrets.inc"),
          std::string("way/Gold.inc"), folder / "Secret.inc", folder / "Vault/gold.inc",
          std::string("/etc/passwdd"), std::string("..\\Secret.inc")}) {
        INFO(name);
        const std::string said = help(name);
        CHECK(said.find("secret.inc") == std::string::npos);
        CHECK(said.find("gold.inc`") == std::string::npos);
        CHECK(said.find("did you mean") == std::string::npos);
    }
}

}  // namespace candelabra
