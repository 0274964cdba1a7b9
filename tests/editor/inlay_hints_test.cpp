// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/inlay_hints.h"

#include "support/edited.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// The text with its hints in brackets.
std::string hinted(const std::string& text, Part part = {0, ~0u}) {
    Edited edited(text);
    std::string result = text;
    const auto hints = inlay_hints(edited.workspace, edited.path, part);
    for (auto each = hints.rbegin(); each != hints.rend(); ++each)
        result.insert(each->offset, "[" + each->name + "]");
    return result;
}

}  // namespace

TEST_CASE("arguments of macros have the names of their parameters") {
    const std::string own = "#macro Post(Height, Colour) #end\n";
    CHECK(hinted(own + "Post(1, <1, 2, 3>)") == own + "Post([Height]1, [Colour]<1, 2, 3>)");
    CHECK(hinted(own + "Post(Post(1, 2), A[3, 4])") ==
          own + "Post([Height]Post([Height]1, [Colour]2), [Colour]A[3, 4])");
    CHECK(hinted(own + "object { Post(min(1, 2), rgb 1) }") ==
          own + "object { Post([Height]min(1, 2), [Colour]rgb 1) }");
    // What says it itself, what is left out, and what is one too many.
    CHECK(hinted(own + "Post(height, Colour)") == own + "Post(height, Colour)");
    CHECK(hinted(own + "Post(, 2, 3)") == own + "Post(, [Colour]2, 3)");
    CHECK(hinted(own + "Post(") == own + "Post(");
    CHECK(hinted(own + "Post(1") == own + "Post([Height]1");
    CHECK(hinted("Nothing(1, 2) sphere { (1), 2 }") == "Nothing(1, 2) sphere { (1), 2 }");
    CHECK(hinted("(1, 2)") == "(1, 2)");
    const auto first = static_cast<std::uint32_t>(own.size());
    CHECK(hinted(own + "Post(1, 2) Post(3, 4)", {first, first + 6}) ==
          own + "Post([Height]1, 2) Post(3, 4)");
}

TEST_CASE("arguments of library macros have the names of their parameters") {
    const std::string library = "#include \"light_arrays.inc\"\nobject { ";
    CHECK(hinted(library + "Light_Ring(Bulb, 12, 1) }") ==
          library + "Light_Ring([Lamp]Bulb, [Count]12, [Radius]1) }");
}

TEST_CASE("a file that is not there has no hints") {
    Edited edited("");
    CHECK(inlay_hints(edited.workspace, "/no/such/file.pov", {0, 9}).empty());
}

}  // namespace candelabra
