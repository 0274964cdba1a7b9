// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/density_file.h"

#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo DensityFile::vocabulary = described<DensityFile>([] {
    using F = Field<DensityFile>;
    return schema<DensityFile>(
        "density_file",
        {"Numbers from a file, in the cube from 0 to 1; 0 outside of it.",
         "pigment { density_file df3 \"spiral.df3\" interpolate 1 translate -0.5 scale 2.4 }"},
        F{"df3", &DensityFile::df3, item, "name of a file of format df3"},
        F{"interpolate", &DensityFile::interpolate, item,
          "0: none, 1: linear, 2: cubic; only the last digit counts", at_least(0)});
});

namespace {

std::uint32_t big_endian(std::string_view content, std::size_t at, std::size_t bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < bytes; ++i)
        number = number << 8 | static_cast<unsigned char>(content[at + i]);
    return number;
}

/// Position of a coordinate among the values along one axis.
struct AxisPlace {
    std::array<std::size_t, 4> index{};  ///< of the value before, the value, and the two after
    double fraction = 0;
};

AxisPlace place(double t, std::size_t size) {
    const double along = t * static_cast<double>(size);
    const auto i = std::min(static_cast<std::size_t>(along), size - 1);
    // POV-Ray computes the index before the first modulo the size after it has wrapped around at
    // 2^64. The result is the last index only if the size is a power of two.
    const std::size_t before = i == 0 ? ~std::uint64_t{0} % size : i - 1;
    return {{before, i, (i + 1) % size, (i + 2) % size}, along - static_cast<double>(i)};
}

double interpolated(double a, double b, double t) { return a + t * (b - a); }

/// Cubic Hermite interpolation from v[1] to v[2] with central differences as slopes.
double cubic(const std::array<double, 4>& v, double t) {
    const double start = (v[2] - v[0]) / 2, end = (v[3] - v[1]) / 2, step = v[1] - v[2];
    const double third = 2 * step + start + end, second = -3 * step - 2 * start - end;
    return ((third * t + second) * t + start) * t + v[1];
}

struct Sampler {
    const DensityGrid& grid;
    AxisPlace x, y, z;

    double at(std::size_t i, std::size_t j, std::size_t k) const {
        return grid.values[(z.index[k] * grid.size[1] + y.index[j]) * grid.size[0] + x.index[i]];
    }
    double linear() const {
        const auto along_z = [&](std::size_t i, std::size_t j) {
            return interpolated(at(i, j, 1), at(i, j, 2), z.fraction);
        };
        return interpolated(interpolated(along_z(1, 1), along_z(1, 2), y.fraction),
                            interpolated(along_z(2, 1), along_z(2, 2), y.fraction), x.fraction);
    }
    double cubic() const {
        std::array<double, 4> planes{}, lines{}, points{};
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t k = 0; k < 4; ++k) points[k] = at(i, j, k);
                lines[j] = candelabra::cubic(points, z.fraction);
            }
            planes[i] = candelabra::cubic(lines, y.fraction);
        }
        return std::max(0.0, candelabra::cubic(planes, x.fraction));
    }
};

}  // namespace

std::optional<DensityGrid> read_density_grid(std::string_view content) {
    constexpr std::size_t header = 6;
    if (content.size() < header) return std::nullopt;
    DensityGrid grid;
    for (std::size_t i = 0; i < 3; ++i) grid.size[i] = big_endian(content, 2 * i, 2);
    const std::size_t count = grid.size[0] * grid.size[1] * grid.size[2];
    if (count == 0) return std::nullopt;
    const std::size_t bytes = (content.size() - header) / count;
    if (bytes != 1 && bytes != 2 && bytes != 4) return std::nullopt;
    if (bytes * count + header != content.size()) return std::nullopt;
    const double greatest = static_cast<double>((std::uint64_t{1} << 8 * bytes) - 1);
    grid.values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        grid.values[i] =
            static_cast<float>(big_endian(content, header + i * bytes, bytes) / greatest);
    return grid;
}

double evaluate(const DensityFile& file, const Vec3& point) {
    const auto inside = [](double t) { return t >= 0 && t < 1; };
    if (!file.grid || !inside(point.x) || !inside(point.y) || !inside(point.z)) return 0;
    const auto& size = file.grid->size;
    const Sampler sampler{*file.grid, place(point.x, size[0]), place(point.y, size[1]),
                          place(point.z, size[2])};
    switch (file.interpolate % 10) {
        case 0:
            return sampler.at(1, 1, 1);
        case 1:
            return sampler.linear();
        default:
            return sampler.cubic();
    }
}

}  // namespace candelabra
