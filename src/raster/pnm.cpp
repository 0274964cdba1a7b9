// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/pnm.h"

#include "raster/bytes.h"

#include <algorithm>

namespace candelabra {

namespace {

constexpr std::int64_t pnm_most = 255;

/// Parses numbers separated by blanks and comments.
class PnmText {
public:
    explicit PnmText(std::string_view rest) : rest_(rest) {}

    /// Returns nothing if there is no number, or one of more than seven digits.
    std::optional<std::int64_t> number() {
        skip_blanks();
        const std::size_t digits = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
        constexpr std::size_t most = 7;
        if (digits == 0 || digits > most) return std::nullopt;
        std::int64_t result = 0;
        for (const char digit : rest_.substr(0, digits)) result = 10 * result + (digit - '0');
        rest_.remove_prefix(digits);
        return result;
    }
    std::string_view rest() const { return rest_; }

private:
    void skip_blanks() {
        for (;;) {
            rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n\v\f"), rest_.size()));
            if (!rest_.starts_with('#')) return;
            rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
        }
    }

    std::string_view rest_;
};

bool take_pnm_text(PnmText text, std::size_t count, StoredPicture& picture) {
    constexpr std::size_t digit_and_blank = 2;
    if (count > (text.rest().size() + 1) / digit_and_blank) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = text.number();
        if (!value || *value > pnm_most) return false;
        picture.values.push_back(unit_value(static_cast<std::uint8_t>(*value)));
    }
    return true;
}

bool take_pnm_bytes(std::string_view bytes, std::size_t count, StoredPicture& picture) {
    if (count > bytes.size()) return false;
    picture.values.reserve(count);
    for (const char byte : bytes.substr(0, count))
        picture.values.push_back(unit_value(static_cast<std::uint8_t>(byte)));
    return true;
}

}  // namespace

std::optional<StoredPicture> read_pnm(std::string_view bytes, std::int64_t max_pixels) {
    const char kind = static_cast<char>(byte_in(bytes, 1));
    PnmText text(bytes.substr(2));
    const auto width = text.number(), height = text.number(), most = text.number();
    if (!width || !height || !most || !has_size(*width, *height, max_pixels)) return std::nullopt;
    if (*most != pnm_most) return std::nullopt;
    StoredPicture picture;
    picture.width = static_cast<int>(*width);
    picture.height = static_cast<int>(*height);
    picture.channels = kind == '2' || kind == '5' ? 1 : 3;
    picture.format = "pnm";
    const auto count = static_cast<std::size_t>(*width * *height * picture.channels);
    const bool in_text = kind == '2' || kind == '3';
    // A single blank precedes the bytes.
    const bool whole =
        in_text ? take_pnm_text(text, count, picture)
                : !text.rest().empty() && take_pnm_bytes(text.rest().substr(1), count, picture);
    return whole ? std::optional(std::move(picture)) : std::nullopt;
}

}  // namespace candelabra
