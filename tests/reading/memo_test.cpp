// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/memo.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a memo makes a thing again only from another base", "[reading]") {
    Memo<int> memo;
    int calls = 0;
    const auto make = [&] { return make_handle<int>(++calls); };
    const Handle<int> one = make_handle<int>(1), other = make_handle<int>(1);
    const Handle<int> first = memo.made(7, one, make);
    CHECK(memo.made(7, one, make) == first);
    CHECK(memo.made(8, one, make) != first);
    const Handle<int> second = memo.made(7, other, make);
    CHECK(second != first);
    CHECK(memo.made(7, other, make) == second);
    CHECK(memo.made(std::nullopt, other, make) != memo.made(std::nullopt, other, make));
    CHECK(calls == 5);
}

TEST_CASE("a memo asks again for what was wrong", "[reading]") {
    Memo<int> memo;
    CHECK_FALSE(memo.made(1, nullptr, [] { return Handle<int>(); }));
    CHECK(memo.made(1, nullptr, [] { return make_handle<int>(1); }));
}

TEST_CASE("passes of a loop share what is the same each time", "[reading]") {
    const Script done = run(
        "#version 3.7; #for (I, 1, 4) union { box { 0, 1 } sphere { I*x, 1 } pigment { checker } "
        "interior { ior 1.5 } rotate 90*y translate x } #end");
    REQUIRE(done.text.empty());
    const auto parts = [&](std::size_t i) { return std::get<Union>(done.object(i).form).children; };
    CHECK(parts(2).at(0) == parts(3).at(0));
    CHECK(parts(2).at(1) != parts(3).at(1));
    CHECK(done.object(2).texture == done.object(3).texture);
    CHECK(done.object(2).interior == done.object(3).interior);
    CHECK(done.object(2).transform == done.object(3).transform);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(*done.object(i).transform == *done.object(0).transform);
        CHECK(done.texture(i).pigment.transform == done.texture(0).pigment.transform);
        CHECK(done.object(i).interior->ior == 1.5);
    }
}

TEST_CASE("what a pass changes is not taken from the pass before", "[reading]") {
    const Script done =
        run("#version 3.7; #for (I, 1, 6) #if (I > 4) #default { finish { phong 1 } } #end "
            "sphere { 0, 1 #if (mod(I, 2) = 1) pigment { rgb 1 } #end finish { ambient 0 } "
            "#if (I < 4) rotate #else translate #end 2*y } #end");
    REQUIRE(done.text.empty());
    for (std::size_t i = 0; i < 6; ++i) {
        INFO(i);
        const Texture& texture = done.texture(i);
        CHECK(texture.pigment.colour.rgb == Rgb(i % 2 == 0 ? 1 : 0));
        CHECK(texture.finish.phong == (i > 3 ? 1 : 0));
        CHECK(texture.finish.ambient == Rgb(0));
        CHECK((done.object(i).transform->point(Vec3(0)) == Vec3(0)) == (i < 3));
    }
}

TEST_CASE("a warning about an element that comes again is given once", "[reading]") {
    const Script done = run(
        "#version 3.7; #macro Flat() scale <0, 1, 1> #end #for (I, 1, 4) sphere { 0, 1 Flat() } "
        "box { 0, 1 Flat() } #end");
    CHECK(done.said.size() == 1);
}

}  // namespace candelabra
