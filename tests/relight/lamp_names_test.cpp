// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_names.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("lamps are chosen by name, number and range", "[relight]") {
    const LampList lamps({{"Key", 1}, {"Row", 4}, {"Odd[1]", 1}}, {0, 3, 2, 1, 0, 0},
                         std::vector<float>(6, 1.0F));
    const LampNames names(lamps);
    using Places = std::vector<std::uint32_t>;
    const auto chosen = [&](const char* name) {
        Diagnostics diagnostics;
        const auto places = names.chosen(name, diagnostics);
        CHECK(places.has_value() != diagnostics.failed());
        return places.value_or(Places{99});
    };
    CHECK(chosen("Key") == Places{0});
    CHECK(chosen("Key[0]") == Places{0});
    CHECK(chosen("Row") == Places{4, 3, 2, 1});
    CHECK(chosen("Row[2]") == Places{2});
    CHECK(chosen("Row[1..3]") == Places{3, 2, 1});
    CHECK(chosen("Odd[1]") == Places{5});
    CHECK(chosen("*") == Places{0, 1, 2, 3, 4, 5});
    for (const char* wrong : {"", "Kay", "Row[4]", "Row[2..1]", "Row[x]", "Row[]", "Row[0..]",
                              "Row[-1]", "Row[0..4]", "[0]", "Row[99999999999]"}) {
        INFO(wrong);
        CHECK(chosen(wrong) == Places{99});
    }
    Diagnostics diagnostics;
    names.chosen("Kay", diagnostics);
    CHECK(diagnostics.all()[0].message == "there is no lamp `Kay`");
    names.chosen("Row[4]", diagnostics);
    CHECK(diagnostics.all()[1].message == "there is no lamp `Row[4]`");
}

}  // namespace candelabra
