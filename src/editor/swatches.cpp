// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/swatches.h"

#include "base/colour.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// A prefix and the numbers after it.
struct Written {
    Part place;
    std::string_view prefix;
    std::vector<double> numbers;

    bool encoded() const { return prefix.starts_with("srgb"); }
};

std::vector<double> numbers_of(const EditedFile& file, const Token& token) {
    const std::vector<double>& all = file.values.numbers;
    if (token.kind == TokenKind::number) return std::vector<double>(3, all[token.value]);
    if (token.kind != TokenKind::literal || token.count < 3) return {};
    const auto first = all.begin() + token.value;
    return {first, first + token.count};
}

std::vector<Written> written_colours(const EditedFile& file, const Names& names) {
    std::vector<Written> found;
    for (std::size_t i = 0; i + 1 < file.tokens.size(); ++i) {
        const Token &word = file.tokens[i], &value = file.tokens[i + 1];
        if (word.kind != TokenKind::colour_prefix) continue;
        std::vector<double> numbers = numbers_of(file, value);
        if (numbers.empty()) continue;
        found.push_back({{word.first, value.last}, names.spelling(NameId(word.value)), numbers});
    }
    return found;
}

double rounded(double x) { return std::round(x * 1000) / 1000; }

}  // namespace

std::vector<Swatch> swatches(const EditedFile& file, const Names& names) {
    std::vector<Swatch> result;
    for (const Written& each : written_colours(file, names)) {
        Vec3 srgb;
        for (int k = 0; k < 3; ++k) {
            const double x = std::clamp(each.numbers[static_cast<std::size_t>(k)], 0., 1.);
            srgb[k] = each.encoded() ? x : srgb_encode(x);
        }
        result.push_back({each.place, srgb});
    }
    return result;
}

std::optional<std::string> recoloured(const EditedFile& file, const Names& names, Part place,
                                      const Vec3& srgb) {
    for (const Written& each : written_colours(file, names)) {
        if (each.place.first != place.first) continue;
        std::string text = message(each.prefix, " <");
        for (std::size_t k = 0; k < each.numbers.size(); ++k) {
            double x = each.numbers[k];
            if (k < 3) {
                const double chosen = srgb[static_cast<int>(k)];
                x = rounded(each.encoded() ? chosen : srgb_decode(chosen));
            }
            text += message(k > 0 ? ", " : "", x);
        }
        return text + ">";
    }
    return std::nullopt;
}

}  // namespace candelabra
