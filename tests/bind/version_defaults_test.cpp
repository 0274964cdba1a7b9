// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/version_defaults.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const Texture& look(const Script& done, std::size_t i = 0) {
    return *done.scene.objects.at(i)->texture;
}

double aspect(const Script& done) {
    return std::visit([](const View& view) { return view.aspect; }, done.scene.camera);
}

}  // namespace

TEST_CASE("version 3.8 has white pigments, no ambient light and square pixels", "[bind]") {
    const Script modern = run("#version 3.8; sphere { 0, 1 }");
    CHECK(look(modern).pigment.colour.rgb == Rgb(1));
    CHECK(look(modern).finish.ambient == Rgb(0));
    CHECK(aspect(modern) == 320.0 / 240);
    const Script old = run("#version 3.7; sphere { 0, 1 }");
    CHECK(look(old).pigment.colour.rgb == Rgb(0));
    CHECK(look(old).finish.ambient == Rgb(0.1));
    CHECK(aspect(old) == 1.33);
    // Parts of a texture, and a camera of any type, begin with the defaults, too.
    const Script parts =
        run("#version 3.8; sphere { 0, 1 finish { diffuse 1 } } sphere { 0, 1 "
            "texture { pigment { rgb x } } } camera { fisheye location y }");
    CHECK(look(parts).pigment.colour.rgb == Rgb(1));
    CHECK(look(parts, 1).finish.ambient == Rgb(0));
    CHECK(aspect(parts) == 320.0 / 240);
    CHECK(run("#version 3.8; camera { right 2*x }").text.empty());
}

TEST_CASE("versions switch the defaults to and fro until a #default", "[bind]") {
    const Script switched =
        run("#version 3.8; sphere { 0, 1 } #version 3.7; sphere { 0, 1 } "
            "#version 3.8; sphere { 0, 1 }");
    CHECK(look(switched, 0).finish.ambient == Rgb(0));
    CHECK(look(switched, 1).finish.ambient == Rgb(0.1));
    CHECK(look(switched, 2).finish.ambient == Rgb(0));
    CHECK(switched.text.empty());
    const Script kept =
        run("#version 3.8; #default { finish { diffuse 0.5 } } #version 3.7; "
            "sphere { 0, 1 } #version 3.8; sphere { 0, 1 }");
    CHECK(look(kept, 0).finish.ambient == Rgb(0));
    CHECK(look(kept, 0).finish.diffuse == 0.5);
    CHECK(kept.text.find("does not change the default texture") != std::string::npos);
    CHECK(kept.text.find("does not change", kept.text.find("does not change") + 1) ==
          std::string::npos);
    const Script old =
        run("#version 3.7; #default { finish { diffuse 0.5 } } #version 3.8; "
            "sphere { 0, 1 }");
    CHECK(look(old).finish.ambient == Rgb(0.1));
}

TEST_CASE("textures keep the defaults of the version in which they were written", "[bind]") {
    const Script done =
        run("#version 3.8; #declare T = texture { pigment { rgb x } } #version 3.7; "
            "sphere { 0, 1 texture { T } }");
    CHECK(look(done).finish.ambient == Rgb(0));
}

}  // namespace candelabra
