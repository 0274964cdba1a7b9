// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises vectors that are written without their `< >`: `translate 1, 2, 3`, `rgb 1, 0, 0`,
// `sphere { 0, 0, 0, 1 }`, or without their `*`: `rotate y 45`. A single number stands for a
// vector, so only the elements after it show that a vector was meant. Called to report a number
// that is misplaced or out of range.
#pragma once

#include "interpret/evaluator.h"
#include "vocabulary/schema.h"

#include <optional>

namespace candelabra {

/// The diagnostic for a number that follows another one after a word that takes one vector or
/// colour; nothing if the element is something else.
std::optional<Diagnostic> unbracketed_vector(const Element&, const Names&);

/// The same for numbers at the head of a block of that item that are more than its values.
std::optional<Diagnostic> unbracketed_vectors(const Element&, const ItemInfo&);

/// The correct form of `rotate y 45` or `rotate 45 y`, if the element is the second of the two
/// values; otherwise empty.
std::string moved_without_times(const Element&, const Names&);

/// Whether at least three undeclared words stand side by side.
bool begins_comment(const Element&, const Evaluator&);

/// Whether the value stands behind #debug or a similar directive, or behind another string.
bool follows_message(const Element&);

/// Whether the value directly follows a declared one whose missing `;` has just been reported.
bool follows_report(const Element&, const Diagnostics&);

}  // namespace candelabra
