// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the paper's octree: the subdivision of space, and the luminaires that are bright in
// each cell (the paper, section 4.3). Built top down, where surfaces are. A luminaire that is dim
// in a cell is dim in all cells within it.
#pragma once

#include "lighting/light_scene.h"
#include "lighting/settings.h"

namespace candelabra {

/// Returns the greatest distance from the luminaire's centre at which a white diffuse surface that
/// faces the luminaire may have at least that radiance by its light alone; below 0: nowhere.
double bright_reach(const LightBounds&, double radiance);

/// Returns the cube over all surfaces, where points may be lit. For unbounded planes, the
/// neighbourhood of the luminaires counts.
Box cube_to_light(const LightScene&, std::span<const LightBounds>);

struct LightCell {
    static constexpr std::uint32_t no_list = ~std::uint32_t{0};
    std::uint32_t children = 0;    ///< first of eight; 0: none
    std::uint32_t list = no_list;  ///< of cells without children that a surface may be in
};

/// An octree over a cube. Points outside count as the nearest ones inside.
struct LightCells {
    Vec3 low = Vec3(0);
    double side = 0;
    std::vector<LightCell> cells;
    std::vector<std::vector<LightIndex>> lists;  ///< ascending

    /// Returns the list of the cell that contains the point, or LightCell::no_list.
    std::uint32_t list_at(const Vec3& point) const;
};

LightCells build_light_cells(const PaperOctree&, const LightScene&, std::span<const LightBounds>,
                             int threads);

}  // namespace candelabra
