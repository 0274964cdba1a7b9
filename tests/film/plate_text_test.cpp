// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/plate_text.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace candelabra {

TEST_CASE("letters of numbers and units differ, and stay inside of the picture", "[film]") {
    const auto drawn = [](std::string_view text, int size, PixelPlace at) {
        Image picture(20, 20);
        write_text(picture, at, text, size, Rgb(1));
        std::string bits;
        for (const Rgb& pixel : picture.pixels) bits += pixel == Rgb(1) ? '#' : '.';
        return bits;
    };
    const std::string letters = "0123456789.-+/%elxcdm";
    for (const char a : letters)
        for (const char b : letters)
            CHECK((drawn({&a, 1}, 1, {2, 2}) == drawn({&b, 1}, 1, {2, 2})) == (a == b));
    CHECK(drawn("?", 1, {2, 2}) == drawn("", 1, {2, 2}));
    CHECK(std::ranges::count(drawn("1", 2, {0, 0}), '#') ==
          4 * std::ranges::count(drawn("1", 1, {0, 0}), '#'));
    CHECK(std::ranges::count(drawn("888", 3, {-9, 15}), '#') > 0);
    CHECK(std::ranges::count(drawn("8", 1, {40, 40}), '#') == 0);
    CHECK(text_width("100 lx", 2) == 72);
}

}  // namespace candelabra
