// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a mesh file, whose kind the first byte says; what is read is subdivided, joined with
// itself and wrapped in a hull: no crash, and no place that is not there.
#include "fuzz/target.h"
#include "meshing/library.h"
#include "models/model_file.h"

#include <array>
#include <cstdlib>

using namespace candelabra;

namespace {

void check(const Polyhedron& made) {
    for (const Polyhedron::Face& face : made.faces)
        for (const int corner : face)
            if (corner < 0 || static_cast<std::size_t>(corner) >= made.points.size()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static constexpr std::array endings = {".obj", ".ply", ".stl", ".off"};
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    Diagnostics diagnostics;
    const Polyhedra* const library = modelling_library(diagnostics, {});
    if (!library) std::abort();
    Polyhedron read, made;
    PolyhedronLook look;
    if (!read_model(endings[data[0] % endings.size()], bytes, read, look).empty()) return 0;
    check(read);
    constexpr std::size_t max_faces = 60;  // the operations take long
    if (read.faces.size() > max_faces) return 0;
    for (const SubdivisionRule rule : {SubdivisionRule::loop, SubdivisionRule::root3})
        if (library->subdivide(read, rule, 2, made).empty()) check(made);
    if (library->hull(read.points, made).empty()) check(made);
    static constexpr std::array steps = {SolidOperation::take, SolidOperation::take,
                                         SolidOperation::join};
    Polyhedron moved = read;
    for (Polyhedron::Point& point : moved.points) point[0] += 0.25;
    const std::array solids = {read, moved};
    const WorkCount uncounted = [](std::uint64_t) {};
    if (library->combine(steps, solids, uncounted, made).empty()) check(made);
    return 0;
}
