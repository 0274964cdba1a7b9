// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a request, which an editor may have got wrong: each is read as what it must be,
// and the first that is not is named.
#pragma once

#include "editor/protocol.h"

#include <initializer_list>
#include <string>
#include <string_view>

namespace candelabra {

class Parameters {
public:
    /// Changes make no document longer, in bytes.
    static constexpr std::size_t longest_document = std::size_t{1} << 26;

    /// `json` must live as long; null stands for none.
    explicit Parameters(const Json& json) : json_(json) {}

    /// The names lead from object to object: {"textDocument", "uri"}.
    using Way = std::initializer_list<const char*>;

    /// Anything but such a parameter is a problem, and gives an empty one.
    std::string text(Way);
    /// The path of the document that `textDocument` names.
    std::string document();
    /// A place in the text; what lies behind the end of a line is there.
    std::uint32_t place(std::string_view text, Way);
    /// A range that does not end before it begins.
    Part range(std::string_view text, const char* name);
    /// A channel of a colour, from 0 to 1.
    double channel(Way);
    /// A list of objects; anything else is a problem, and gives an empty one.
    Json objects(Way);
    /// The text behind all of `contentChanges`, one after the other: each is the whole document, or
    /// what comes in place of a range of it. When one of them is no change none is made.
    std::string changed_text(std::string text);

    /// Refuses the request for another reason.
    void refuse(std::string why);

    /// The first problem, or empty.
    const std::string& problem() const { return problem_; }

private:
    const Json* find(Way) const;
    /// Makes one change of a document; whether it is one.
    bool change(std::string& text, const Json& change);
    void wrong(Way, std::string_view kind);

    const Json& json_;
    std::string problem_;
};

}  // namespace candelabra
