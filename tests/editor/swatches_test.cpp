// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/swatches.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("colours in numbers have a swatch, and can be replaced") {
    struct Case {
        std::string_view text, written;
        Vec3 srgb;
        std::string_view green;  ///< recoloured with a full green, encoded <0, 1, 0>
    };
    const Case cases[] = {
        {"rgb <1, 0, 0>", "rgb <1, 0, 0>", {1, 0, 0}, "rgb <0, 1, 0>"},
        {"color srgb 0.5", "srgb 0.5", {0.5, 0.5, 0.5}, "srgb <0, 1, 0>"},
        {"rgbf <1,1,1,.5>", "rgbf <1,1,1,.5>", {1, 1, 1}, "rgbf <0, 1, 0, 0.5>"},
        {"rgb 9", "rgb 9", {1, 1, 1}, "rgb <0, 1, 0>"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        Names names;
        const EditedFile file = read_tokens(std::string(each.text), names);
        const auto found = swatches(file, names);
        REQUIRE(found.size() == 1);
        CHECK(file.part(found[0].place) == each.written);
        for (int k = 0; k < 3; ++k) CHECK(found[0].srgb[k] == Approx(each.srgb[k]));
        CHECK(recoloured(file, names, found[0].place, Vec3(0, 1, 0)) == std::string(each.green));
    }
    Names names;
    const EditedFile none = read_tokens("rgb A rgb <1, A, 0> rgb <1, 2>", names);
    CHECK(swatches(none, names).empty());
    CHECK_FALSE(recoloured(none, names, {0, 3}, Vec3(0)));
}

}  // namespace candelabra
