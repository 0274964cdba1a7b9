// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/noise_patterns.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include "pattern/waveform.h"

#include <algorithm>
#include <array>

namespace candelabra {

const ItemInfo Bozo::vocabulary = described<Bozo>([] {
    return schema<Bozo>("bozo",
                        {"Smooth noise: soft spots of all values.", "pigment { bozo scale 0.2 }"});
});

const ItemInfo Spotted::vocabulary = described<Spotted>([] {
    return schema<Spotted>("spotted", {"The noise of bozo, with a map from black to white.",
                                       "pigment { spotted scale 0.2 }"});
});

const ItemInfo Bumps::vocabulary = described<Bumps>([] {
    return schema<Bumps>(
        "bumps", {"The noise of bozo; as a normal, gentle bumps.", "pigment { bumps scale 0.15 }"});
});

const ItemInfo Dents::vocabulary = described<Dents>([] {
    return schema<Dents>("dents", {"The third power of noise: small spots on a plain ground.",
                                   "pigment { dents scale 0.2 }"});
});

const ItemInfo Wrinkles::vocabulary = described<Wrinkles>([] {
    return schema<Wrinkles>(
        "wrinkles", {"Ten octaves of noise: crumpled paper.", "pigment { wrinkles scale 0.4 }"});
});

const ItemInfo Granite::vocabulary = described<Granite>([] {
    return schema<Granite>("granite", {"Six octaves of folded noise, with many fine veins.",
                                       "pigment { granite scale 0.6 }"});
});

const ItemInfo Agate::vocabulary = described<Agate>([] {
    using F = Field<Agate>;
    return schema<Agate>(
        "agate",
        {"Thin bands, much disturbed, as in the stone.", "pigment { agate scale 0.3 }",
         "pigment { agate agate_turb 0.5 scale 0.3 }"},
        F{"agate_turb", &Agate::agate_turb, item,
          "how much the bands are disturbed, beside any turbulence"});
});

namespace {

/// Returns frequencies that start at `first` and double each time.
template <std::size_t count>
constexpr std::array<double, count> doubled(double first) {
    std::array<double, count> result{};
    for (double& frequency : result) {
        frequency = first;
        first *= 2;
    }
    return result;
}

template <std::size_t count>
std::array<double, count> noises_at(const PatternPoint& at,
                                    const std::array<double, count>& frequencies) {
    std::array<double, count> values;
    noises(at.position, frequencies, at.noise_generator(), values.data());
    return values;
}

}  // namespace

double evaluate(const Bozo&, const PatternPoint& at) {
    return noise(at.position, at.noise_generator());
}

double evaluate(const Spotted&, const PatternPoint& at) { return evaluate(Bozo{}, at); }

double evaluate(const Bumps&, const PatternPoint& at) { return evaluate(Bozo{}, at); }

double evaluate(const Dents&, const PatternPoint& at) {
    const double value = evaluate(Bozo{}, at);
    return value * value * value;
}

double evaluate(const Wrinkles&, const PatternPoint& at) {
    const bool original = at.noise_generator() == NoiseGenerator::original;
    static constexpr auto octaves = doubled<10>(1);
    const auto values = noises_at(at, octaves);
    double sum = 0;
    for (std::size_t i = 0; i < octaves.size(); ++i)
        sum += (original ? values[i] : std::clamp(2 * values[i] - 0.5, 0.0, 1.0)) / octaves[i];
    return sum / 2;
}

double evaluate(const Granite&, const PatternPoint& at) {
    const bool original = at.noise_generator() == NoiseGenerator::original;
    static constexpr auto octaves = doubled<6>(4);
    const auto values = noises_at(at, octaves);
    double sum = 0;
    for (std::size_t i = 0; i < octaves.size(); ++i) {
        const double folded =
            original ? std::abs(0.5 - values[i]) : std::min(0.5, std::abs(1 - 2 * values[i]));
        sum += folded / (octaves[i] / 4);
    }
    return sum;
}

double evaluate(const Agate& agate, const PatternPoint& at) {
    const double disturbed =
        single_precision(agate.agate_turb) *
        scalar_turbulence(at.position, at.modifiers.noise_octaves(), at.noise_generator());
    const double band = 0.5 * (cycle(1.3 * disturbed + 1.1 * at.position.z) + 1);
    return math::pow(std::clamp(band, 0.0, 1.0), 0.77);
}

}  // namespace candelabra
