// SPDX-License-Identifier: GPL-3.0-or-later
// `spline { ... }`: reads the block. Splines are values of the language, not parts of a scene, so
// the evaluator reads them itself.
#pragma once

#include "base/spline.h"
#include "formula/formula.h"
#include "interpret/evaluator.h"

#include <optional>

namespace candelabra {

/// Broken when reported.
Value read_spline(Evaluator&, const Element& block);

/// The way of joining that a word names: linear_spline, ...
std::optional<Spline::Kind> spline_kind(std::string_view word);

/// The spline as a function of t.
Handle<Formula> spline_formula(Handle<Spline>);

}  // namespace candelabra
