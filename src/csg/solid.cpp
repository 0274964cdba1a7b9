// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/solid.h"

#include "base/work_watch.h"
#include "csg/assemble.h"
#include "csg/traced_normal.h"

namespace candelabra {

namespace {

/// POV-Ray ignores nearer and farther hits.
constexpr Interval seen{1e-4, 1e7};

}  // namespace

const Solids::Known& Solids::known(const ObjectHandle& object) {
    if (last_ && last_->object == object) return *last_;
    auto found = known_.find(object.get());
    if (found == known_.end())
        found = known_
                    .emplace(object.get(),
                             Known{object, composite_of(*object, shapes_), has_inside(*object)})
                    .first;
    last_ = &found->second;
    return *last_;
}

const Composite& Solids::composite(const ObjectHandle& object) { return known(object).composite; }

std::optional<SurfaceHit> Solids::trace(const ObjectHandle& object, const Vec3& from,
                                        const Vec3& direction) {
    const Ray ray{from, direction / length(direction)};
    const Composite& whole = composite(object);
    const auto met = whole.first(ray, seen, [](std::uint32_t) { return true; });
    if (!met) return std::nullopt;
    return SurfaceHit{ray.at(met->t), traced_normal(whole.leaf(met->leaf), ray, *met)};
}

bool Solids::inside(const ObjectHandle& object, const Vec3& point) {
    return composite(object).inside(point);
}

bool Solids::solid(const ObjectHandle& object) { return known(object).solid; }

bool has_inside(const Object& object) {
    count_work(1);
    if (const auto* group = std::get_if<Union>(&object.form))
        return std::ranges::all_of(group->children,
                                   [](const ObjectHandle& child) { return has_inside(*child); });
    const auto* shape = std::get_if<Shape>(&object.form);
    return !shape || has_inside(*shape);
}

}  // namespace candelabra
