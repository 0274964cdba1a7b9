// SPDX-License-Identifier: GPL-3.0-or-later
// Every pattern there is: a function from a point to a number in 0..1, or to a small whole number
// that picks from a list.
#pragma once

#include "pattern/checker.h"
#include "pattern/gradient.h"
#include "vocabulary/kinds.h"

#include <concepts>

using Pattern = std::variant<Checker, Gradient>;

template <class T>
concept PatternKind = requires(const T& pattern, const Vec3& point) {
    { evaluate(pattern, point) } -> std::same_as<double>;
};

inline double evaluate(const Pattern& pattern, const Vec3& point) {
    return std::visit([&](const auto& p) { return evaluate(p, point); }, pattern);
}
