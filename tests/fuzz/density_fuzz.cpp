// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a DF3 file, which is then asked at places on and beyond its borders.
#include "fuzz/target.h"
#include "pattern/density_file.h"

#include <cmath>
#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto grid = read_density_grid({reinterpret_cast<const char*>(data), size});
    if (!grid) return 0;
    if (grid->values.size() != grid->size[0] * grid->size[1] * grid->size[2]) std::abort();
    DensityFile file;
    file.grid = make_handle<DensityGrid>(std::move(*grid));
    for (file.interpolate = 0; file.interpolate < 3; ++file.interpolate)
        for (const double t : {-1.0, 0.0, 0.3, 0.5, std::nextafter(1.0, 0.0), 1.0, std::nan("")})
            for (const double s : {0.0, 0.7, std::nextafter(1.0, 0.0)})
                for (const Vec3& at : {Vec3(t, s, s), Vec3(s, t, s), Vec3(s, s, t)})
                    if (!std::isfinite(evaluate(file, at))) std::abort();
    return 0;
}
