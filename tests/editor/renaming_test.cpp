// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/renaming.h"

#include "support/edited.h"

namespace candelabra {

namespace {

/// Returns the number of places that change, or the reason why none does.
std::string renamed(const std::string& text, const std::string& name) {
    Edited edited(text);
    edited.folder.put("b.inc", "#declare Shared = 1; Shared");
    const auto result = renaming(edited.workspace, edited.path, edited.offset, name);
    if (const auto* reason = std::get_if<std::string>(&result)) return *reason;
    return std::to_string(std::get_if<std::vector<Mention>>(&result)->size());
}

}  // namespace

TEST_CASE("a name is renamed wherever it is mentioned, or not at all") {
    CHECK(renamed("#declare A| = 1; sphere { 0, A } // A", "B") == "2");
    CHECK(renamed("#include \"b.inc\" Sha|red", "Other") == "3");
    CHECK(renamed("#declare A| = 1;", "sphere") == "`sphere` is a word of the language");
    CHECK(renamed("#declare A| = 1;", "2b") == "`2b` is no name");
    CHECK(renamed("#declare A| = 1; B", "B").starts_with("`B` is used in"));
    CHECK(renamed("sph|ere { 0, 1 }", "B") == "only names that a scene declares can be renamed");
    CHECK(renamed("#include \"colors.inc\" Re|d", "B") == "`Red` belongs to the standard library");
}

TEST_CASE("mentions are places in files") {
    Edited edited("#declare A = 1;\nA|");
    const auto found = mentions(edited.workspace, edited.path, edited.offset);
    REQUIRE(found.size() == 2);
    CHECK(found[1].place.first == 16);
    CHECK(found[1].path == edited.path);
    CHECK(mentions(edited.workspace, edited.path, 0).empty());
}

}  // namespace candelabra
