// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/meter_table.h"

#include "output/estimates.h"
#include "text/message.h"

#include <cstddef>
#include <vector>

namespace candelabra {

std::string relit_readings(const LightRecords& records, std::span<const Rgb> factors,
                           std::string_view begin) {
    std::string rows;
    const KeptMeters& kept = records.meters;
    for (std::size_t i = 0; i < kept.meters.size(); ++i) {
        const KeptMeter& meter = kept.meters[i];
        const std::string name = meter.name.empty() ? message("meter ", i + 1) : meter.name;
        const std::vector<double> values = relit_readings(kept, meter, records.lamps, factors);
        for (std::size_t k = 0; k < values.size(); ++k) {
            const Vec3& at = meter.points[k];
            rows += message(begin, csv_cell(name), ',', meter.quantity, ',', meter.unit, ',', k + 1,
                            ',', at.x, ',', at.y, ',', at.z, ',', cell(values[k]), '\n');
        }
    }
    return rows;
}

}  // namespace candelabra
