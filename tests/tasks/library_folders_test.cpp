// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/library_folders.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the library comes first, and what is no folder is told of") {
    Diagnostics diagnostics;
    CHECK(library_folders({}, "/lib", {"/tmp//", "/no/such"}, diagnostics) ==
          std::vector<std::string>{"/lib", "/tmp", "/no/such", "/lib/pictures", "/lib/models"});
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].message == "there is no folder `/no/such` to look for files in");
    CHECK(library_folders({}, "", {}, diagnostics).empty());
    CHECK(library_folders({"/tmp/"}, "/lib", {"/"}, diagnostics) ==
          std::vector<std::string>{"/tmp", "/lib", "/", "/lib/pictures", "/lib/models"});
}

}  // namespace candelabra
