// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the bytes of a file, the lowest byte first. Reading checks that the bytes are there.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace candelabra {

template <class Number>
void append_number(std::string& bytes, Number number) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
        bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xFFU);
}

inline void append_float(std::string& bytes, float number) {
    append_number(bytes, std::bit_cast<std::uint32_t>(number));
}

/// Appends 7 bits in a byte: small numbers are short.
inline void append_short(std::string& bytes, std::uint64_t number) {
    for (; number > 0x7F; number >>= 7) bytes += static_cast<char>((number & 0x7FU) | 0x80U);
    bytes += static_cast<char>(number);
}

/// Takes numbers from the front of bytes. If one is missing, it is 0, and so are all later ones.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    bool good() const { return good_; }
    std::string_view left() const { return bytes_; }
    /// Whether so many things of that many bytes may follow.
    bool has(std::uint64_t count, std::size_t size) const {
        return good_ && count <= bytes_.size() / size;
    }

    template <class Number>
    Number number() {
        std::uint64_t value = 0;
        const std::string_view own = take(sizeof(Number));
        for (std::size_t i = 0; i < own.size(); ++i)
            value |= std::uint64_t{static_cast<unsigned char>(own[i])} << (8 * i);
        return static_cast<Number>(value);
    }

    float real() { return std::bit_cast<float>(number<std::uint32_t>()); }

    /// A number of append_short(), up to 2^63.
    std::uint64_t short_number() {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 63; shift += 7) {
            const auto byte = number<std::uint8_t>();
            value |= std::uint64_t{byte & 0x7FU} << shift;
            if (byte < 0x80U) return value;
        }
        good_ = false;
        return 0;
    }

    std::string_view take(std::uint64_t count) {
        good_ = good_ && count <= bytes_.size();
        if (!good_) return {};
        const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
        bytes_.remove_prefix(taken.size());
        return taken;
    }

private:
    std::string_view bytes_;
    bool good_ = true;
};

}  // namespace candelabra
