// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/misindented.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("an end that stands further left than its beginning is found", "[syntax]") {
    const std::string braces = "union {\n    merge {\n        a\n}\n";
    const auto found = misindented(braces, false);
    REQUIRE(found);
    CHECK(found->opener.first == braces.find("{\n        a"));
    CHECK(found->closer.first == braces.find('}'));

    const std::string directives = "#if (a)\n  #for (i, 1, 2)\n    b\n#end\n";
    CHECK_FALSE(misindented(directives, false));
    const auto end = misindented(directives, true);
    REQUIRE(end);
    CHECK(end->opener.first == directives.find("#for"));
    CHECK(end->closer.first == directives.find("#end"));

    CHECK_FALSE(misindented("union {\n    a\n}\n}", false));
    CHECK_FALSE(misindented("union { a\n  }\n", false));
    CHECK_FALSE(misindented("", true));
}

}  // namespace candelabra
