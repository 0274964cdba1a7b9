// SPDX-License-Identifier: GPL-3.0-or-later
// The dictionary of LZW (T. Welch, "A Technique for High-Performance Data Compression", 1984) for
// GIF and TIFF files, whose readers extract codes in their own bit order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace candelabra {

class LzwWords {
public:
    /// Codes below 2^bits stand for single bytes; they are followed by the clear code and the end
    /// code. Precondition: 2 <= bits <= 8.
    explicit LzwWords(unsigned bits) : clear_(1U << bits) { begin(); }

    std::uint32_t clear_code() const { return clear_; }
    std::uint32_t end_code() const { return clear_ + 1; }
    /// The code of the next word to be added.
    std::uint32_t next_code() const { return next_; }

    void begin() {
        next_ = clear_ + 2;
        last_ = none;
    }

    /// Appends the word of a code to the output. Returns false if there is no such word.
    bool add(std::uint32_t code, std::string& output) {
        const bool is_known = code < clear_ || (code >= clear_ + 2 && code < next_);
        const bool is_next = code == next_ && last_ != none;
        if (!is_known && !is_next) return false;
        const std::size_t begun = output.size();
        const std::size_t length = is_known ? length_of(code) : length_of(last_) + 1U;
        output.resize(begun + length);
        std::uint32_t at = code;
        std::size_t left = length;
        if (is_next) {
            --left;
            at = last_;
        }
        for (; left > 0; --left) {
            output[begun + left - 1] = at < clear_ ? static_cast<char>(at) : words_[at].end;
            if (at >= clear_) at = words_[at].before;
        }
        if (is_next) output[begun + length - 1] = output[begun];
        if (last_ != none && next_ < max_words) {
            words_[next_] = {last_, length_of(last_) + 1, output[begun]};
            ++next_;
        }
        last_ = code;
        return true;
    }

private:
    static constexpr std::uint32_t max_words = 4096, none = ~0U;
    /// A shorter word followed by one byte.
    struct Word {
        std::uint32_t before = 0, length = 0;
        char end = 0;
    };
    std::uint32_t length_of(std::uint32_t code) const {
        return code < clear_ ? 1 : words_[code].length;
    }

    std::uint32_t clear_, next_ = 0, last_ = none;
    std::array<Word, max_words> words_{};
};

}  // namespace candelabra
