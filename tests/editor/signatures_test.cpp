// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/signatures.h"

#include "support/edited.h"

namespace candelabra {

namespace {

/// Returns "label: the active parameter", or "".
std::string shown(const std::string& text) {
    Edited edited(text);
    const auto found = signature_at(edited.workspace, edited.path, edited.offset);
    if (!found) return "";
    return found->label + ": " +
           (found->active < found->parameters.size() ? found->parameters[found->active] : "-");
}

}  // namespace

TEST_CASE("a call that is being typed shows its parameters and which one comes") {
    const std::string library = "#include \"light_arrays.inc\"\nobject { Light_Ring(";
    CHECK(shown(library + "|") ==
          "Light_Ring(Lamp object or array[], Count whole >= 1, Radius > 0): "
          "Lamp object or array[]");
    CHECK(shown(library + "Bulb, |) }") ==
          "Light_Ring(Lamp object or array[], Count whole >= 1, Radius > 0): "
          "Count whole >= 1");
    CHECK(shown(library + "sphere { 0, 1 }, 12, |) }") ==
          "Light_Ring(Lamp object or array[], Count whole >= 1, Radius > 0): "
          "Radius > 0");
    const std::string own = "#macro Post(Height, Colour) #end\nobject { Post(";
    CHECK(shown(own + "<1, 2, 3>, |) }") == "Post(Height, Colour): Colour");
    CHECK(shown(own + "<1, 2, |") == "Post(Height, Colour): Height");
    CHECK(shown(own + "1, 2, 3|") == "Post(Height, Colour): -");
    CHECK(shown(own + "min(1, |), 2) }").starts_with("min("));
    CHECK(shown(own + "A > B, |") == "Post(Height, Colour): Colour");
    CHECK(shown(own + "A < B, |") == "Post(Height, Colour): Colour");
    CHECK(shown(own + "(1 > 0), <1, 2> > 3 | (4 > 5), |") == "Post(Height, Colour): Colour");
    CHECK(shown(own + "array[3] { 1, 2, 3 }[|") == "Post(Height, Colour): Height");
    CHECK(shown("#declare V = vrotate(x, |").starts_with("vrotate("));
}

TEST_CASE("outside of calls there is no signature") {
    CHECK(shown("sphere { 0, | }").empty());
    CHECK(shown("|").empty());
    CHECK(shown("#declare A = (1 + |").empty());
    CHECK(shown("#macro M(A) #end M(1) |").empty());
    CHECK(shown("Nothing(1, |").empty());
}

TEST_CASE("the help of a library macro comes with its signature") {
    Edited edited("#include \"shapes.inc\"\nobject { Round_Box(|) }");
    const auto found = signature_at(edited.workspace, edited.path, edited.offset);
    REQUIRE(found);
    CHECK(found->help == "a box with round edges");
    CHECK(found->parameters.size() == 4);
}

}  // namespace candelabra
