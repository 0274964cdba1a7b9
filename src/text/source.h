// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Keeps every text that was read, with its name and the place that included it, for as long as
// spans may refer to it. The lexer reads the texts; excerpts are printed from them. References and
// views stay valid during the lifetime of the store. For an unknown id, or a line or offset that
// does not exist, functions return the nearest existing value or an empty one.

#include "text/span.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Line and column, both from 1; the column counts UTF-8 characters, not bytes.
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

    /// LF, CRLF and a lone CR end a line. A byte order mark at the start of the text is not
    /// counted.
    Place place(SourceId id, std::uint32_t offset) const;

    /// Returns the text of a line (from 1) without its line end.
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
