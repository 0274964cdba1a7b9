// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_file.h"

#include "photometry/ies_file.h"
#include "photometry/ldt_file.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

std::string_view PhotometricFile::label(std::string_view keyword) const {
    const auto found =
        std::ranges::find(labels, keyword, [](const auto& each) { return each.first; });
    return found == labels.end() ? std::string_view() : std::string_view(found->second);
}

std::optional<double> PhotometricFile::lamp_flux() const {
    if (absolute || sets.empty() || !(sets[set].flux > 0)) return std::nullopt;
    return sets[set].flux;
}

std::string read_photometric(std::string_view bytes, const PhotometricChoice& choice,
                             PhotometricFile& file) {
    if (bytes.size() > max_photometric_bytes)
        return message("it has more than ", max_photometric_bytes >> 20, " MiB");
    PhotometricFile made;
    std::string problem = is_ies(bytes) ? read_ies(bytes, made) : read_ldt(bytes, choice, made);
    if (!problem.empty()) return problem;
    check_photometric(made);
    file = std::move(made);
    return {};
}

void check_photometric(PhotometricFile& file) {
    constexpr double largest = 5, tolerance = 1.03;
    const LuminousOpening& opening = file.opening;
    const double size =
        std::max({std::abs(opening.width), std::abs(opening.length), std::abs(opening.height)});
    if (size > largest)
        file.notes.push_back(
            message("the luminous opening is ", size, " m large: its unit may be wrong"));
    const double flux = file.web.flux();
    if (const auto lamps = file.lamp_flux(); lamps && flux > tolerance * *lamps)
        file.notes.push_back(message("the flux of the table, ", std::round(flux),
                                     " lm, is more than that of the lamps, ", *lamps, " lm"));
    if (file.efficiency > 0 && file.lamp_flux()) {
        const double found = 100 * flux / *file.lamp_flux();
        if (std::abs(found - file.efficiency) > 3)
            file.notes.push_back(message("the table gives ", std::round(10 * found) / 10,
                                         " % of the lamps' flux, and the file states ",
                                         file.efficiency, " %"));
    }
}

}  // namespace candelabra
