// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A place in the input: a half-open range of bytes in one source text. Every value that a
// diagnostic may refer to carries one; lines and columns are computed when a message is printed. A
// default-constructed span is nowhere.

#include <algorithm>
#include <cstdint>

namespace candelabra {

using SourceId = std::uint32_t;

inline constexpr SourceId no_source = ~SourceId{0};

struct Span {
    SourceId source = no_source;
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    constexpr bool known() const { return source != no_source; }

    friend constexpr bool operator==(const Span&, const Span&) = default;
};

static_assert(sizeof(Span) == 12);

/// Returns the smallest span that covers both. Of spans in two different sources, returns the
/// first; if one span is nowhere, returns the other.
constexpr Span join(Span a, Span b) {
    if (!a.known()) return b;
    if (a.source != b.source) return a;
    return {a.source, std::min(a.first, b.first), std::max(a.last, b.last)};
}

}  // namespace candelabra
