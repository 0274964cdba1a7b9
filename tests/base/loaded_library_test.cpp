// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/loaded_library.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("functions are loaded from libraries, or it is said why not", "[base]") {
    const LoadedFunction cosine = load_function("libm.so.6", "cos");
    REQUIRE(cosine.address);
    CHECK(cosine.problem.empty());
    CHECK(reinterpret_cast<double (*)(double)>(cosine.address)(0) == 1);
    for (const auto& [library, function] :
         {std::pair("libm.so.6", "no_such_function"), std::pair("no_such_library.so", "cos")}) {
        const LoadedFunction none = load_function(library, function);
        CHECK_FALSE(none.address);
        CHECK_FALSE(none.problem.empty());
    }
}

}  // namespace candelabra
