// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_address.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a preview is on this machine unless an address is given", "[app]") {
    Options options;
    CHECK(host_of(options) == "127.0.0.1");
    CHECK(words_on_address(host_of(options), 8000, "abc") == "preview: http://localhost:8000/\n");
    options.preview_host = "127.0.0.2";
    const std::string words = words_on_address(host_of(options), 8000, "abc");
    CHECK(has(words, "is not encrypted"));
    CHECK(has(words, "preview: http://127.0.0.2:8000/?token=abc\n"));
}

TEST_CASE("an address that cannot be had is named with the way out", "[app]") {
    const Diagnostic port = problem_with_address("127.0.0.1", 80);
    CHECK(port.message == "port 80 cannot be had");
    CHECK(has(port.help, "--preview 0"));
    CHECK(has(problem_with_address("10.0.0.1", 80).message, "`10.0.0.1`"));
}

}  // namespace candelabra
