// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/models.h"

#include "reading/convert.h"
#include "shape/double_cone.h"

#include <optional>
#include <utility>

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

/// Whether the objects differ only in shape and place.
bool look_alike(const Object& row, const Object& model, const Handle<Texture>& texture) {
    return row.texture == texture && row.interior == model.interior &&
           row.part_textures == model.part_textures && row.switches() == model.switches();
}

bool alike(const Object& row, const Object& model, const Handle<Texture>& texture) {
    return row.transform == model.transform && look_alike(row, model, texture);
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

/// The sphere in its place, if it looks alike everywhere and was only moved there.
std::optional<Sphere> moved_sphere(const Object& object) {
    const auto* shape = std::get_if<Shape>(&object.form);
    const auto* sphere = shape ? std::get_if<Sphere>(shape) : nullptr;
    const bool solid = object.clipping || object.inverse || object.interior;
    if (!sphere || solid || object.part_textures || object.lamp || object.photons ||
        object.uv_mapping || !object.texture || !object.texture->plain() || !object.transform ||
        object.transform->forward().rows != Affine().rows)
        return {};
    return Sphere{object.transform->point(sphere->centre), sphere->radius};
}

/// The row that such a sphere may join; null if there is none. Makes one of the last object, if
/// that is another sphere of the same statement.
Object* row_for(const Object& sphere, std::vector<ObjectHandle>& list) {
    if (list.empty() || !list.back().alone() || list.back()->span != sphere.span) return nullptr;
    const Object& last = *list.back();
    if (!look_alike(last, sphere, sphere.texture)) return nullptr;
    if (const auto* row = std::get_if<SphereRow>(&last.form)) {
        const bool fits = !last.transform && row->spheres.size() < max_spheres;
        return fits ? &list.back().edit() : nullptr;
    }
    const std::optional<Sphere> first = moved_sphere(last);
    if (!first) return nullptr;
    // In a place of its own: that of the sphere is one of many, which are given back together.
    ObjectHandle made = make_handle<Object>(last);
    made.edit().form = SphereRow{{*first}, {last.span}};
    made.edit().transform = nullptr;
    list.back() = std::move(made);
    return &list.back().edit();
}

}  // namespace

bool joins(std::vector<ObjectHandle>& list, const Object& object) {
    const std::optional<Sphere> sphere = moved_sphere(object);
    Object* const whole = sphere ? row_for(object, list) : nullptr;
    if (!whole) return false;
    auto& row = std::get<SphereRow>(whole->form);
    row.spheres.push_back(*sphere);
    row.spans.push_back(object.span);
    whole->parts = static_cast<std::uint32_t>(row.spheres.size());
    return true;
}

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
