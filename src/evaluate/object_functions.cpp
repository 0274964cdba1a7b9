// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/object_functions.h"

#include "solid/extent.h"

Value inside_object(FunctionCall& call) {
    const ObjectHandle object = call.object(0);
    const Vec3 point = call.vector(1);
    if (call.failed()) return Absence::broken;
    if (!call.world.solids.solid(object))
        return call.fail(Fault::domain, 0,
                         "this object has no inside: it is, or holds, a triangle, polygon, patch, "
                         "or a mesh without inside_vector");
    return call.world.solids.inside(object, point) ? 1.0 : 0.0;
}

Value first_hit(FunctionCall& call) {
    const ObjectHandle object = call.object(0);
    const Vec3 from = call.vector(1), direction = call.vector(2);
    if (call.failed()) return Absence::broken;
    if (direction == Vec3(0)) return call.fail(Fault::domain, 2, "the zero vector is no direction");
    const auto hit = call.world.solids.trace(object, from, direction);
    if (call.count() == 4) {
        call.numbers(3);
        call.give(Numbers::vector(hit ? hit->normal : Vec3(0)));
    }
    return Numbers::vector(hit ? hit->position : Vec3(0));
}

Value lower_extent(FunctionCall& call) {
    const ObjectHandle object = call.object(0);
    return object ? Value(Numbers::vector(extent(*object).low)) : Value(Absence::broken);
}

Value upper_extent(FunctionCall& call) {
    const ObjectHandle object = call.object(0);
    return object ? Value(Numbers::vector(extent(*object).high)) : Value(Absence::broken);
}
