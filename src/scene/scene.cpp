// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Switches::vocabulary = described<Switches>([] {
    using F = Field<Switches>;
    return schema<Switches>(
        "object",
        {"What can be switched on an object.", "sphere { y, 1 no_shadow }",
         "sphere { y, 1 no_image }", "sphere { y, 1 no_reflection no_radiosity }",
         "sphere { y, 0.2 finish { emission 3 } no_luminaire }",
         "sphere { y, 1 hollow pigment { rgbt 0.9 } interior { media { emission 0.3 } } }",
         "difference { box { <-1, 0, -1>, <1, 1.5, 1> } plane { y, 1 inverse } }",
         "triangle { 0, 2*x, 2*y double_illuminate }",
         "sphere { y, 1 pigment { checker scale 0.1 } uv_mapping }",
         "object { sphere { y, 1 } hollow }"},
        F{"no_shadow", &Switches::no_shadow, flag, "casts no shadow"},
        F{"no_image", &Switches::no_image, flag, "is not seen by the camera"},
        F{"no_reflection", &Switches::no_reflection, flag, "is not seen in reflections"},
        F{"no_radiosity", &Switches::no_radiosity, flag, "reflects no light to others"},
        F{"no_luminaire", &Switches::no_luminaire, flag, "lights nothing, though it may glow"},
        F{"hollow", &Switches::hollow, flag, "is filled with what surrounds it"},
        F{"inverse", &Switches::inverse, flag, "swaps inside and outside"},
        F{"double_illuminate", &Switches::double_illuminate, flag, "is lit from both sides"},
        F{"uv_mapping", &Switches::uv_mapping, flag,
          "textures are wrapped around the shape and do not move with it"});
});

ObjectHandle transformed(ObjectHandle object, const Transform& transform) {
    if (object->texture || object->part_textures || object->clipping) {
        ObjectHandle whole = make_handle<Object>();
        whole.edit().span = object->span;
        nest(whole.edit(), *object);
        whole.edit().form.emplace<Union>().children.push_back(std::move(object));
        object = std::move(whole);
    }
    Handle<Transform>& own = object.edit().transform;
    own = make_handle<Transform>(own ? own->then(transform) : transform);
    return object;
}

PlacedLight transformed(PlacedLight placed, const Transform& transform) {
    placed.light = transformed(placed.light, transform);
    for (ObjectHandle* object : {&placed.looks_like, &placed.projected_through})
        if (*object) *object = transformed(std::move(*object), transform);
    return placed;
}

}  // namespace candelabra
