// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/opened_file.h"

#include "support/folder.h"
#include "text/loader.h"

#include <atomic>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

/// Returns the content of a path without links; "-" if it cannot be opened.
std::string opened_text(const std::string& path, std::size_t most = 1000) {
    return content_of(open_without_links(path, O_RDONLY), most).value_or("-");
}

}  // namespace

TEST_CASE("no part of the path of an opened file is a link", "[file_access]") {
    const Folder folder;
    const std::string here = fs::canonical(folder.path()).string();
    folder.put("a/b.txt", "text");
    fs::create_symlink("a", folder / "link");
    fs::create_symlink("b.txt", folder / "a/other.txt");
    CHECK(opened_text(here + "/a/b.txt") == "text");
    CHECK(opened_text(here + "//a///b.txt") == "text");
    CHECK(opened_text(here + "/link/b.txt") == "-");
    CHECK(opened_text(here + "/a/other.txt") == "-");
    CHECK(opened_text(here + "/a") == "-");
    CHECK(opened_text(here + "/none") == "-");
    CHECK_FALSE(open_without_links("a/b.txt", O_RDONLY));
    CHECK_FALSE(open_without_links("", O_RDONLY));
    CHECK_FALSE(open_without_links("/", O_WRONLY));
}

TEST_CASE("only regular files have a content, which is bounded", "[file_access]") {
    const Folder folder;
    const std::string here = fs::canonical(folder.path()).string();
    folder.put("a.txt", std::string(9000, 'x'));
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    CHECK(opened_text(here + "/a.txt", 9000).size() == 9000);
    CHECK(opened_text(here + "/a.txt", 8999) == "-");
    CHECK(opened_text(here + "/pipe") == "-");
    CHECK(opened_text("/dev/zero") == "-");
    CHECK(opened_text("/proc/version").starts_with("Linux"));  // reports a size of 0
    CHECK(is_regular_file(here + "/a.txt"));
    CHECK_FALSE(is_regular_file(here + "/pipe"));
    CHECK_FALSE(is_regular_file(here));
    CHECK_FALSE(is_regular_file(open_without_links(here + "/pipe", O_RDONLY)));
    CHECK_FALSE(is_regular_file(OpenedFile()));
}

TEST_CASE("the user names regular files and pipes, and they are what is read", "[file_access]") {
    const Folder folder;
    folder.put("a.txt", "text");
    fs::create_symlink("a.txt", folder / "link");
    CHECK(content_of_file(folder / "a.txt") == "text");
    CHECK(content_of_file(folder / "link") == "text");
    CHECK_FALSE(content_of_file(folder / "a.txt", 3));
    for (const std::string& none :
         {folder / "none", folder.path().string(), std::string("/dev/zero"), std::string(),
          std::string("a\0b", 3)})
        CHECK_FALSE(content_of_file(none));
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    std::thread writer([&] { std::ofstream(folder / "pipe") << "through a pipe"; });
    CHECK(content_of_file(folder / "pipe") == "through a pipe");
    writer.join();
}

TEST_CASE("what comes into the place of a file is not waited for", "[file_access]") {
    const Folder folder;
    folder.put("file", "text");
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    std::atomic<bool> ends = false;
    // Two names that are exchanged again and again, one of them a pipe without a writer.
    std::thread swapper([&] {
        while (!ends)
            ::renameat2(AT_FDCWD, (folder / "file").c_str(), AT_FDCWD, (folder / "pipe").c_str(),
                        RENAME_EXCHANGE);
    });
    int read = 0;
    for (int i = 0; i < 3000; ++i)
        if (const auto text = scene_reader(FileAccess())(folder / "file")) read += *text == "text";
    ends = true;
    swapper.join();
    CHECK(read > 0);
}

}  // namespace candelabra
