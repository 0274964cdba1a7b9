// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/texture.h"

#include "surface/texture_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Handle<Texture> coloured(const Colour& colour, Handle<Texture> below = nullptr) {
    Texture texture;
    texture.pigment.colour = colour;
    texture.finish.emission = Rgb(1);
    texture.below = std::move(below);
    return make_handle<Texture>(std::move(texture));
}

Texture halves(const Handle<Texture>& left, const Handle<Texture>& right) {
    PatternUse use;
    use.pattern = Gradient{Vec3(1, 0, 0)};
    Texture texture;
    texture.choice =
        make_handle<PatternedTexture>(use, Transform(), TextureMap{{0, left}, {1, right}});
    return texture;
}

}  // namespace

TEST_CASE("light passes through all layers", "[surface]") {
    const auto lower = coloured({Rgb(0.5, 1, 0), 0.5, 0});
    const auto both = coloured({Rgb(1), 0, 0.5}, lower);
    CHECK(passing(*both, Vec3(0), {}) == Rgb(0.125, 0.25, 0));
    CHECK(transparent(*both));
    CHECK_FALSE(transparent(*coloured({Rgb(1), 0, 0.5}, coloured({Rgb(1)}))));
    CHECK_FALSE(both->plain());
}

TEST_CASE("layers are given from the top, with their normals", "[surface]") {
    const auto both = coloured({Rgb(1), 0, 0.5}, coloured({Rgb(1, 0, 0)}));
    int calls = 0;
    for_layers(*both, Vec3(0), Vec3(0, 1, 0), {}, [&](double weight, std::span<const Layer> all) {
        ++calls;
        CHECK(weight == 1);
        REQUIRE(all.size() == 2);
        CHECK(all[0].colour.transmit == 0.5);
        CHECK(all[1].colour.rgb == Rgb(1, 0, 0));
        CHECK(all[1].normal == Vec3(0, 1, 0));
    });
    CHECK(calls == 1);
}

TEST_CASE("a pattern mixes two textures by their shares", "[surface]") {
    const Texture mixed = halves(coloured({Rgb(1)}), coloured({Rgb(0), 0, 1}));
    double sum = 0;
    for_layers(mixed, Vec3(0.25, 0, 0), Vec3(0, 1, 0), {},
               [&](double weight, std::span<const Layer> all) {
                   CHECK(weight == Approx(all[0].colour.transmit == 0 ? 0.75 : 0.25));
                   sum += weight;
               });
    CHECK(sum == Approx(1));
    CHECK(passing(mixed, Vec3(0.25, 0, 0), {}) == Rgb(0.25));
    CHECK(transparent(mixed));
    const auto opacity = [](const Colour& colour) { return colour.opacity(); };
    CHECK(emission(mixed, Vec3(0.25, 0, 0), {}, opacity) == Rgb(0.75));
    CHECK(greatest_emission(mixed) == Rgb(1));
    CHECK(nesting(mixed).depth == 1);
}

TEST_CASE("all layers and choices move with the texture", "[surface]") {
    const Transform twice = Transform::scaling(Vec3(2));
    const Texture moved = transformed(*coloured({Rgb(1), 0, 1}, coloured({Rgb(1)})), twice);
    CHECK(moved.below->pigment.transform == twice);
    CHECK(transformed(halves(coloured({Rgb(1)}), coloured({Rgb(0)})), twice).choice->transform ==
          twice);
}

}  // namespace candelabra
