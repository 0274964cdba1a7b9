// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/lights.h"

#include "evaluate/transforms.h"

PlacedLight moved(PlacedLight placed, const Transform& transform) {
    std::visit([&](auto& light) { light.location = transform.point(light.location); },
               placed.light);
    return placed;
}

std::optional<PlacedLight> read_light(Binder& binder, const Element& element) {
    OpenBlock block(binder, "light_source", element.word_span);
    PlacedLight placed{Kinds<Light>::make(0), element.span};
    block.item = Kinds<Light>::infos[0];
    ItemReader fields(block, *block.item, Kinds<Light>::address(placed.light));
    auto declared = named<PlacedLight>(block, [&](const Handle<PlacedLight>& other) {
        placed.light = other->light;
        fields.rebind(*Kinds<Light>::infos[placed.light.index()],
                      Kinds<Light>::address(placed.light));
        fields.complete();
    });
    const auto apply = [&](const Transform& transform) {
        placed = moved(std::move(placed), transform);
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, fields, moves);
    if (block.broken) return std::nullopt;
    return placed;
}
