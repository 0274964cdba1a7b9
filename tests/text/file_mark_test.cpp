// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/file_mark.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

#include <fcntl.h>

namespace candelabra {

TEST_CASE("a file keeps its mark beside its content", "[file_access]") {
    const Folder folder;
    const std::string path = std::filesystem::canonical(folder.path()).string() + "/file";
    const OpenedFile file = open_without_links(path, O_WRONLY | O_CREAT);
    REQUIRE(file);
    CHECK(mark_of(file).empty());
    if (!set_mark(file, "a mark")) {
        WARN("this file system keeps no attributes");
        return;
    }
    CHECK(mark_of(file) == "a mark");
    const OpenedFile place = open_without_links(path, O_PATH);
    CHECK(mark_of(place) == "a mark");
    REQUIRE(set_mark(file, std::string(200, 'x')));
    CHECK(mark_of(file) == "?");
    CHECK(folder.get("file").empty());
}

}  // namespace candelabra
