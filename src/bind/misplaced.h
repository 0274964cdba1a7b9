// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of an element that no reader of a block takes: where it belongs, which word was
// meant, which braces are missing. Keeps what has been said, so that nothing is said of what
// follows from it. Asked by OpenBlock.
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
    /// The block outlives it.
    explicit Misplaced(OpenBlock& block) : block_(block) {}

    /// Whether the element belongs to something that has been reported.
    bool passes_over(const Element&);
    /// What has been passed over has ended: an element came that belongs here.
    void resume() { passing_over_ = false; }
    /// Says why the element has no place here. `words`: those that the block takes; `wanted`: a
    /// value is missing, which the element may be meant as. True: it may have been meant as a
    /// value, so its place is a hole.
    bool reject(const Element&, const WordList& words, bool wanted);

private:
    bool reject_word(const Element&, const WordList& words, bool wanted);
    bool in_comment(const Element&);
    std::string_view in_other_case(std::string_view word) const;
    void reject_reserved(const Element&, std::string_view word);
    void reject_value(const Element&);
    void reject_form(const Element&, std::string_view what, bool wanted = false);

    OpenBlock& block_;
    bool passing_over_ = false;  ///< values until the next word
    bool reported_unavailable_ = false;
    Body comment_ = {};               ///< from its next word on
    std::string_view unbraced_ = {};  ///< whose braces are missing: what follows belongs to it
    std::string_view rejected_ = {};  ///< the word before, if nobody knows it
};

/// Whether the language here knows the word at all: other reserved words are POV-Ray's, and not
/// available.
bool known_in_blocks(std::string_view word);

}  // namespace candelabra
