// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/edited_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string declared(const std::string& text) {
    Names names;
    const EditedFile file = read_tokens(text, names);
    std::string all;
    for (const DeclaredName& each : file.declarations) {
        const char* const kinds[] = {"", "()", "?", "|"};
        all += std::string(names.spelling(each.name)) + kinds[each.kind];
        all += each.local ? "- " : " ";
    }
    return all;
}

}  // namespace

TEST_CASE("directives declare names") {
    struct Case {
        std::string_view text, names;
    };
    const Case cases[] = {
        {"#declare A = 1; #local B = A;", "A B- "},
        {"#declare deprecated once \"no\" A = 1;", "A "},
        {"#declare (A, B) = (1, 2);", "A B "},
        {"#macro M(A, optional B) A #end", "M() A?- B?- "},
        {"#macro M(A object or array[], B whole >= C, optional D vector < pi) A #end",
         "M() A?- B?- D?- "},
        {"#for (I, 1, 10) I #end", "I "},
        {"#fopen F \"x\" read #read (F, A, B) #fclose F", "F| A B "},
        {"#declare A[1] = 2; // #declare B", "A "},
        {"#declare sphere = 1; #declare", ""},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        CHECK(declared(std::string(each.text)) == each.names);
    }
}

TEST_CASE("a file knows its comments, its includes and the token at a place") {
    Names names;
    const EditedFile file =
        read_tokens("// a\n#include \"b.inc\" /* c /* d */ e */ sphere { \"//\" }", names);
    REQUIRE(file.comments.size() == 2);
    CHECK(file.part(file.comments[0]) == "// a");
    CHECK(file.part(file.comments[1]) == "/* c /* d */ e */");
    CHECK(file.includes == std::vector<std::string>{"b.inc"});
    const auto sphere = static_cast<std::uint32_t>(file.text.find("sphere"));
    REQUIRE(file.token_at(sphere + 6));
    CHECK(file.token_at(sphere + 6)->first == sphere);
    CHECK(file.token_at(2) == nullptr);
}

}  // namespace candelabra
