// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/texture_store.h"

#include "evaluate/script.h"

#include <catch2/catch.hpp>

TEST_CASE("equal plain textures are one", "[evaluate]") {
    TextureStore store;
    Texture red;
    red.pigment.colour.rgb = Vec3(1, 0, 0);
    Texture dull = red;
    dull.finish.phong = 0.1;
    const auto first = store.share(red);
    CHECK(store.share(red) == first);
    CHECK(store.share(dull) != first);
    CHECK(store.share(dull) == store.share(dull));
    CHECK(store.share(Texture{}) != first);
}

TEST_CASE("a loop that writes the same texture each time makes one", "[evaluate]") {
    const Script done =
        run("#version 3.7; #for (I, 1, 3) sphere { I*x, 1 pigment { rgb 1 } finish { emission 2 } "
            "translate I*y } #end");
    REQUIRE(done.scene.objects.size() == 3);
    CHECK(done.object(0).texture == done.object(2).texture);
}
