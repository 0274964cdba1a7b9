// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/imported_looks.h"

#include "base/colour.h"
#include "base/gamma.h"
#include "base/long_work.h"
#include "surface/default_maps.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Colours are not below this where a surface shines: its light is the colour times the emission.
constexpr double least_colour = 1e-4;

/// Whether what has this opacity is there, where a material is cut out by its alpha.
bool is_there(double opacity, const ImportedMaterial& material) {
    return opacity * std::clamp(material.opacity, 0.0, 1.0) >= material.cutoff;
}

constexpr int bilinear = 2;

/// The least alpha of texels that are there, where a material is cut out.
double cutoff_of_texels(const ImportedMaterial& material) {
    constexpr double never = 2;
    const double opacity = std::clamp(material.opacity, 0.0, 1.0);
    if (material.cutoff <= 0) return 0;
    return opacity > 0 ? material.cutoff / opacity : never;
}

PatternUse use_of(Pattern pattern) {
    PatternUse use{std::move(pattern), {}, {}, {}};
    name_pattern(use.pattern, use.modifiers, use.wave);
    return use;
}

/// The means of the green and of the blue values.
Vec2 means(const Texels& texels) {
    if (texels.values.empty() || texels.channels < 3) return Vec2(1);
    Vec2 sum(0);
    for (std::size_t i = 0; i + 3 <= texels.values.size(); i += 3)
        sum += Vec2(texels.values[i + 1], texels.values[i + 2]);
    return sum / (static_cast<double>(texels.values.size()) / 3);
}

}  // namespace

Rgb ImportedLooks::in_scene(const std::array<double, 3>& stated) const {
    const double gamma = block_.binder.working_gamma.value_or(1);
    const auto channel = [&](double value) {
        return from_linear(model_.encoded ? srgb_decode(value) : value, gamma);
    };
    return {channel(stated[0]), channel(stated[1]), channel(stated[2])};
}

std::optional<Found> ImportedLooks::find(const ImportedFile& picture, int number) {
    if (picture.file.empty()) return Found{message(path_, ", picture ", number), picture.bytes};
    const Evaluator& evaluator = block_.binder.evaluator;
    const std::string name = name_beside(picture.file);
    auto found = name.empty() ? std::nullopt
                              : evaluator.loader().load(name, directory_of(path_), FileKind::data);
    if (!found)
        block_.report(warning(Fault::io, block_.file_place(),
                              message("the picture `", printable(picture.file),
                                      "` of the model is not beside it, so it is left out"))
                          .with_help(message("put `", printable(name), "` beside the model")));
    return found;
}

const ImportedLooks::Shown& ImportedLooks::shown(int picture, TexelCoding::Decode decode) {
    const auto [entry, added] = pictures_.try_emplace({picture, decode});
    Shown& known = entry->second;
    if (!added) return known;
    Binder& binder = block_.binder;
    const std::optional<Found> file =
        find(model_.pictures[static_cast<std::size_t>(picture)], picture);
    if (!file) return known;
    TexelCoding coding;
    coding.decode = decode;
    coding.working_gamma = binder.working_gamma.value_or(1);
    Diagnostics problems;
    auto read = read_texels(*file, coding, problems, block_.file_place());
    if (!read) {
        const std::string why = problems.all().empty() ? "" : problems.all().front().message;
        block_.report(warning(Fault::io, block_.file_place(),
                              message("a picture of the model is left out: ", why)));
        return known;
    }
    count_long_work(static_cast<std::uint64_t>(read->width) *
                    static_cast<std::uint64_t>(read->height) / 4);
    known.texels = make_handle<Texels>(std::move(*read));
    known.file = file->path;
    if (!model_.pictures[static_cast<std::size_t>(picture)].file.empty()) return known;
    known.file = path_;
    known.number = picture;
    return known;
}

Pigment ImportedLooks::pigment(int picture, const Rgb& factor, const ImportedMaterial& material,
                               double transmit) {
    Pigment made;
    made.colour.rgb = factor;
    made.colour.transmit = transmit;
    if (picture < 0) return made;
    const Shown& known = shown(picture, TexelCoding::always);
    if (!known.texels) return made;
    ImageMap image;
    image.file = known.file;
    image.interpolate = bilinear;
    image.picture = known.number;
    image.texels = known.texels;
    image.tint = factor;
    if (material.cutoff >= 0)
        image.alpha_cutoff = cutoff_of_texels(material);
    else if (!material.uses_alpha && image.texels->transparent())
        image.alpha_cutoff = 0;
    if (transmit > 0) image.adjustments.push_back({false, -1, transmit});
    image.adjust();
    const PatternUse use = use_of(std::move(image));
    made.pattern = make_handle<PatternedPigment>(use, default_map(use.pattern));
    return made;
}

