// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/seen_normals.h"

#include "base/parallel.h"
#include "transport/camera_ray.h"
#include "transport/primary_hit.h"
#include "world/shot.h"

#include <cmath>
#include <cstddef>

namespace candelabra {

std::vector<std::int8_t> seen_normals(const Shot& shot, int width, int height, int threads) {
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    std::vector<std::int8_t> normals(3 * columns * rows);
    run_parallel(rows, threads, [&](std::size_t row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const PicturePoint point{static_cast<int>(column), static_cast<int>(row), width,
                                     height};
            constexpr double unit = 127, places = 4;
            Vec3 sum(0);
            for (const Vec2 place :
                 {Vec2(0.375, 0.125), Vec2(0.875, 0.375), Vec2(0.125, 0.625), Vec2(0.625, 0.875)})
                sum += primary_hit(*shot.world, ray_through(shot, point, place, Key())).normal;
            for (std::size_t c = 0; c < 3; ++c)
                normals[3 * (row * columns + column) + c] =
                    static_cast<std::int8_t>(std::lround(unit / places * sum[static_cast<int>(c)]));
        }
    });
    return normals;
}

}  // namespace candelabra
