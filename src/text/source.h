// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps every text that was read, with its name and where it was included, for as long as anything
// may point into it. The lexer reads from it; excerpts are printed from it. References and views
// that it hands out stay valid while it lives. An id that it did not give out, or a line or an
// offset that does not exist, is answered with the nearest thing that does, or with nothing.

#include "text/span.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Line and column, both from 1; the column counts characters of UTF-8, not bytes.
struct Place {
    int line = 1;
    int column = 1;

    friend constexpr bool operator==(const Place&, const Place&) = default;
};

class SourceStore {
public:
    SourceId add(std::string name, std::string text, Span included_at = {});

    std::string_view text(SourceId id) const;
    const std::string& name(SourceId id) const;
    Span included_at(SourceId id) const;

    /// LF, CRLF and a lone CR end a line; a byte order mark at the very start is not counted.
    Place place(SourceId id, std::uint32_t offset) const;

    /// The text of a line (from 1), without its end.
    std::string_view line(SourceId id, int line) const;

    int line_count(SourceId id) const;
    std::size_t count() const { return sources_.size(); }

private:
    struct Source {
        std::string name;
        std::string text;
        Span included_at;
        std::vector<std::uint32_t> line_starts;
    };

    const Source& source(SourceId id) const;

    std::deque<Source> sources_;
};

}  // namespace candelabra
