// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the block `spline { ... }`. Splines are values of the language, not parts of a scene, so
// the evaluator reads them itself.
#pragma once

#include "base/spline.h"
#include "formula/formula.h"
#include "interpret/evaluator.h"

#include <optional>
#include <string>

namespace candelabra {

/// The spline of a block; broken after a report.
Value read_spline(Evaluator&, const Element& block);

/// The kind of interpolation that a word names: linear_spline, ...; nothing for other words.
std::optional<Spline::Kind> spline_kind(std::string_view word);

/// The spline as a block of the language.
std::string spline_text(const Spline&);

/// The spline as a function of t.
Handle<Formula> spline_formula(Handle<Spline>);

}  // namespace candelabra
