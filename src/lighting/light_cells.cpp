// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/light_cells.h"

#include "base/order.h"
#include "base/parallel.h"
#include "lighting/tuning.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Maximum number of entries of all lists together. A cell's share of them is passed on to its
/// children by the lengths of their lists.
double max_entries(std::size_t luminaires) {
    return std::fmin(1e6, 1e5 + 128 * static_cast<double>(luminaires));
}
/// A cell that may still be cut.
struct Region {
    Box box;
    std::vector<LightIndex> lights;
    std::vector<std::uint32_t> surfaces;  ///< that touch the cell; unused if it is covered
    bool covered = false;                 ///< surfaces may be anywhere in it
    int depth = 0;
    double entries = 0;    ///< maximum number of entries of its lists
    int useless_cuts = 0;  ///< number of its last cuts that did not help
};

Box octant(const Box& box, int which) {
    const Vec3 middle = box.centre();
    Box result = box;
    for (int axis = 0; axis < 3; ++axis)
        (which >> axis & 1 ? result.low : result.high)[axis] = middle[axis];
    return result;
}

bool touches(const Box& a, const Box& b) { return !clip(a, b).empty(); }

bool touches(const Plane& plane, const Box& box) {
    const Vec3 normal = unit(plane.normal), half = 0.5 * box.size();
    return std::abs(dot(normal, box.centre()) - plane.distance) <=
           dot(glm::abs(normal), half) * (1 + 1e-9);
}

class Grower {
public:
    Grower(const PaperOctree& settings, const LightScene& scene, const std::vector<Vec3>& centres,
           const std::vector<double>& reach2)
        : settings_(settings), scene_(scene), centres_(centres), reach2_(reach2) {
        tree.cells.resize(1);
    }

    /// Makes the region a cell, with all cells below it.
    void grow(std::uint32_t cell, Region region) {
        std::vector<Region> parts = cut(region);
        if (parts.empty()) {
            tree.cells[cell].list = static_cast<std::uint32_t>(tree.lists.size());
            tree.lists.push_back(brightest(region));
            return;
        }
        region = {};
        const auto first = static_cast<std::uint32_t>(tree.cells.size());
        tree.cells[cell].children = first;
        tree.cells.resize(tree.cells.size() + 8);
        for (std::uint32_t i = 0; i < 8; ++i)
            if (!parts[i].box.empty()) grow(first + i, std::move(parts[i]));
    }

    /// Returns the eight parts of a region, where parts without surfaces have an empty box; nothing
    /// if the region is to stay whole.
    std::vector<Region> cut(const Region& region) const {
        if (region.depth >= settings_.max_depth || region.useless_cuts >= tuning::patience ||
            region.lights.size() <= static_cast<std::size_t>(settings_.max_bright) ||
            bright_everywhere(region))
            return {};
        std::vector<Region> parts(8);
        double entries = 0, lights = 0, unchanged = 0;
        for (int i = 0; i < 8; ++i) {
            parts[i] = part(region, octant(region.box, i));
            entries += length_of_list(parts[i]);
            lights += static_cast<double>(parts[i].lights.size());
            if (!parts[i].box.empty()) unchanged += static_cast<double>(region.lights.size());
        }
        if (entries > region.entries) return {};
        for (Region& p : parts) {
            p.entries = entries > 0 ? region.entries * length_of_list(p) / entries : 0;
            p.useless_cuts = lights > tuning::helpful * unchanged ? region.useless_cuts + 1 : 0;
        }
        return parts;
    }

    LightCells tree;

private:
    static double length_of_list(const Region& region) {
        return static_cast<double>(std::min(region.lights.size(), tuning::longest_list));
    }

    /// Returns the list of a cell that is not cut.
    std::vector<LightIndex> brightest(Region& region) const {
        std::vector<LightIndex>& lights = region.lights;
        if (lights.size() > tuning::longest_list) {
            // The distance relative to the reach tells how far above the threshold each may be.
            const auto farness = [&](LightIndex light) {
                return nearest_distance2(region.box, centres_[light]) / reach2_[light];
            };
            const auto last = lights.begin() + static_cast<std::ptrdiff_t>(tuning::longest_list);
            put_nth(lights.begin(), last, lights.end(), [&](LightIndex a, LightIndex b) {
                return std::pair(farness(a), a) < std::pair(farness(b), b);
            });
            lights.erase(last, lights.end());
            std::ranges::sort(lights);
            lights.shrink_to_fit();
        }
        return std::move(lights);
    }

    /// Whether all luminaires that are bright somewhere in the region are bright everywhere in it,
    /// and so in all of its parts.
    bool bright_everywhere(const Region& region) const {
        return std::ranges::all_of(region.lights, [&](LightIndex light) {
            return farthest_distance2(region.box, centres_[light]) < reach2_[light];
        });
    }

