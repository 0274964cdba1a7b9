// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/texture_store.h"

#include "support/script.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace candelabra {

TEST_CASE("equal plain textures are one", "[reading]") {
    TextureStore store;
    Texture red;
    red.pigment.colour.rgb = Rgb(1, 0, 0);
    Texture dull = red;
    dull.finish.phong = 0.1;
    const auto share = [&](const Texture& texture) {
        return store.share(make_handle<Texture>(texture));
    };
    const auto first = share(red);
    CHECK(share(red) == first);
    CHECK(share(dull) != first);
    CHECK(share(dull) == share(dull));
    CHECK(share(Texture{}) != first);
}

TEST_CASE("many textures keep apart", "[reading]") {
    TextureStore store;
    std::vector<Handle<Texture>> made;
    for (int i = 0; i < 1000; ++i) {
        Texture texture;
        texture.pigment.colour.rgb = Rgb(i % 10, i / 10 % 10, i / 100);
        made.push_back(store.share(make_handle<Texture>(texture)));
    }
    for (const Handle<Texture>& texture : made) {
        CHECK(store.share(make_handle<Texture>(*texture)) == texture);
        CHECK(std::ranges::count(made, texture) == 1);
    }
}

TEST_CASE("where hardly any are equal, no more are looked for", "[reading]") {
    TextureStore store;
    Pool<Texture> pool;
    const auto share = [&](double red) {
        Texture texture;
        texture.pigment.colour.rgb = Rgb(red, 0, 0);
        return store.share(std::move(texture), pool);
    };
    for (int i = 0; i < 20'000; ++i) share(i);
    const Handle<Texture> late = share(30'000);
    CHECK(late->pigment.colour.rgb == Rgb(30'000, 0, 0));
    CHECK(share(30'000) != late);

    TextureStore other;
    std::swap(store, other);
    for (int i = 0; i < 50'000; ++i) share(i % 1000);
    CHECK(share(999) == share(999));
}

TEST_CASE("a loop that writes the same texture each time makes one", "[reading]") {
    const Script done =
        run("#version 3.7; #for (I, 1, 3) sphere { I*x, 1 pigment { rgb 1 } finish { emission 2 } "
            "rotate I*y } #end");
    REQUIRE(done.scene.objects.size() == 3);
    CHECK(done.object(0).texture == done.object(2).texture);
}

}  // namespace candelabra
