// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and validates the parameters of a request: each is read as its expected type, and the first
// invalid one is recorded.
#pragma once

#include "editor/protocol.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace candelabra {

class Parameters {
public:
    /// Maximum size of a document after changes, in bytes.
    static constexpr std::size_t longest_document = std::size_t{1} << 26;

    /// `json` must outlive this object; null means no parameters.
    explicit Parameters(const Json& json) : json_(json) {}

    /// A path of member names from object to object: {"textDocument", "uri"}.
    using Way = std::initializer_list<const char*>;

    /// Returns a string; records a problem and returns an empty one if it is missing or of another
    /// type.
    std::string text(Way);
    /// Returns the path of the document that `textDocument` names.
    std::string document();
    /// Returns the offset of a position. A position beyond the end of a line is at the end.
    std::uint32_t place(std::string_view text, Way);
    /// Returns a range that does not end before it begins.
    Part range(std::string_view text, const char* name);
    /// Returns a channel of a colour, from 0 to 1.
    double channel(Way);
    /// Returns a list of objects; otherwise records a problem and returns an empty list.
    Json objects(Way);
    /// Applies `contentChanges` in order: each replaces the whole document or a range of it. If one
    /// of them is invalid, none is applied.
    std::string changed_text(std::string text);

    /// Refuses the request for another reason.
    void refuse(std::string why);

    /// Returns the first problem, or "".
    const std::string& problem() const { return problem_; }

private:
    const Json* find(Way) const;
    /// Applies one change to a document; returns whether it is valid.
    bool change(std::string& text, const Json& change);
    void wrong(Way, std::string_view kind);

    const Json& json_;
    std::string problem_;
};

}  // namespace candelabra
