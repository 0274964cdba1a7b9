// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a file of a luminaire: no crash, and what is read is finite and can be drawn.
#include "fuzz/target.h"
#include "photometry/polar_diagram.h"

#include <cmath>
#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    PhotometricFile file;
    if (!read_photometric({reinterpret_cast<const char*>(data), size}, {}, file).empty()) return 0;
    if (file.sets.empty() || file.set >= file.sets.size()) std::abort();
    const double flux = file.web.flux(), most = file.web.greatest();
    if (!(flux >= 0 && most >= 0 && std::isfinite(flux) && std::isfinite(most))) std::abort();
    for (const Vec3& direction :
         {Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(-1, 1e-9, 0), Vec3(0.3, -0.5, 0.2)}) {
        const double here = file.web.intensity(direction);
        if (!(here >= 0 && here <= most * (1 + 1e-9))) std::abort();
    }
    if (polar_diagram(file, "seed").find("nan") != std::string::npos) std::abort();
    return 0;
}
