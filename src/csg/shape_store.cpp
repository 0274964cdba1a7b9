// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/shape_store.h"

#include "base/elementary.h"

#include <cmath>

namespace candelabra {

namespace {

/// The address of the content that copies of the shape share, if it has to be built; null
/// otherwise.
const void* shared_content(const Shape& shape) {
    return std::visit(
        [](const auto& stored) -> const void* {
            using Stored = std::remove_cvref_t<decltype(stored)>;
            if constexpr (Prepared<ContentOf<Stored>>)
                return &*stored;
            else
                return nullptr;
        },
        shape);
}

/// The largest scale of a place along an axis, rounded up to a step, so that places share patches.
double stepped_scale(const Transform& place) {
    constexpr double steps_of_octave = 8;
    double largest = 0;
    for (const Vec3& row : place.forward().rows) largest = std::fmax(largest, length(row));
    const double step = std::ceil(steps_of_octave * math::log2(largest) - 1e-9);
    return math::exp2(step / steps_of_octave);
}

/// A height field for a place that stretches it.
BuiltHeightField stretched(BuiltHeightField field, const Handle<Transform>& place) {
    field.stretched = place;
    return field;
}

/// A patch for a place that mirrors it: as in POV-Ray, its points are mirrored before its normals
/// are computed, so that its outer side changes.
BuiltBicubicPatch mirrored(BuiltBicubicPatch patch) {
    for (BuiltBicubicPatch::Facet& facet : patch.facets)
        for (Vec3& normal : facet.normals) normal = -normal;
    return patch;
}

}  // namespace

BuiltShape ShapeStore::built(const Shape& shape) {
    const void* content = shared_content(shape);
    if (!content) return candelabra::built(shape, index_);
    const auto found = known_.find(content);
    if (found != known_.end()) return found->second.built;
    return known_.emplace(content, Known{shape, candelabra::built(shape, index_)})
        .first->second.built;
}

BuiltShape ShapeStore::divided(const Shape& shape, const Transform& place) {
    const auto* patch = std::get_if<Shared<BicubicPatch>>(&shape);
    const double scale = patch && (*patch)->flatness > 0 ? stepped_scale(place) : 1;
    if (scale == 1) return built(shape);
    const auto [found, added] = divided_.try_emplace({&**patch, scale});
    if (added) {
        BicubicPatch flatter = **patch;
        flatter.flatness /= scale;
        found->second = {shape, candelabra::built(Shared(std::move(flatter)), index_)};
    }
    return found->second.built;
}

BuiltShape ShapeStore::built(const Shape& shape, const Handle<Transform>& place) {
    if (!place) return built(shape);
    BuiltShape result = divided(shape, *place);
    const auto made = [&](const auto& shared, auto make) {
        const auto [found, added] = placed_.try_emplace({&*shared, place.get()});
        if (added) found->second = {place, Shared(make(*shared))};
        return found->second.built;
    };
    const auto* field = std::get_if<Shared<BuiltHeightField>>(&result);
    if (field && (*field)->smooth && place->uniform_scale() == 0)
        return made(*field, [&](const auto& each) { return stretched(each, place); });
    const auto* patch = std::get_if<Shared<BuiltBicubicPatch>>(&result);
    if (patch && place->determinant() < 0) return made(*patch, mirrored);
    return result;
}

}  // namespace candelabra
