// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/nearest.h"

#include "text/ascii.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

// Cost of a letter omitted, added, changed or swapped. All the case differences that a word can
// have together cost less than one slip.
constexpr int slip = 100;
constexpr int other_case = 1;

// Longer words are unlikely to be misspelt names, and comparing them would take too long.
constexpr std::size_t longest = 64;

int change(char a, char b) {
    if (a == b) return 0;
    return lower_case(a) == lower_case(b) ? other_case : slip;
}

bool swapped(std::string_view a, std::size_t i, std::string_view b, std::size_t j) {
    return i > 1 && j > 1 && lower_case(a[i - 1]) == lower_case(b[j - 2]) &&
           lower_case(a[i - 2]) == lower_case(b[j - 1]);
}

/// Damerau-Levenshtein distance, restricted to edits that do not overlap (optimal string
/// alignment).
int distance(std::string_view a, std::string_view b) {
    std::array<std::array<int, longest + 1>, 3> rows;
    auto *before = &rows[0], *above = &rows[1], *row = &rows[2];
    for (std::size_t j = 0; j <= b.size(); ++j) (*row)[j] = static_cast<int>(j) * slip;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before, above);
        std::swap(above, row);
        (*row)[0] = static_cast<int>(i) * slip;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            int least = std::min({(*above)[j] + slip, (*row)[j - 1] + slip,
                                  (*above)[j - 1] + change(a[i - 1], b[j - 1])});
            if (swapped(a, i, b, j)) least = std::min(least, (*before)[j - 2] + slip);
            (*row)[j] = least;
        }
    }
    return (*row)[b.size()];
}

/// Returns the distance if it is small enough for a misspelling.
std::optional<int> near(std::string_view word, std::string_view name) {
    const std::size_t length = std::max(word.size(), name.size());
    const std::size_t shorter = std::min(word.size(), name.size());
    if (shorter == 0 || length > longest) return {};
    const std::size_t slips = std::min<std::size_t>(length / 3, 3);
    if (length - shorter > slips) return {};
    const int found = distance(word, name);
    if (found / slip > static_cast<int>(slips)) return {};
    return found;
}

/// Returns the only name that begins with the word, or "": a word that is not written to its end.
std::string only_longer(std::string_view word, const std::vector<std::string_view>& names) {
    constexpr std::size_t fewest_letters = 3;
    if (word.size() < fewest_letters || word.size() > longest) return {};
    std::string_view found;
    for (const std::string_view name : names) {
        if (!same_letters(name.substr(0, word.size()), word)) continue;
        if (!found.empty() && found != name) return {};
        found = name;
    }
    return std::string(found);
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string_view>& names) {
    const auto found = nearest_few(word, names, 1);
    return found.empty() ? std::string() : found.front();
}

std::vector<std::string> nearest_few(std::string_view word,
                                     const std::vector<std::string_view>& names, std::size_t most) {
    struct Guess {
        int distance;
        std::string_view name;
    };
    std::vector<Guess> guesses;
    for (const std::string_view name : names) {
        if (const auto found = near(word, name)) guesses.push_back({*found, name});
    }
    std::stable_sort(guesses.begin(), guesses.end(),
                     [](const Guess& a, const Guess& b) { return a.distance < b.distance; });
    std::vector<std::string> few;
    for (const Guess& guess : guesses) {
        if (few.size() == most) break;
        if (std::find(few.begin(), few.end(), guess.name) == few.end()) {
            few.emplace_back(guess.name);
        }
    }
    if (few.empty() && most > 0)
        if (std::string longer = only_longer(word, names); !longer.empty()) few.push_back(longer);
    return few;
}

}  // namespace candelabra
