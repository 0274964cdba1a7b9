// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/ripples.h"

#include "vocabulary/schema.h"

#include "pattern/waveform.h"

#include <algorithm>

namespace candelabra {

const ItemInfo Ripples::vocabulary = described<Ripples>([] {
    return schema<Ripples>("ripples", {"Rings around random points, as of drops in water.",
                                       "pigment { ripples scale 0.2 }"});
});

const ItemInfo Waves::vocabulary = described<Waves>([] {
    return schema<Waves>("waves", {"Rings of different lengths around random points.",
                                   "pigment { waves scale 0.2 }"});
});

namespace {

double distance_to(const WaveSource& source, const Vec3& point) {
    const double distance = length(point - source.centre);
    return distance == 0 ? 1 : distance;
}

}  // namespace

std::span<const WaveSource> wave_sources(int number) {
    static const std::vector<WaveSource> all = [] {
        std::vector<WaveSource> made(max_wave_sources);
        NoiseSequence sequence(3734115329u);
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i] = {unit(vector_noise(Vec3(static_cast<double>(i), 0, 0))),
                       sequence.next() * 0.000030518509476 + 0.01};
        return made;
    }();
    return std::span(all).first(static_cast<std::size_t>(std::clamp(number, 1, max_wave_sources)));
}

double ring(const PatternModifiers& modifiers, double frequency, double distance) {
    return cycle(single_precision(modifiers.frequency) * frequency * distance +
                 single_precision(modifiers.phase));
}

double evaluate(const Ripples&, const PatternPoint& at) {
    double sum = 0;
    const auto sources = wave_sources(at.scene.number_of_waves);
    for (const WaveSource& source : sources)
        sum += ring(at.modifiers, 1, distance_to(source, at.position));
    return 0.5 * (1 + sum / static_cast<double>(sources.size()));
}

double evaluate(const Waves&, const PatternPoint& at) {
    double sum = 0;
    const auto sources = wave_sources(at.scene.number_of_waves);
    for (const WaveSource& source : sources)
        sum += ring(at.modifiers, source.frequency, distance_to(source, at.position)) /
               source.frequency;
    return 0.2 * (2.5 + sum / static_cast<double>(sources.size()));
}

}  // namespace candelabra
