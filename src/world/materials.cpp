// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/materials.h"

#include "surface/quality.h"
#include "world/radiance.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Returns the interior of a solid with that texture. As in POV-Ray, the finish of a plain texture
/// overrides the interior, and an interior without an index of refraction has no dispersion.
Handle<Interior> settled(const Handle<Interior>& interior, const Texture& texture) {
    const bool bends = !texture.choice && texture.finish.ior != 0;
    const bool focuses = !texture.choice && texture.finish.caustics >= 0;
    if (!bends && !focuses && (!interior || interior->ior != 0)) return interior;
    Interior result = interior ? *interior : Interior();
    if (bends || result.ior == 0) {
        result.ior = bends ? texture.finish.ior : 1;
        result.dispersion = 1;
    }
    if (focuses) result.caustics = texture.finish.caustics / caustics_power;
    return make_handle<Interior>(result);
}

}  // namespace

std::size_t Materials::Hash::operator()(const Key& key) const {
    const std::hash<const void*> of;
    const int switches = key.no_shadow | key.no_image << 1 | key.no_reflection << 2 |
                         key.double_illuminate << 3 | key.hollow << 4 | key.no_luminaire << 5 |
                         key.no_radiosity << 6;
    return of(key.texture) * 31 + of(key.interior) * 16 + of(key.inner) * 7 + of(key.lamp) * 127 +
           key.light_group * 64 + std::size_t{key.shared_interior} * 4096 +
           std::size_t{key.photons.target} * 8192 + static_cast<std::size_t>(switches);
}

const Handle<Texture>& Materials::world_texture(const Handle<Texture>& texture,
                                                const Handle<Transform>& transform, bool uv) {
    if (!(transform || uv) || texture->plain()) return texture;
    auto& known = textures_[TextureKey(texture.get(), transform.get(), uv)];
    if (!known) {
        Texture made = uv ? uv_mapped(*texture) : *texture;
        if (transform) made = transformed(std::move(made), *transform);
        known = make_handle<Texture>(std::move(made));
        kept_textures_.push_back(texture);
        if (transform) kept_transforms_.push_back(transform);
    }
    return known;
}

const Handle<Interior>& Materials::world_interior(const Handle<Interior>& interior,
                                                  const Handle<Transform>& transform) {
    if (!transform || !moves(*interior)) return interior;
    auto& known = interiors_[std::pair(interior.get(), transform.get())];
    if (!known) {
        known = make_handle<Interior>(transformed(*interior, *transform));
        kept_interiors_.push_back(interior);
        kept_transforms_.push_back(transform);
    }
    return known;
}

std::uint32_t Materials::index(const Inherited& look) {
    const Key key{look.texture->get(),
                  look.inner ? look.inner->get() : nullptr,
                  look.interior ? look.interior->get() : nullptr,
                  look.light_group,
                  look.shared_interior,
                  look.no_shadow,
                  look.no_image,
                  look.no_reflection,
                  look.no_radiosity,
                  look.no_luminaire,
                  look.double_illuminate,
                  look.hollow,
                  look.photons,
                  look.lamp_data ? look.lamp_data->get() : nullptr,
                  look.all_of_lamp};
    if (last_key_ != key) {
        last_key_ = key;
        const auto next = static_cast<std::uint32_t>(world_.appearance.materials.size());
        const auto [found, added] = indices_.try_emplace(key, next);
        if (added) add(look);
        last_ = found->second;
    }
    return last_;
}

/// Returns the texture as rendered: with emission instead of ambient if the settings ask for that.
Handle<Texture> Materials::lit(const Handle<Texture>& texture, const Inherited& look) const {
    const GlobalSettings& settings = world_.rules.settings;
    Handle<Texture> result = settings.ambient_luminaires
                                 ? ambient_as_emission(texture, settings.ambient_light)
                                 : texture;
    if (look.lamp_data) result = as_lamp(result, **look.lamp_data, look.all_of_lamp);
    return simplified(result, world_.rules.quality);
}

