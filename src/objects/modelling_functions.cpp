// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/modelling_functions.h"

#include "base/long_work.h"
#include "interpret/array_data.h"
#include "meshing/library.h"
#include "meshing/scatter.h"
#include "meshing/voronoi.h"
#include "shape/mesh_area.h"
#include "shape/tessellation.h"
#include "text/message.h"

#include <iterator>

namespace candelabra {

namespace {

constexpr double max_places = 1'000'000;
constexpr int cells = 64;

/// The points in an array of vectors; empty after a diagnostic.
std::vector<Vec2> plane_points(FunctionCall& call) {
    std::vector<Vec2> points;
    const ArrayData* array = call.array(0);
    if (!array) return points;
    for (std::size_t i = 0; i < array->size(); ++i) {
        if (array->count(i) < 2 || array->sizes().size() != 1) {
            call.fail(Fault::wrong_type, 0, "the points are an array of vectors <x, y>");
            return {};
        }
        points.emplace_back(array->numbers(i)[0], array->numbers(i)[1]);
    }
    return points;
}

Vec2 plane_vector(FunctionCall& call, std::size_t i) {
    const Numbers& found = call.numbers(i);
    return {found.at[0], found.count > 1 ? found.at[1] : found.at[0]};
}

Value array_of(ArrayData array) { return make_handle<ArrayData>(std::move(array)); }

}  // namespace

Value scatter(FunctionCall& call) {
    const Handle<Object> object = call.object(0);
    const double distance = call.number(1);
    const std::int64_t seed = call.count() > 2 ? call.integer(2) : 0;
    if (call.failed()) return Absence::broken;
    if (!(distance > 0)) return call.fail(Fault::domain, 1, "the distance must be above 0");
    const Composite& surface = call.world.objects->composite(object);
    if (!finite(surface.bounds())) return call.fail(Fault::domain, 0, "this object has no end");
    const Mesh triangles = seen_tessellation(surface, cells);
    const double size = MeshArea(triangles).total();
    if (!(size > 0)) return call.fail(Fault::domain, 0, "no surface is found on this object");
    if (!(size / (distance * distance) <= max_places))
        return call.fail(
            Fault::domain, 1,
            message("so small a distance would give more than ", max_places, " points"));
    const std::vector<SurfacePoint> points =
        scattered(surface, triangles, distance, static_cast<std::uint64_t>(seed));
    if (points.empty()) return call.fail(Fault::domain, 0, "no surface is found on this object");
    ArrayData array({static_cast<int>(points.size()), 2});
    for (std::size_t i = 0; i < points.size(); ++i) {
        array.set(2 * i, Numbers::vector(points[i].position));
        array.set(2 * i + 1, Numbers::vector(points[i].normal));
    }
    return array_of(std::move(array));
}

Value delaunay(FunctionCall& call) {
    const std::vector<Vec2> points = plane_points(call);
    if (call.failed()) return Absence::broken;
    Diagnostics problems;
    const Polyhedra* library = modelling_library(problems, {});
    if (!library) return call.fail(Fault::io, 0, problems.all().front().message);
    std::vector<std::array<double, 2>> places;
    for (const Vec2& p : points) places.push_back({p.x, p.y});
    constexpr std::uint64_t work_of_point = 60;
    count_long_work(work_of_point * places.size());
    std::vector<Polyhedron::Face> faces;
    const std::string wrong = library->triangulate(places, faces);
    if (!wrong.empty()) return call.fail(Fault::domain, 0, wrong);
    ArrayData array({static_cast<int>(faces.size()), 3});
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) array.set(3 * i + k, Numbers::scalar(faces[i][k]));
    return array_of(std::move(array));
}

Value voronoi(FunctionCall& call) {
    const std::vector<Vec2> points = plane_points(call);
    const std::int64_t number = call.integer(1);
    const Vec2 low = plane_vector(call, 2), high = plane_vector(call, 3);
    if (call.failed()) return Absence::broken;
    if (number < 0 || number >= std::ssize(points))
        return call.fail(Fault::domain, 1,
                         message("there is no point ", number, ": there are ", points.size(),
                                 ", counted from 0"));
    const std::vector<Vec2> corners =
        voronoi_cell(points, static_cast<std::size_t>(number), low, high);
    if (corners.empty())
        return call.fail(Fault::domain, 1,
                         message("point ", number,
                                 " has no cell: it lies on another one, or outside of the "
                                 "rectangle"));
    ArrayData array({static_cast<int>(corners.size())});
    for (std::size_t i = 0; i < corners.size(); ++i)
        array.set(i, Numbers{{corners[i].x, corners[i].y}, 2});
    return array_of(std::move(array));
}

}  // namespace candelabra
