// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/picture_layers.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("layers are read by name, each once, in their own order") {
    const auto read = [](std::string_view text) {
        const auto layers = read_layer_list(text);
        return layers ? layer_list(*layers) : "nothing";
    };
    CHECK(read("normal,albedo,normal") == "albedo,normal");
    CHECK(read("all") ==
          "albedo,normal,depth,object,lights,variance,samples,shadow_rays,luminance,illuminance");
    CHECK(read("colour") == "nothing");
    for (const LayerInfo& info : all_layers()) {
        CHECK(read(info.name) == info.name);
        CHECK_FALSE(info.help.empty());
    }
}

}  // namespace candelabra
