// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/file.h"

#include <catch2/catch.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fcntl.h>
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

TEST_CASE("a link that leads out of its folder is not followed, whatever is written") {
    const FileFolder folder;
    fs::create_directories(folder.path / "out");
    std::ofstream(folder.file("precious")) << "mine";
    fs::create_symlink("../precious", folder.path / "out/a.png");
    fs::create_symlink(folder.file("precious"), folder.path / "out/b.png");
    fs::create_symlink("a.png", folder.path / "out/chain.png");
    fs::create_symlink("../none", folder.path / "out/loose.png");
    fs::create_symlink("/dev/null", folder.path / "out/device");
    fs::create_symlink("out", folder.path / "way");
    for (const char* name :
         {"out/a.png", "out/b.png", "out/chain.png", "out/device", "way/a.png"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        CHECK_FALSE(write_file(folder.file(name), "x", diagnostics));
        REQUIRE(diagnostics.error_count() == 1);
        CHECK(diagnostics.all()[0].message.find("leads out of its folder") != std::string::npos);
        CHECK(problem_with_destination(folder.file(name)).find("leads out") != std::string::npos);
        CHECK_FALSE(open_growing_file(folder.file(name)));
    }
    CHECK(content(folder.file("precious")) == "mine");
    Diagnostics diagnostics;
    CHECK(write_file(folder.file("out/loose.png"), "x", diagnostics));
    CHECK_FALSE(fs::exists(folder.file("none")));
    fs::create_symlink("../none", folder.path / "out/log");
    CHECK(open_growing_file(folder.file("out/log")));
    CHECK_FALSE(fs::exists(folder.file("none")));
    CHECK(write_file(folder.file("way/new.png"), "x", diagnostics));
    CHECK(diagnostics.all().empty());
}

TEST_CASE("the system's own links lead where they lead") {
    Diagnostics diagnostics;
    CHECK(problem_with_destination("/dev/stdout").empty());
    const FileFolder folder;
    const OpenedFile file = open_growing_file(folder.file("log"));
    REQUIRE(file);
    CHECK(write_file("/proc/self/fd/" + std::to_string(file.descriptor()), "x", diagnostics));
    CHECK(content(folder.file("log")) == "x");
}

TEST_CASE("a file that grows has all that was written") {
    const FileFolder folder;
    std::ofstream(folder.file("log")) << "an older and longer text";
    const OpenedFile file = open_growing_file(folder.file("log"));
    CHECK(write_all(file.descriptor(), "one ") == 0);
    CHECK(write_all(file.descriptor(), "two") == 0);
    CHECK(content(folder.file("log")) == "one two");
    CHECK(write_all(OpenedFile(::open("/dev/full", O_WRONLY)).descriptor(), "x") == ENOSPC);
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
