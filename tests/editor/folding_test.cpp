// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/folding.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Formats folds as "0-2 4-5c": lines from 0, with c for comments and i for imports.
std::string folded(const std::string& text) {
    Names names;
    std::string all;
    for (const Fold& each : folds(read_tokens(text, names))) {
        all += (all.empty() ? "" : " ") + std::to_string(each.first_line) + "-" +
               std::to_string(each.last_line);
        if (each.kind == Fold::comment) all += "c";
        if (each.kind == Fold::imports) all += "i";
    }
    return all;
}

}  // namespace

TEST_CASE("what takes several lines can be folded, and what closes it is seen") {
    CHECK(folded("union {\nsphere {\n0, 1\n}\n}") == "0-3 1-2");
    CHECK(folded("union { sphere {\n0, 1\n} }").substr(0, 3) == "0-1");
    CHECK(folded("sphere { 0, 1 }\n").empty());
    CHECK(folded("sphere {\n}").empty());
    CHECK(folded("f(1,\n2,\n3)") == "0-1");
    CHECK(folded("#macro M()\nA\n#end") == "0-1");
    CHECK(folded("#if (A)\nB\nB\n#else\nC\nC\n#end") == "0-2 3-5");
    CHECK(folded("#switch (A)\n#case (1)\nB\n#break\n#end") == "1-3");
    CHECK(folded("#if (A) union {\n#else merge {\n#end\nB\n}") == "");
    CHECK(folded("#declare A = array {\r1,\r2\r}") == "0-2");
}

TEST_CASE("comments and includes below each other are folded together") {
    CHECK(folded("// a\n// b\n// c\nA") == "0-2c");
    CHECK(folded("/* a\nb */") == "0-1c");
    CHECK(folded("A // a\n// b\n// c") == "1-2c");
    CHECK(folded("// a\n\n// b").empty());
    CHECK(folded("#include \"a\"\n#include \"b\"\n\n#include \"c\"\nA\n#include \"d\"") == "0-3i");
}

TEST_CASE("brackets without a counterpart are passed over") {
    CHECK(folded("}\n)\n#end\nunion {\n(\nA\n}\n") == "3-5");
    CHECK(folded("{\n#if (A)\n}\n#end\nB\n}") == "0-4 1-2");
    std::string deep;
    for (int i = 0; i < 20000; ++i) deep += "(\n";
    for (int i = 0; i < 20000; ++i) deep += "}\n";
    CHECK(folded(deep).empty());
    CHECK(folded("").empty());
}

}  // namespace candelabra
