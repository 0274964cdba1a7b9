// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/legacy_layers.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("filter of layers is transmit up to version 3.1", "[surface]") {
    const std::string layers =
        "; sphere { 0, 1 pigment { rgb 1 } texture { pigment { rgb x } } texture { pigment { "
        "checker rgbt <0, 0, 0, 1> rgbf <0, 0, 1, 0.7> } } }";
    const auto through = [&](const std::string& version) {
        const Scene scene = scene_of("#version " + version + layers);
        return evaluate(scene.objects.front()->texture->pigment, Vec3(1.5, 0.5, 0.5));
    };
    CHECK(through("3.1").filter == 0);
    CHECK(through("3.1").transmit == Approx(0.7));
    CHECK(through("3.5").filter == Approx(0.7));
    CHECK(through("3.5").transmit == 0);
}

TEST_CASE("filter becomes transmit in all that a pigment chooses from", "[surface]") {
    const Scene scene = scene_of(
        "#version 3.7; sphere { 0, 1 texture { pigment { gradient x pigment_map { [0 rgbf 0.5] [1 "
        "gradient y color_map { [0 rgbf 0.25] [1 rgbft 0.125] }] } } } }");
    const Texture made = with_filter_as_transmit(*scene.objects.front()->texture);
    const Colour first = evaluate(made.pigment, Vec3(0)),
                 last = evaluate(made.pigment, Vec3(1 - 1e-12, 1 - 1e-12, 0));
    CHECK(first.filter == 0);
    CHECK(first.transmit == Approx(0.5));
    CHECK(last.filter == 0);
    CHECK(last.transmit == Approx(0.25));
}

}  // namespace candelabra
