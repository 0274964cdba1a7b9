// SPDX-License-Identifier: GPL-3.0-or-later
// Converts values of the language to values of fields. Called by the readers of blocks. A value
// that does not convert is reported with the expected type.
#pragma once

#include "reading/block.h"

#include <optional>

namespace candelabra {

/// How messages name the destination of a value.
struct Slot {
    FunctionRef<std::string()> name;
    FunctionRef<std::string()> help;
};

/// Converts the value to the field's type as POV-Ray does: one number serves for all components,
/// missing components are 0. Returns nothing, after a diagnostic, if the value has another type.
std::optional<FieldValue> converted(OpenBlock&, const Element&, FieldType, const Slot&);

/// Sets a field of the item if the numbers have its type and lie in its range. Otherwise returns
/// false without effect, and the caller must use converted().
bool set_fitting(const ItemInfo&, void* item, std::size_t field, const Numbers&);

/// Converts a value that must be marked as a colour: `rgb <1, 0, 0>` or `Red`, not <1, 0, 0>.
std::optional<Colour> plain_colour(OpenBlock&, const Element&);

/// Whether a body consists only of `rgb ...`, as in most pigments.
bool colour_alone(Body);
/// The body's colour, or nothing, without effect, if it cannot be computed without diagnostics.
/// Precondition: colour_alone().
std::optional<Colour> computed_colour(Evaluator&, Body);

/// Noun phrase for the type in messages: "a whole number".
std::string_view kind_name(FieldType);

/// The first component that is out of range, or null.
const double* offender(const Range&, const FieldValue&);
/// Text of the range's condition: "at least 0".
std::string rule(const Range&);

}  // namespace candelabra
