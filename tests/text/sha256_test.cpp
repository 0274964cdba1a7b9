// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/sha256.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("digests are those of sha256sum") {
    struct Case {
        std::string text;
        const char* digest;
    };
    const Case cases[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {std::string(55, 'x'), "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072"},
        {std::string(56, 'x'), "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e"},
        {std::string(64, 'x'), "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c"},
        {std::string(1000, '\xff'),
         "b4f73dff046400b76728ab32619e3d89e00132653725f660c62ab9fca975b372"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text.size());
        CHECK(sha256(each.text) == each.digest);
    }
}

}  // namespace candelabra