    Region part(const Region& whole, const Box& box) const {
        Region result;
        result.covered = whole.covered;
        if (!whole.covered)
            for (const std::uint32_t surface : whole.surfaces) {
                if (!touches_surface(surface, box)) continue;
                result.surfaces.push_back(surface);
                if (surface < scene_.surfaces.size() &&
                    clip(scene_.surfaces[surface], box).size() == box.size())
                    result.covered = true;
            }
        if (!result.covered && result.surfaces.empty()) return result;
        if (result.covered) result.surfaces.clear();
        result.box = box;
        result.depth = whole.depth + 1;
        for (const LightIndex light : whole.lights)
            if (nearest_distance2(box, centres_[light]) < reach2_[light])
                result.lights.push_back(light);
        return result;
    }

    bool touches_surface(std::uint32_t surface, const Box& box) const {
        const std::size_t finite = scene_.surfaces.size();
        return surface < finite ? touches(scene_.surfaces[surface], box)
                                : touches(scene_.planes[surface - finite], box);
    }

    const PaperOctree& settings_;
    const LightScene& scene_;
    const std::vector<Vec3>& centres_;
    /// Squared distances within which luminaires are bright.
    const std::vector<double>& reach2_;
};

/// Appends the cells of a part of the tree; the part's first cell goes to the given place.
void splice(LightCells& tree, std::uint32_t place, LightCells&& part) {
    // Cell 0 of the part moves to its place, the others to the end.
    const auto cells = static_cast<std::uint32_t>(tree.cells.size()) - 1,
               lists = static_cast<std::uint32_t>(tree.lists.size());
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
        LightCell cell = part.cells[i];
        if (cell.children != 0) cell.children += cells;
        if (cell.list != LightCell::no_list) cell.list += lists;
        if (i == 0)
            tree.cells[place] = cell;
        else
            tree.cells.push_back(cell);
    }
    std::ranges::move(part.lists, std::back_inserter(tree.lists));
}

}  // namespace

Box cube_to_light(const LightScene& scene, std::span<const LightBounds> lights) {
    Box all;
    for (const Box& box : scene.surfaces)
        if (!box.empty() && finite(box)) all = join(all, box);
    if (all.empty() || !scene.planes.empty())
        for (const LightBounds& light : lights) all = join(all, light.box);
    const Vec3 half(0.5 * max_component(all.size()) * (1 + 1e-9));
    return {all.centre() - half, all.centre() + half};
}

double bright_reach(const LightBounds& light, double radiance) {
    if (!(light.luminance > 0)) return -1;
    // The radiance is luminance times solid angle over pi, if all of it is seen straight on.
    const double solid_angle = pi * radiance / light.luminance;
    if (solid_angle >= 4 * pi) return -1;
    const double versine = solid_angle / (2 * pi);
    const double as_sphere =
        versine >= 1 ? light.radius : light.radius / std::sqrt(versine * (2 - versine));
    // A flat luminaire shows at most its area and its thin sides; any other shows at most twice its
    // average.
    const double seen =
        (light.axis != Vec3(0) ? 1 + 2 * light.evenness : 2) * light.intensity / light.luminance;
    return std::fmin(as_sphere, light.radius + std::sqrt(seen / solid_angle));
}

std::uint32_t LightCells::list_at(const Vec3& point) const {
    if (cells.empty()) return LightCell::no_list;
    Vec3 place = point - low;
    double half = side;
    std::uint32_t here = 0;
    while (cells[here].children != 0) {
        half *= 0.5;
        std::uint32_t which = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (place[axis] >= half) {
                which |= 1u << axis;
                place[axis] -= half;
            }
        here = cells[here].children + which;
    }
    return cells[here].list;
}

LightCells build_light_cells(const PaperOctree& settings, const LightScene& scene,
                             std::span<const LightBounds> lights, int threads) {
    std::vector<double> reach2;
    std::vector<Vec3> centres;
    for (const LightBounds& light : lights) {
        const double reach = bright_reach(light, settings.threshold * settings.white);
        reach2.push_back(reach > 0 ? reach * reach : -1);
        centres.push_back(light.centre);
    }
    Region root;
    root.entries = max_entries(lights.size());
    root.box = cube_to_light(scene, lights);
    if (lights.empty() || root.box.empty()) return {};
    for (std::uint32_t i = 0; i < scene.surfaces.size() + scene.planes.size(); ++i)
        root.surfaces.push_back(i);
    root.covered = std::ranges::any_of(scene.surfaces,
                                       [](const Box& box) { return !box.empty() && !finite(box); });
    for (LightIndex light = 0; light < lights.size(); ++light)
        if (nearest_distance2(root.box, centres[light]) < reach2[light])
            root.lights.push_back(light);

    Grower top(settings, scene, centres, reach2);
    top.tree.low = root.box.low;
    top.tree.side = root.box.high.x - root.box.low.x;
    std::vector<Region> parts = top.cut(root);
    if (parts.empty()) {
        top.grow(0, std::move(root));
        return std::move(top.tree);
    }
    std::vector<Grower> growers(8, Grower(settings, scene, centres, reach2));
    run_parallel(8, threads, [&](std::size_t i) {
        if (!parts[i].box.empty()) growers[i].grow(0, std::move(parts[i]));
    });
    top.tree.cells[0].children = 1;
    top.tree.cells.resize(9);
    for (std::uint32_t i = 0; i < 8; ++i) splice(top.tree, 1 + i, std::move(growers[i].tree));
    return std::move(top.tree);
}

}  // namespace candelabra
