// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/kept_meters.h"

#include "relight/factor_means.h"
#include "relight/lamp_cut.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace candelabra {

bool is_sum_of_lamps(const Meter& meter) {
    return unit_of(meter.measures()) == "lx" || meter.measures() == Quantity::luminance;
}

std::vector<LampRange> nodes_for_points(const LampList& lamps, std::size_t points) {
    constexpr std::size_t most_products = 1'000'000;
    std::vector<LampAtom> atoms;
    for (std::uint32_t i = 0; i < lamps.size(); ++i)
        atoms.push_back({{i, i + 1}, static_cast<double>(lamps.powers()[i])});
    const std::size_t most =
        std::max(most_products / std::max<std::size_t>(points, 1), std::size_t{1});
    return chosen_nodes(lamps, atoms, most);
}

KeptMeters kept_meters(std::span<const Meter> meters, std::span<const MeterReading> readings,
                       std::vector<LampRange> nodes) {
    KeptMeters kept{std::move(nodes), {}};
    const std::size_t columns = 3 * kept.nodes.size();
    for (std::size_t i = 0; i < meters.size(); ++i) {
        const MeterReading& reading = readings[i];
        const Quantity quantity = meters[i].measures();
        KeptMeter& made = kept.meters.emplace_back();
        made.name = meters[i].name;
        made.quantity = name_of(quantity);
        made.unit = unit_of(quantity);
        for (std::size_t k = 0; k < reading.places.size(); ++k) {
            made.points.push_back(reading.places[k].position);
            double left = 0;
            for (const MeterHalf& half : reading.halves) left += half.values[k] / 2;
            for (std::size_t c = 0; c < columns; ++c) {
                double light = 0;
                for (const MeterHalf& half : reading.halves)
                    light += half.by_column[k * columns + c] / 2;
                made.light.push_back(static_cast<float>(light));
                left -= light;
            }
            made.rest.push_back(static_cast<float>(left));
        }
    }
    return kept;
}

std::vector<double> relit_readings(const KeptMeters& kept, const KeptMeter& meter,
                                   const LampList& lamps, std::span<const Rgb> factors) {
    const FactorMeans means(lamps, factors);
    std::vector<double> values;
    for (const float rest : meter.rest) values.push_back(static_cast<double>(rest));
    for (std::size_t n = 0; n < kept.nodes.size(); ++n) {
        const Rgb mean = means(kept.nodes[n]);
        for (std::size_t k = 0; k < values.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                values[k] += mean[static_cast<int>(c)] *
                             static_cast<double>(meter.light[3 * (k * kept.nodes.size() + n) + c]);
    }
    return values;
}

}  // namespace candelabra
