// SPDX-License-Identifier: GPL-3.0-or-later
// Parses patterns from scene text and checks their values at points against those that POV-Ray 3.7
// prints.
#pragma once

#include "support/script.h"
#include "surface/pigment_map.h"

#include <catch2/catch.hpp>

#include <array>
#include <initializer_list>
#include <string>

namespace candelabra {

/// Returns the pattern in `pigment { text }`.
inline PatternUse pattern_of(const std::string& text) {
    const Script done = run("#version 3.7; sphere { 0, 1 pigment { " + text + " } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    const Pigment& pigment = done.texture().pigment;
    REQUIRE(pigment.pattern != nullptr);
    PatternUse use = pigment.pattern->use;
    use.steps.emplace_back(pigment.transform);
    return use;
}

inline double value_at(const PatternUse& use, const Vec3& point, const PatternScene& scene = {}) {
    return use.value(use.place(point), scene);
}

struct ExpectedPattern {
    std::string text;
    std::array<double, 4> values;
};

/// Checks patterns at (0.3, 0.7, -0.2), (1.3, 2.7, 3.9), (-2.45, 0.15, -7.6) and
/// (12.34, -56.78, 90.12), to 9 digits.
inline void check_patterns(std::initializer_list<ExpectedPattern> expected, double margin = 2e-9) {
    const std::array<Vec3, 4> points = {Vec3(0.3, 0.7, -0.2), Vec3(1.3, 2.7, 3.9),
                                        Vec3(-2.45, 0.15, -7.6), Vec3(12.34, -56.78, 90.12)};
    for (const ExpectedPattern& e : expected) {
        INFO(e.text);
        const PatternUse use = pattern_of(e.text);
        for (std::size_t i = 0; i < points.size(); ++i)
            CHECK(value_at(use, points[i]) == Approx(e.values[i]).margin(margin).epsilon(0));
    }
}

}  // namespace candelabra
