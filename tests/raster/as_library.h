// SPDX-License-Identifier: GPL-3.0-or-later
// What the library of all formats writes, for tests of the writers that do without it.
#pragma once

#include "picture/formats.h"
#include "text/diagnostic.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

inline std::string as_library(const RawPicture& picture) {
    Diagnostics diagnostics;
    const Formats* const formats = picture_formats(diagnostics);
    REQUIRE(formats != nullptr);
    std::string bytes;
    REQUIRE(formats->write(picture, bytes).empty());
    return bytes;
}

inline std::string as_library(const LayeredPicture& picture) {
    Diagnostics diagnostics;
    const Formats* const formats = picture_formats(diagnostics);
    REQUIRE(formats != nullptr);
    std::string bytes;
    REQUIRE(formats->write_layers(picture, bytes).empty());
    return bytes;
}

/// Numbers that look random, with runs of equal ones among them; floats of all magnitudes.
template <class Value>
std::vector<Value> some_values(std::size_t count, std::uint32_t seed = 1) {
    std::vector<Value> values;
    std::uint32_t state = seed * 2654435761U + 1;
    while (values.size() < count) {
        state = state * 1664525U + 1013904223U;
        const std::uint32_t bits = state >> 8;
        Value value = static_cast<Value>(bits);
        if constexpr (std::is_same_v<Value, float>) {
            value = static_cast<float>(bits) / 16777216.0F;
            for (std::uint32_t i = bits % 61; i > 0; --i) value *= i % 2 == 0 ? 0.5F : 1.75F;
        }
        const std::size_t times = bits % 5 == 0 ? 1 + bits % 150 : 1;
        for (std::size_t i = 0; i < times && values.size() < count; ++i) values.push_back(value);
    }
    return values;
}

}  // namespace candelabra
