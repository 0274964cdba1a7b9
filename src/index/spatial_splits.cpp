// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/spatial_splits.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

/// Sum of the areas of the items' boxes, over the area around them, above which pieces are made. It
/// is the mean number of boxes that a ray meets.
constexpr double crowd = 16;
/// Maximum number of pieces per item, on average.
constexpr std::size_t max_pieces = 4;
/// Minimum fraction of a box's area that a cut must save; for long thin items it saves half.
constexpr double min_gain = 0.2;

double sum_of_areas(std::span<const PrimRef> fragments) {
    double sum = 0;
    for (const PrimRef& f : fragments) sum += area(f.box);
    return sum;
}

/// Bounds of the piece in both halves of its box along the longest side; nothing if the gain is too
/// small. One of the halves may be empty.
std::optional<std::pair<Box, Box>> cut(const PrimRef& piece, const ItemPart& part, double slack) {
    const Vec3 size = piece.box.size();
    const int axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    Box below = piece.box, above = piece.box;
    below.high[axis] = above.low[axis] = piece.box.centre()[axis];
    const auto part_in = [&](const Box& cell) -> Box {
        const Box box = part(piece.item, cell);
        if (box.empty()) return {};
        return clip(Box{box.low - Vec3(slack), box.high + Vec3(slack)}, piece.box);
    };
    below = part_in(below);
    above = part_in(above);
    if (below.empty() && above.empty()) return {};
    if (area(below) + area(above) > (1 - min_gain) * area(piece.box)) return {};
    return std::pair(below, above);
}

}  // namespace

std::vector<PrimRef> pieces_of(std::span<const PrimRef> fragments, const Box& around,
                               const ItemPart& part, double slack) {
    const double enough = crowd * area(around);
    double sum = sum_of_areas(fragments);
    if (!(sum > enough)) return {};
    std::vector<PrimRef> pieces(fragments.begin(), fragments.end());
    bool any = false;
    for (bool more = true;
         more && sum > enough && 2 * pieces.size() <= max_pieces * fragments.size();) {
        more = false;
        // Larger boxes first, so that none is cut finer than others.
        const double large = 0.5 * sum / static_cast<double>(pieces.size());
        for (std::size_t i = 0, count = pieces.size(); i < count; ++i) {
            if (area(pieces[i].box) < large) continue;
            const auto halves = cut(pieces[i], part, slack);
            if (!halves) continue;
            more = true;
            const auto& [below, above] = *halves;
            const std::uint32_t item = pieces[i].item;
            pieces[i].box = below.empty() ? above : below;
            if (!below.empty() && !above.empty()) pieces.push_back({above, item});
        }
        any = any || more;
        sum = sum_of_areas(pieces);
    }
    if (!any) pieces.clear();
    return pieces;
}

}  // namespace candelabra
