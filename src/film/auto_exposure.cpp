// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/auto_exposure.h"

#include "base/elementary.h"

#include <cmath>
#include <vector>

namespace candelabra {

namespace {

constexpr double min_stops = -20, max_stops = 40;
/// Maximum brightening of a dark picture, in stops.
constexpr double max_lift = 4;

double mean_shown(const std::vector<double>& luminances, double stops) {
    const double factor = math::exp2(stops);
    double sum = 0;
    for (const double each : luminances) sum += factor * each / (1 + factor * each);
    return sum / static_cast<double>(luminances.size());
}

}  // namespace

double srgb_luminance(const Rgb& c) { return c.r * 0.2126 + c.g * 0.7152 + c.b * 0.0722; }

double stops_asked_by(const Image& image, double key) {
    std::vector<double> lit;
    lit.reserve(image.pixels.size());
    for (const Rgb& pixel : image.pixels) {
        const double light = srgb_luminance(pixel);
        constexpr double most = 1e15;
        lit.push_back(light > 0 ? std::fmin(light, most) : 0);
    }
    if (lit.empty()) return 0;
    const double wanted = key / (1 + key);
    double below = min_stops, above = max_stops;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (below + above) / 2;
        (mean_shown(lit, middle) < wanted ? below : above) = middle;
    }
    return below > 0 ? max_lift * -math::expm1(-below / max_lift) : below;
}

}  // namespace candelabra
