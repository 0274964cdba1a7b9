// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises vectors that are written without their `< >`: `translate 1, 2, 3`, `rgb 1, 0, 0`,
// `sphere { 0, 0, 0, 1 }`, or without their `*`: `rotate y 45`. A single number stands for a
// vector, so only what follows it shows that one was meant. Asked for reports on a number that
// has no place, or is wrong in its place.
#pragma once

#include "interpret/evaluator.h"
#include "vocabulary/schema.h"

#include <optional>

namespace candelabra {

/// The report for a number that follows another one, of which a word in front of them takes one
/// vector or colour; nothing when it is something else.
std::optional<Diagnostic> unbracketed_vector(const Element&, const Names&);

/// The same for numbers that begin a block of that item and are more than it has values.
std::optional<Diagnostic> unbracketed_vectors(const Element&, const ItemInfo&);

/// `rotate y 45` and `rotate 45 y`: how a movement along an axis is written, when the value is the
/// second of the two; empty when not.
std::string moved_without_times(const Element&, const Names&);

/// Whether three words or more stand side by side that nothing is declared as.
bool begins_comment(const Element&, const Evaluator&);

/// Whether the value stands behind a #debug or a relative of it, or behind another string.
bool follows_message(const Element&);

/// Whether the value stands right behind another one that was declared without its `;`, which has
/// just been reported.
bool follows_report(const Element&, const Diagnostics&);

}  // namespace candelabra
