// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/file.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <unistd.h>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

struct FileFolder {
    fs::path path =
        fs::temp_directory_path() / ("candelabra_file_test_" + std::to_string(::getpid()));
    FileFolder() { fs::create_directories(path); }
    ~FileFolder() { fs::remove_all(path); }
    std::string file(const std::string& name) const { return (path / name).string(); }
    std::size_t count() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }
};

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a file is written whole, under any name, and leaves nothing beside it") {
    const FileFolder folder;
    for (const std::string name :
         {"plain", "with space=and sign", "-dash", "ümlaut.png", "percent%d%s"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        CHECK(write_file(folder.file(name), "first", diagnostics));
        CHECK(write_file(folder.file(name), std::string("se\0cond", 7), diagnostics));
        CHECK(content(folder.file(name)) == std::string("se\0cond", 7));
        CHECK(diagnostics.all().empty());
    }
    CHECK(folder.count() == 5);
}

TEST_CASE("a longest possible name is no obstacle") {
    const FileFolder folder;
    const std::string path = folder.file(std::string(255, 'n'));
    Diagnostics diagnostics;
    CHECK(write_file(path, "x", diagnostics));
    CHECK(content(path) == "x");
}

TEST_CASE("links stay links and permissions stay as they were") {
    const FileFolder folder;
    std::ofstream(folder.file("target")) << "old";
    fs::permissions(folder.file("target"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("target", folder.path / "link");
    Diagnostics diagnostics;
    CHECK(write_file(folder.file("link"), "new", diagnostics));
    CHECK(fs::is_symlink(folder.path / "link"));
    CHECK(content(folder.file("target")) == "new");
    CHECK(fs::status(folder.file("target")).permissions() ==
          (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("devices are written to, not replaced") {
    Diagnostics diagnostics;
    CHECK(write_file("/dev/null", "gone", diagnostics));
    CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("what cannot be written is an error that names the file, and known beforehand") {
    const FileFolder folder;
    std::ofstream(folder.file("file")) << "kept";
    struct Case {
        std::string path;
        std::string reason;
    };
    const Case cases[] = {
        {folder.path.string(), "it is a folder"},
        {folder.file("no/such/folder.png"), "there is no folder"},
        {folder.file("file/below.png"), "is not a folder"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.path);
        CHECK(problem_with_destination(each.path).find(each.reason) != std::string::npos);
        Diagnostics diagnostics;
        CHECK_FALSE(write_file(each.path, "x", diagnostics));
        REQUIRE(diagnostics.error_count() == 1);
        CHECK(diagnostics.all()[0].fault == Fault::io);
        CHECK(diagnostics.all()[0].message.find(each.path) != std::string::npos);
    }
    CHECK(content(folder.file("file")) == "kept");
    CHECK(folder.count() == 1);
    CHECK(problem_with_destination(folder.file("new.png")).empty());
    CHECK(problem_with_destination("-").empty());
}

TEST_CASE("a full device is an error") {
    if (!fs::exists("/dev/full")) return;
    Diagnostics diagnostics;
    CHECK_FALSE(write_file("/dev/full", "x", diagnostics));
    CHECK(diagnostics.error_count() == 1);
}

}  // namespace candelabra
