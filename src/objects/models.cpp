// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/models.h"

#include "reading/convert.h"
#include "shape/double_cone.h"

namespace candelabra {

namespace {

/// Longer rows would save little and need twice their memory while they grow.
constexpr std::size_t max_spheres = 2048;

/// Sets the leading values of a shape; returns false if one of them is invalid.
bool set_values(void* shape, const ItemInfo& item, const Variation& variation) {
    for (std::size_t i = 0; i < variation.count; ++i)
        if (!set_fitting(item, shape, i, variation.values[i])) return false;
    return true;
}

bool alike(const Object& row, const Object& model, const Handle<Texture>& texture) {
    return row.texture == texture && row.transform == model.transform &&
           row.interior == model.interior && row.part_textures == model.part_textures &&
           row.switches() == model.switches();
}

void add(const RowEnd& end, const Object& model, const Sphere& sphere, Span span) {
    const Handle<Texture>& texture = model.texture ? model.texture : end.texture;
    ObjectHandle* last = end.list.empty() ? nullptr : &end.list.back();
    const SphereRow* row = last && last->alone() ? std::get_if<SphereRow>(&(*last)->form) : nullptr;
    if (!row || row->spheres.size() >= max_spheres || !alike(**last, model, texture)) {
        last = &end.list.emplace_back(make_handle<Object>(model));
        last->edit().form = SphereRow{};
        last->edit().texture = texture;
        last->edit().span = span;
    }
    auto& open = std::get<SphereRow>(last->edit().form);
    open.spheres.push_back(sphere);
    open.spans.push_back(span);
    last->edit().parts = static_cast<std::uint32_t>(open.spheres.size());
}

}  // namespace

ObjectHandle like(Binder& binder, const Object& model, const ItemInfo* item,
                  const Variable& variable, const Variation& variation) {
    ObjectHandle made = binder.pool.make(model);
    Object& object = made.edit();
    if (item) {
        Shape& shape = std::get<Shape>(object.form);
        const auto* cone = std::get_if<Cone>(&shape);
        if (!set_values(Kinds<Shape>::address(shape), *item, variation) ||
            !problem(shape).empty() || !vanishes(shape).empty() || (cone && is_crossed(*cone)))
            return nullptr;
    }
    if (variable.coloured()) {
        Texture texture = *model.texture;
        texture.pigment.colour = variation.colour;
        object.texture = binder.textures.share(std::move(texture), binder.texture_pool);
    }
    if (variation.movement) object.transform = binder.transform_pool.make(*variation.movement);
    return made;
}

bool joins(const RowEnd& end, const Object& model, const Variation& variation, Span span) {
    const auto& shape = std::get<Shape>(model.form);
    // Inverse and clipped spheres are solids of their own.
    if (!std::holds_alternative<Sphere>(shape) || model.clipping || model.inverse) return false;
    Sphere sphere;
    if (!set_values(&sphere, Sphere::vocabulary, variation) || !vanishes(sphere).empty())
        return false;
    add(end, model, sphere, span);
    return true;
}

}  // namespace candelabra
