// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/glossary.h"

#include "vocabulary/words.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>

namespace candelabra {

TEST_CASE("the glossary explains words of the language, each once") {
    std::set<std::string> seen;
    for (const GlossaryEntry& entry : glossary()) {
        CAPTURE(entry.words);
        CHECK_FALSE(entry.form.empty());
        CHECK_FALSE(entry.help.empty());
        std::string words(entry.words);
        for (std::size_t end = 0; !words.empty(); words.erase(0, end + 1)) {
            end = std::min(words.find(' '), words.size() - 1);
            const std::string word = words.substr(0, words[end] == ' ' ? end : end + 1);
            CAPTURE(word);
            CHECK(seen.insert(word).second);
            CHECK(glossary_entry(word) == &entry);
        }
    }
    CHECK(glossary_entry("#while") == glossary_entry("while"));
    CHECK(glossary_entry("whale") == nullptr);
    CHECK(glossary_entry("") == nullptr);
}

TEST_CASE("every directive is in the glossary") {
    for (const Word& word : reserved_words()) {
        if (word.word_class != WordClass::directive) continue;
        CAPTURE(word.spelling);
        CHECK(glossary_entry(word.spelling) != nullptr);
    }
}

}  // namespace candelabra
