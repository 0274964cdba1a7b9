// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/noise_patterns.h"

#include "vocabulary/schema.h"

#include "pattern/waveform.h"

#include <algorithm>

const ItemInfo Bozo::vocabulary =
    described<Bozo>([] { return schema<Bozo>("bozo", "Smooth noise: soft spots of all values."); });

const ItemInfo Spotted::vocabulary = described<Spotted>([] {
    return schema<Spotted>("spotted", "The same noise as bozo, with a map from black to white.");
});

const ItemInfo Bumps::vocabulary = described<Bumps>(
    [] { return schema<Bumps>("bumps", "The same noise as bozo; as a normal, gentle bumps."); });

const ItemInfo Dents::vocabulary = described<Dents>([] {
    return schema<Dents>("dents", "The third power of noise: small spots on a plain ground.");
});

const ItemInfo Wrinkles::vocabulary = described<Wrinkles>(
    [] { return schema<Wrinkles>("wrinkles", "Ten octaves of noise: crumpled paper."); });

const ItemInfo Granite::vocabulary = described<Granite>([] {
    return schema<Granite>("granite", "Six octaves of folded noise, with many fine veins.");
});

const ItemInfo Agate::vocabulary = described<Agate>([] {
    using F = Field<Agate>;
    return schema<Agate>("agate", "Thin bands, much disturbed, as in the stone.",
                         F{"agate_turb", &Agate::agate_turb, item,
                           "how much the bands are disturbed, beside any turbulence"});
});

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
    const NoiseGenerator generator = at.noise_generator();
    const bool original = generator == NoiseGenerator::original;
    double sum = 0, frequency = 1;
    for (int i = 0; i < 10; ++i, frequency *= 2) {
        const double value = noise(frequency * at.position, generator);
        sum += (original ? value : std::clamp(2 * value - 0.5, 0.0, 1.0)) / frequency;
    }
    return sum / 2;
}

double evaluate(const Granite&, const PatternPoint& at) {
    const NoiseGenerator generator = at.noise_generator();
    const bool original = generator == NoiseGenerator::original;
    double sum = 0, frequency = 1;
    for (int i = 0; i < 6; ++i, frequency *= 2) {
        const double value = noise(4 * frequency * at.position, generator);
        const double folded =
            original ? std::abs(0.5 - value) : std::min(0.5, std::abs(1 - 2 * value));
        sum += folded / frequency;
    }
    return sum;
}

double evaluate(const Agate& agate, const PatternPoint& at) {
    const double disturbed =
        single_precision(agate.agate_turb) *
        scalar_turbulence(at.position, at.modifiers.noise_octaves(), at.noise_generator());
    const double band = 0.5 * (cycle(1.3 * disturbed + 1.1 * at.position.z) + 1);
    return std::pow(std::clamp(band, 0.0, 1.0), 0.77);
}
