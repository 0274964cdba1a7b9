// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/contrast.h"

#include "base/gamma.h"

#include <cmath>
#include <utility>
#include <vector>

namespace candelabra {

DisplayValue Contrast::shown(const Vec3& colour, double clear) const {
    DisplayValue shown{colour, clear};
    for (int i = 0; i < 3; ++i)
        shown.colour[i] = from_linear(exposure * to_linear(colour[i], assumed_gamma), gamma);
    return shown;
}

bool Contrast::between(const DisplayValue& a, const DisplayValue& b) const {
    const Vec3 difference = glm::abs(a.colour - b.colour);
    return difference.x + difference.y + difference.z + std::abs(a.clear - b.clear) >= threshold;
}

Contrast contrast_of(const RenderSettings& settings, double assumed_gamma, double exposure) {
    return {settings.antialias_threshold, assumed_gamma, settings.antialias_gamma, exposure};
}

ContrastRule contrast_rule(const RenderSettings& settings, double assumed_gamma, double exposure) {
    return {contrast_of(settings, assumed_gamma, exposure), settings.antialias_depth,
            settings.jitter ? settings.jitter_amount : 0};
}

std::uint32_t all_samples(const ContrastRule& rule) {
    return static_cast<std::uint32_t>(1 + rule.across * rule.across);
}

bool refine_block(const Contrast& contrast, const Region& block, const ContrastPixels& pixels) {
    const int left = block.left - 1, top = block.top - 1, across = block.right - left;
    std::vector<DisplayValue> shown;
    for (int y = top; y < block.bottom; ++y)
        for (int x = left; x < block.right; ++x)
            // The upper left corner is adjacent to no pixel of the block.
            shown.push_back(x == left && y == top ? DisplayValue() : pixels.first(x, y));
    std::vector<bool> refined(shown.size());
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>((y - top) * across + (x - left));
    };
    const auto refine = [&](int x, int y) {
        if (!block.contains(x, y) || refined[at(x, y)]) return true;
        const std::optional<DisplayValue> all = pixels.all(x, y);
        if (all) shown[at(x, y)] = *all;
        refined[at(x, y)] = true;
        return all.has_value();
    };
    for (int y = block.top; y < block.bottom; ++y)
        for (int x = block.left; x < block.right; ++x) {
            const DisplayValue first = shown[at(x, y)];
            for (const auto& [u, v] : {std::pair{x - 1, y}, std::pair{x, y - 1}})
                if (contrast.between(first, shown[at(u, v)]) && !(refine(u, v) && refine(x, y)))
                    return false;
        }
    return true;
}

Vec2 place_in_pixel(const ContrastRule& rule, const Key& key) {
    if (key.sample == 0) return Vec2(0.5);
    const int cell = static_cast<int>(key.sample) - 1;
    const auto moved = [&](Purpose purpose) {
        return rule.jitter == 0 ? 0 : rule.jitter * (uniform(key, purpose) - 0.5);
    };
    return Vec2(cell % rule.across + 0.5 + moved(Purpose::pixel_x),
                cell / rule.across + 0.5 + moved(Purpose::pixel_y)) /
           static_cast<double>(rule.across);
}

}  // namespace candelabra
