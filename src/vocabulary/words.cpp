// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/words.h"

#include "vocabulary/reserved.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

constexpr std::uint32_t hash_of(std::string_view spelling) {
    std::uint32_t hash = 2166136261;  // FNV-1a: the spellings are short
    for (const char c : spelling) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619;
    return hash;
}

constexpr std::span<const Word> words = reserved_detail::words;

/// Words that are not reserved, before values that may begin with a sign, and their blocks. The
/// parser has to know them before any vocabulary is read (tests/scene/catalogue_test.cpp).
struct SignedWord {
    std::string_view block, word;
    friend bool operator==(const SignedWord&, const SignedWord&) = default;
};
constexpr auto signed_words = std::to_array<SignedWord>({
    {"film", "exposure"},
    {"isosurface", "polarity"},
    {"light_source", "aim"},
    {"light_source", "c0"},
    {"luminaire", "aim"},
    {"luminaire", "c0"},
    {"meter", "corner"},
    {"meter", "along"},
    {"meter", "across"},
    {"meter", "eye"},
    {"sky_luminance", "sun"},
    {"sky_luminance", "place"},
    {"sky_luminance", "date"},
    {"sky_luminance", "zone"},
    {"sky_luminance", "north"},
});

}  // namespace

std::span<const Word> reserved_words() { return words; }

std::span<const std::string_view> own_words() { return reserved_detail::own_words; }

bool takes_sign(std::string_view block, std::string_view word) {
    return std::ranges::find(signed_words, SignedWord{block, word}) != signed_words.end();
}

Names::Names() : slots_(4096) {
    for (const Word& word : words) intern(word.spelling);
    for (const std::string_view word : own_words()) intern(word);
}

std::size_t Names::slot(std::string_view spelling, std::uint32_t hash) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash & mask;
    while (slots_[i] != 0) {
        const Entry& entry = entries_[slots_[i] - 1];
        if (entry.hash == hash && entry.spelling == spelling) break;
        i = (i + 1) & mask;
    }
    return i;
}

void Names::grow() {
    slots_.assign(slots_.size() * 2, 0);
    for (std::size_t i = 0; i < entries_.size(); ++i)
        slots_[slot(entries_[i].spelling, entries_[i].hash)] = static_cast<std::uint32_t>(i + 1);
}

NameId Names::intern(std::string_view spelling) {
    const std::uint32_t hash = hash_of(spelling);
    std::size_t i = slot(spelling, hash);
    if (slots_[i] != 0) return NameId(slots_[i] - 1);
    if ((entries_.size() + 1) * 2 > slots_.size()) {
        grow();
        i = slot(spelling, hash);
    }
    if (entries_.size() >= words.size()) spelling = texts_.emplace_back(spelling);
    entries_.push_back({spelling, hash});
    slots_[i] = static_cast<std::uint32_t>(entries_.size());
    return NameId(entries_.size() - 1);
}

NameId Names::find(std::string_view spelling) const {
    const std::uint32_t found = slots_[slot(spelling, hash_of(spelling))];
    return found == 0 ? no_name : NameId(found - 1);
}

WordClass Names::word_class(NameId id) const {
    return reserved(id) ? words[static_cast<std::size_t>(id)].word_class : WordClass::name;
}

}  // namespace candelabra
