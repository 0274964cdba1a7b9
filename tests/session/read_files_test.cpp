// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/read_files.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a noting reader notes each content once", "[session]") {
    std::vector<ReadFile> files;
    std::string content = "x";
    const Reader read = noting(
        [&](const std::string& path) {
            return path == "none" ? std::nullopt : std::optional(content);
        },
        files);
    read("a"), read("a"), read("none");
    CHECK(files.size() == 1);
    content = "y";
    CHECK(read("a") == "y");
    CHECK(files.size() == 2);
}

}  // namespace candelabra
