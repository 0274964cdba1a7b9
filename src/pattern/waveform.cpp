// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/waveform.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <numbers>

namespace candelabra {

const ItemInfo RampWave::vocabulary = described<RampWave>([] {
    return schema<RampWave>(
        "ramp_wave", {"Straight up, then back at once.", "pigment { onion ramp_wave scale 0.3 }"});
});

const ItemInfo TriangleWave::vocabulary = described<TriangleWave>([] {
    return schema<TriangleWave>(
        "triangle_wave",
        {"Straight up, then straight down.", "pigment { gradient x triangle_wave scale 0.4 }"});
});

const ItemInfo SineWave::vocabulary = described<SineWave>([] {
    return schema<SineWave>("sine_wave", {"Up and down without corners.",
                                          "pigment { gradient x sine_wave frequency 3 }"});
});

const ItemInfo ScallopWave::vocabulary = described<ScallopWave>([] {
    return schema<ScallopWave>("scallop_wave", {"Half circles side by side, more or less.",
                                                "pigment { gradient x scallop_wave frequency 3 }"});
});

const ItemInfo CubicWave::vocabulary = described<CubicWave>([] {
    return schema<CubicWave>("cubic_wave", {"Up with a gentle start and end, then back.",
                                            "pigment { gradient x cubic_wave frequency 3 }"});
});

const ItemInfo PolyWave::vocabulary = described<PolyWave>([] {
    using F = Field<PolyWave>;
    return schema<PolyWave>(
        "poly_wave",
        {"Up along a power, then back.", "pigment { gradient x poly_wave 3 frequency 3 }"},
        maybe(F{"exponent", &PolyWave::exponent, positional, "the power"}));
});

namespace {

double shaped(const RampWave&, double v) { return v; }
double shaped(const TriangleWave&, double v) { return triangle(v); }
double shaped(const SineWave&, double v) { return 0.5 * (1 + cycle(v)); }
double shaped(const ScallopWave&, double v) { return std::abs(cycle(v / 2)); }
double shaped(const CubicWave&, double v) { return v * v * (3 - 2 * v); }
double shaped(const PolyWave& wave, double v) {
    return math::pow(v, single_precision(wave.exponent));
}

}  // namespace

double triangle(double value) {
    const double part =
        value >= 0 ? value - std::floor(value) : value + 1 + std::floor(std::abs(value));
    return part < 0.5 ? 2 * part : 2 * (1 - part);
}

double cycle(double value) {
    const double size = std::abs(value);
    const double sine = math::sin(2 * std::numbers::pi * (size - std::floor(size)));
    return value < 0 ? -sine : sine;
}

double waved(const Waveform& wave, const PatternModifiers& modifiers, double value) {
    // Slightly above 1, so that a value of 1 does not wrap.
    constexpr double period = 1.00001;
    const double frequency = single_precision(modifiers.frequency);
    if (frequency != 0)
        value = std::fmod(value * frequency + single_precision(modifiers.phase), period);
    if (value < 0) value -= std::floor(value);
    return std::visit([&](const auto& kind) { return shaped(kind, value); }, wave);
}

}  // namespace candelabra
