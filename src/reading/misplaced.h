// SPDX-License-Identifier: GPL-3.0-or-later
// Reports elements that no reader of a block takes: where they belong, which word was meant, which
// braces are missing. Remembers its reports, so that their consequences are not reported. Called by
// OpenBlock.
#pragma once

#include "interpret/evaluator.h"

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class OpenBlock;
using WordList = std::vector<std::string_view>;

class Misplaced {
public:
    /// The block outlives this object.
    explicit Misplaced(OpenBlock& block) : block_(block) {}

    /// Whether the element is a consequence of an earlier report and is skipped.
    bool passes_over(const Element&);
    /// Stops skipping elements: one came that belongs here.
    void resume() { passing_over_ = false; }
    /// Reports why the element is misplaced. `words` are those that the block takes; `wanted` says
    /// that a value is missing, for which the element may stand. Returns true if it may have been
    /// meant as that value, which is then a hole.
    bool reject(const Element&, const WordList& words, bool wanted);

private:
    void ask_for_braces(const Element&);
    bool reject_word(const Element&, const WordList& words, bool wanted);
    bool in_comment(const Element&);
    std::string_view in_other_case(std::string_view word) const;
    void reject_reserved(const Element&, std::string_view word);
    void reject_value(const Element&);
    void reject_form(const Element&, std::string_view what, bool wanted = false);

    OpenBlock& block_;
    bool passing_over_ = false;  ///< skips values until the next word
    bool reported_unavailable_ = false;
    Body comment_ = {};               ///< rest of the comment, from its next word on
    std::string_view unbraced_ = {};  ///< word whose braces are missing; it owns the next elements
    std::string_view rejected_ = {};  ///< the preceding word, if it is unknown
};

}  // namespace candelabra
