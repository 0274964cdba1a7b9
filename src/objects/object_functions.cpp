// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/object_functions.h"

#include "base/order.h"
#include "csg/extent.h"
#include "objects/modelling_functions.h"
#include "pattern/pattern.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"

#include <algorithm>
#include <array>
#include <optional>

namespace candelabra {

Value inside_object(FunctionCall& call) {
    const Handle<Object> object = call.object(0);
    const Vec3 point = call.vector(1);
    if (call.failed()) return Absence::broken;
    std::uint64_t counted = 0;  // counted by the call already
    const std::optional<bool> answer = call.world.objects->inside(object, point, counted);
    if (!answer)
        return call.fail(Fault::domain, 0,
                         "this object has no inside: it is, or holds, a triangle, polygon, patch, "
                         "or a mesh without inside_vector");
    return *answer ? 1.0 : 0.0;
}

Value first_hit(FunctionCall& call) {
    const Handle<Object> object = call.object(0);
    const Vec3 from = call.vector(1), direction = call.vector(2);
    if (call.failed()) return Absence::broken;
    if (direction == Vec3(0)) return call.fail(Fault::domain, 2, "the zero vector is no direction");
    std::uint64_t counted = 0;  // counted by the call already
    const auto hit = call.world.objects->first_hit(object, from, direction, counted);
    if (call.count() == 4) {
        call.numbers(3);
        call.give(Numbers::vector(hit ? hit->normal : Vec3(0)));
    }
    return Numbers::vector(hit ? hit->position : Vec3(0));
}

Value lower_extent(FunctionCall& call) {
    const Handle<Object> object = call.object(0);
    return object ? Value(Numbers::vector(extent(*object).low)) : Value(Absence::broken);
}

/// The width and height in pixels of the picture of a pigment or a normal; nothing for others.
std::optional<Vec3> picture_size(const Value& value) {
    const auto pigment = value.handle<Pigment>();
    const auto bump = value.handle<Bump>();
    const Pattern* const pattern = pigment && pigment->pattern ? &pigment->pattern->use.pattern
                                   : bump && bump->pattern     ? &bump->pattern->use.pattern
                                                               : nullptr;
    const PictureMap* const picture = pattern ? picture_of(*pattern) : nullptr;
    if (!picture || !picture->texels) return std::nullopt;
    return Vec3(picture->texels->width, picture->texels->height, 0);
}

Value upper_extent(FunctionCall& call) {
    if (const auto size = picture_size(call.value(0))) return Numbers::vector(*size);
    const Handle<Object> object = call.object(0);
    return object ? Value(Numbers::vector(extent(*object).high)) : Value(Absence::broken);
}

namespace {

using OfObject = FunctionInfo::General;

constexpr auto functions_of_objects = std::array{
    FunctionInfo{"delaunay", 1, 1, "points",
                 "the triangles between points <x, y> of an array: an array of n by 3 numbers of "
                 "points, from 0",
                 OfObject(delaunay),
                 "#declare Places = array[3] { <0, 0>, <2, 0>, <1, 2> }; #declare Triangles = "
                 "delaunay(Places);"},
    FunctionInfo{"inside", 2, 2, "object, point", "whether the point is inside",
                 OfObject(inside_object),
                 "#declare Ball = sphere { 0, 1 } #declare In = inside(Ball, y/2);"},
    FunctionInfo{
        "max_extent", 1, 1, "object",
        "upper corner of the bounding box; of a pigment or normal, the size of its picture "
        "in pixels",
        OfObject(upper_extent),
        "#declare Ball = sphere { 0, 1 } #declare High = max_extent(Ball);"},
    FunctionInfo{"min_extent", 1, 1, "object", "lower corner of the bounding box",
                 OfObject(lower_extent),
                 "#declare Ball = sphere { 0, 1 } #declare Low = min_extent(Ball);"},
    FunctionInfo{"scatter", 2, 3, "object, distance[, seed]",
                 "places all over a surface, no two nearer than the distance: an array of n by 2, "
                 "a point and the normal there",
                 OfObject(scatter),
                 "#declare Ball = sphere { 0, 1 } #declare Places = scatter(Ball, 0.3);"},
    FunctionInfo{"trace", 3, 4, "object, from, direction[, normal]", "first hit of a ray",
                 OfObject(first_hit),
                 "#declare Ball = sphere { 0, 1 } #declare Side = <0, 0, 0>; #declare Hit = "
                 "trace(Ball, -3*z, z, Side);"},
    FunctionInfo{"voronoi_cell", 4, 4, "points, i, low, high",
                 "what is nearer to point i <x, y> of an array than to the others, within a "
                 "rectangle: an array of its corners",
                 OfObject(voronoi),
                 "#declare Places = array[3] { <0, 0>, <2, 0>, <1, 2> }; #declare Cell = "
                 "voronoi_cell(Places, 0, <-1, -1>, <3, 3>);"},
};

}  // namespace

std::span<const FunctionInfo> object_functions() { return functions_of_objects; }

std::vector<FunctionInfo> all_functions() {
    std::vector<FunctionInfo> result(functions().begin(), functions().end());
    result.insert(result.end(), functions_of_objects.begin(), functions_of_objects.end());
    sort_stably(result, {}, &FunctionInfo::name);
    return result;
}

}  // namespace candelabra