Bump ImportedLooks::bumps(const ImportedMaterial& material) {
    Bump made;
    if (material.normal_picture < 0 || material.normal_scale == 0) return made;
    const Shown& known = shown(material.normal_picture, TexelCoding::as_stored);
    if (!known.texels) return made;
    BumpMap map;
    map.file = known.file;
    map.picture = known.number;
    map.interpolate = bilinear;
    map.tangent_space = true;
    map.texels = known.texels;
    BumpSettings settings;
    settings.bump_size = material.normal_scale;
    made.pattern =
        make_handle<PatternedBump>(use_of(std::move(map)), settings, PatternedBump::Map());
    return made;
}

Finish ImportedLooks::finish(const ImportedMaterial& material) {
    Finish made;
    made.ambient = Rgb(0);
    made.diffuse = 1;
    if (!material.facets) {
        if (material.specular <= 0 || material.shininess <= 0) return made;
        made.specular = std::min(material.specular, 1.0);
        made.roughness = 1 / std::max(material.shininess, 1.0);
        return made;
    }
    Vec2 factor(1);
    if (material.facet_picture >= 0) {
        const Shown& facets = shown(material.facet_picture, TexelCoding::as_stored);
        if (facets.texels) factor = means(*facets.texels);
        ++left_out_.averaged;
    }
    made.microfacet.on = true;
    made.microfacet.roughness = std::clamp(material.roughness * factor.x, 0.0, 1.0);
    made.microfacet.metallic = std::clamp(material.metallic * factor.y, 0.0, 1.0);
    return made;
}

/// Adds light to a texture whose pigment and finish are complete.
void ImportedLooks::glow(const ImportedMaterial& material, Texture& texture) {
    const Rgb light = in_scene(material.emission);
    if (light == Rgb(0)) return;
    Rgb& colour = texture.pigment.colour.rgb;
    if (material.emission_picture < 0 && !texture.pigment.pattern) {
        for (int i = 0; i < 3; ++i) {
            if (light[i] > 0) colour[i] = std::max(colour[i], least_colour);
            texture.finish.emission[i] = light[i] > 0 ? light[i] / colour[i] : 0;
        }
        return;
    }
    // The light of a texture is that of its pigment, so the one picture shows both.
    if (material.emission_picture != material.picture) {
        if (material.picture >= 0) ++left_out_.dim;
        texture.pigment = pigment(material.emission_picture, Rgb(1), material, 0);
        texture.finish.diffuse = 0;
        texture.finish.microfacet.on = false;
    }
    texture.finish.emission = light;
}

ImportedLook ImportedLooks::look(const ImportedMaterial& material) {
    if (!material.stated) return {};
    const bool cut_picture = material.cutoff >= 0 && material.picture >= 0;
    const double opacity = cut_picture            ? 1  // each texel is cut by itself
                           : material.cutoff >= 0 ? (is_there(1, material) ? 1.0 : 0.0)
                                                  : std::clamp(material.opacity, 0.0, 1.0);
    const double through = std::clamp(material.transmission, 0.0, 1.0);
    Texture texture;
    Rgb colour = max(in_scene(material.colour), Rgb(0));
    // Files of Phong materials often leave the colour black where there is a picture.
    if (!material.facets && material.picture >= 0 && colour == Rgb(0)) colour = Rgb(1);
    texture.pigment = pigment(material.picture, colour, material, 1 - opacity);
    if (!texture.pigment.pattern) texture.pigment.colour.filter = opacity * through;
    texture.finish = finish(material);
    glow(material, texture);
    texture.normal = bumps(material);
    if (material.heights) ++left_out_.heights;
    ImportedLook made;
    const bool mapped = texture.pigment.pattern || texture.normal.pattern;
    made.texture =
        make_handle<Texture>(mapped ? uv_mapped(std::move(texture)) : std::move(texture));
    constexpr double usual_ior = 1.5;
    const double ior = material.ior > 0 ? material.ior : usual_ior;
    if (through > 0 || (!material.facets && opacity < 1 && material.ior > 1)) {
        Interior inside;
        inside.ior = ior;
        made.interior = make_handle<Interior>(inside);
    }
    return made;
}

}  // namespace candelabra
