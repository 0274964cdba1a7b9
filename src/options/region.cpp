// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/region.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Returns the number of rows or columns before the start.
int before(const std::optional<double>& start, int size) {
    if (!start) return 0;
    const double rows = *start < 1 ? std::floor(*start * size) : *start - 1;
    return static_cast<int>(std::clamp(rows, 0.0, static_cast<double>(size)));
}

int up_to(const std::optional<double>& end, int size) {
    if (!end) return size;
    // An end of 1 means all, as in POV-Ray, whose settings contain `End_Row=1.0`.
    const double rows = *end <= 1 ? std::floor(*end * size) : *end;
    return static_cast<int>(std::clamp(rows, 0.0, static_cast<double>(size)));
}

}  // namespace

Region region_of(const Options& options) {
    const int width = options.render.width, height = options.render.height;
    return {before(options.start_column, width), before(options.start_row, height),
            up_to(options.end_column, width), up_to(options.end_row, height)};
}

}  // namespace candelabra