void Materials::add(const Inherited& look) {
    Material material;
    material.texture = lit(*look.texture, look);
    const Texture& texture = *material.texture;
    if (look.inner) material.inner = lit(*look.inner, look);
    material.interior = settled(look.interior ? *look.interior : nullptr, texture);
    if (material.interior && !material.interior->media.empty()) {
        if (world_.rules.quality < quality_full) material.interior.edit().media.clear();
        if (material.interior->luminaire && look.hollow && !look.no_luminaire &&
            !std::isinf(world_.rules.settings.luminaires_above))
            for (Media& media : material.interior.edit().media)
                media.luminaire = media.emission != Rgb(0);
        const auto repeats = [](const Media& media) { return media.scattering.multiple; };
        if (world_.facts.keeps_energy && std::ranges::any_of(material.interior->media, repeats))
            for (Media& media : material.interior.edit().media)
                media.scattering.physical = repeats(media);
        world_.appearance.any_media |= !material.interior->media.empty();
        world_.appearance.any_drawn_media |=
            std::ranges::any_of(material.interior->media, &Media::drawn);
    }
    material.transparent = transparent(texture) || (material.inner && transparent(*material.inner));
    material.keeps_energy =
        material.transparent &&
        (takes_from_behind(texture) || (material.inner && takes_from_behind(*material.inner)));
    material.light_group = look.light_group;
    material.shared_interior = look.shared_interior;
    material.no_shadow = look.no_shadow || world_.rules.quality < quality_shadows;
    material.no_image = look.no_image;
    material.no_reflection = look.no_reflection;
    material.no_radiosity = look.no_radiosity;
    material.double_illuminate = look.double_illuminate;
    material.hollow = look.hollow;
    material.photons = look.photons;
    Nesting patterns = nesting(texture);
    if (material.inner) patterns.include(nesting(*material.inner));
    material.uv = patterns.uv;
    material.by_view = patterns.by_view;
    material.by_surface = patterns.by_surface;
    material.by_axes = patterns.by_axes;
    material.solid = static_cast<std::uint32_t>(world_.appearance.materials.size());
    world_.appearance.any_transparent |= material.transparent;
    world_.appearance.any_clear |= material.transparent || material.no_shadow;
    world_.appearance.any_keeps_energy |= material.keeps_energy;
    world_.appearance.any_left_out |= look.no_image || look.no_reflection || look.no_radiosity;
    world_.appearance.any_scattering |= scatters(texture);
    double emission = max_component(lighting_emission(texture));
    if (material.inner)
        emission = std::max(emission, max_component(lighting_emission(*material.inner)));
    // The radiance of a lamp whose flux is stated is not known yet.
    Handle<LampData> lamp = look.lamp_data ? *look.lamp_data : stated_lamp(texture);
    const bool stated = lamp && lamp->has_flux();
    const double above = world_.rules.settings.luminaires_above;
    const bool glows = world_.rules.quality >= quality_shadows && !look.no_luminaire &&
                       (stated ? emission > 0 && !std::isinf(above) : emission > above);
    glows_.push_back(glows);
    emits_.push_back(emission > 0 || greatest_emission(material) != Rgb(0));
    lamps_.push_back(std::move(lamp));
    material.other_light = material.transparent || material.by_view || look.double_illuminate ||
                           (emission != 0 && !glows) || has_other_light(texture) ||
                           (material.inner && has_other_light(*material.inner));
    world_.appearance.any_other_light |= material.other_light;
    material.lit_from_behind = shows_light_from_behind(texture) ||
                               (material.inner && shows_light_from_behind(*material.inner));
    world_.appearance.materials.push_back(std::move(material));
}

std::uint32_t Materials::own(std::uint32_t material) {
    const auto number = static_cast<std::uint32_t>(world_.appearance.materials.size());
    world_.appearance.materials.push_back(Material(world_.appearance.materials[material]));
    world_.appearance.materials.back().solid = number;
    glows_.push_back(glows_[material]);
    emits_.push_back(emits_[material]);
    lamps_.push_back(lamps_[material]);
    return number;
}

std::vector<std::uint32_t> Materials::of_faces(const Object& mesh, const Inherited& look,
                                               const Handle<Transform>& outside) {
    std::vector<std::uint32_t> result = {own(index(look))};
    Inherited part = look;
    for (const Handle<Texture>& texture : mesh.part_textures->list) {
        part.texture = &world_texture(texture, outside, look.uv);
        result.push_back(own(index(part)));
        world_.appearance.materials[result.back()].solid = result.front();
    }
    return result;
}

/// Adds the attributes of a part's material to the material of the whole.
void Materials::include(std::uint32_t material, std::uint32_t part) {
    Material& whole = world_.appearance.materials[material];
    const Material& other = world_.appearance.materials[part];
    whole.transparent |= other.transparent;
    whole.keeps_energy |= other.keeps_energy;
    whole.uv |= other.uv;
    whole.by_view |= other.by_view;
    whole.by_surface |= other.by_surface;
    whole.by_axes |= other.by_axes;
    whole.other_light |= other.other_light;
    whole.lit_from_behind |= other.lit_from_behind;
    glows_[material] = glows_[material] || glows_[part];
    emits_[material] = emits_[material] || emits_[part];
    if (!lamps_[material]) lamps_[material] = lamps_[part];
}

std::uint32_t Materials::of_face(const std::vector<std::uint32_t>& materials, const Face& looks) {
    const auto part = [&](std::size_t i) {
        return materials[static_cast<std::size_t>(looks[i] + 1)];
    };
    if (looks[0] == looks[1] && looks[1] == looks[2]) return part(0);
    const auto [found, added] = blended_.try_emplace({materials.front(), looks}, 0);
    if (!added) return found->second;
    const std::uint32_t mixed = found->second = own(part(0));
    world_.appearance.materials[mixed].solid = materials.front();
    world_.appearance.materials[mixed].texture2 = world_.appearance.materials[part(1)].texture;
    world_.appearance.materials[mixed].texture3 = world_.appearance.materials[part(2)].texture;
    include(mixed, part(1));
    include(mixed, part(2));
    return mixed;
}

std::uint32_t Materials::of_parts(const Object& object, const Inherited& look,
                                  const Handle<Transform>& outside, TextureList& list) {
    const std::uint32_t result = own(index(look));
    Inherited part = look;
    for (const Handle<Texture>& texture : object.part_textures->list) {
        list.push_back(lit(world_texture(texture, outside, look.uv), look));
        part.texture = &list.back();
        include(result, index(part));
    }
    return result;
}

}  // namespace candelabra
