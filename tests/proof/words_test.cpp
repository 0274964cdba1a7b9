// SPDX-License-Identifier: GPL-3.0-or-later
// The generator reaches the words of the language, and its scenes are legal.
#include "base/deep_stack.h"
#include "proof/runner.h"
#include "scene/catalogue.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace candelabra::proof {

namespace {

/// Words that need a file, a home that scenes of laws do not have, or a newer version of the
/// language.
const std::set<std::string, std::less<>> not_reached = {"density_file", "material_map", "caustics",
                                                        "polarity"};

std::set<std::string, std::less<>> words_in(const std::string& text) {
    std::set<std::string, std::less<>> result;
    std::string word;
    for (const char c : text + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
            word += c;
        } else if (!word.empty()) {
            result.insert(word);
            word.clear();
        }
    }
    return result;
}

const Law& law_of(std::string_view name) { return *std::ranges::find(laws(), name, &Law::name); }

}  // namespace

TEST_CASE("scenes of the generator reach the words of the vocabulary", "[proof]") {
    const Law& law = law_of("strategies");
    Covering covering(levels_without(law.without));
    std::set<std::string, std::less<>> reached;
    for (int number = 0; number < 1500; ++number) {
        const Trial made = trial(law, covering, 1, number);
        covering.cover(made.row);
        reached.merge(words_in(written(made.script)));
    }
    std::string missing;
    const auto want = [&](std::string_view word) {
        if (!reached.contains(word) && !not_reached.contains(word))
            missing += " " + std::string(word);
    };
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items) {
            if (group.name == "Parts of cameras") continue;
            want(item->name);
            for (const FieldInfo& field : item->fields)
                if (field.is_word() && field.type != FieldType::text) want(field.name);
        }
    INFO("words that no scene reaches:" << missing);
    CHECK(missing.empty());
}

TEST_CASE("scenes of the generator are legal", "[proof]") {
    const Law& law = law_of("strategies");
    Covering covering(levels_without(law.without));
    on_deep_stack(std::size_t{64} << 20, [&](std::size_t) {
        int illegal = 0;
        std::string complaints;
        for (int number = 0; number < 60; ++number) {
            const Trial made = trial(law, covering, 2, number);
            covering.cover(made.row);
            const Prepared scene({}, written(made.script), made.script.options);
            illegal += scene.trouble() == Trouble::illegal;
            complaints += scene.complaint();
        }
        INFO(complaints);
        CHECK(illegal <= 1);
    });
}

}  // namespace candelabra::proof
