// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/features.h"

namespace candelabra::proof {

const std::vector<Factor>& factors() {
    static const std::vector<Factor> all = [] {
        std::vector<Factor> result;
        for (const auto part : {object_factors, surface_factors, light_factors, run_factors})
            for (Factor& factor : part()) result.push_back(std::move(factor));
        return result;
    }();
    return all;
}

std::vector<std::vector<std::size_t>> levels_without(unsigned traits) {
    std::vector<std::vector<std::size_t>> result;
    for (const Factor& factor : factors()) {
        std::vector<std::size_t>& levels = result.emplace_back();
        for (std::size_t i = 0; i < factor.levels.size(); ++i)
            if ((factor.levels[i].traits & traits) == 0) levels.push_back(i);
    }
    return result;
}

Draft drafted(const Row& row, std::uint64_t seed) {
    Draft draft(seed);
    for (std::size_t i = 0; i < row.size(); ++i)
        if (const Level& level = factors()[i].levels[row[i]]; level.add) level.add(draft);
    return draft;
}

Element tested_object(Draft& draft) {
    Element texture = block("texture", "", {draft.pigment, draft.finish});
    if (draft.normal) texture.inner.push_back(*draft.normal);
    Element object = needed(draft.shape);
    const std::vector<Element> textures =
        draft.structure ? draft.structure(draft, texture) : std::vector{texture};
    object.inner.insert(object.inner.end(), textures.begin(), textures.end());
    object.inner.insert(object.inner.end(), draft.modifiers.begin(), draft.modifiers.end());
    return draft.combine ? draft.combine(draft, object) : object;
}

Element ball_beside() {
    return block("sphere",
                 "<1.3, 0.35, -0.6>, 0.35 pigment { rgb <0.5, 0.7, 0.9> } finish { diffuse 0.8 }");
}

Script staged(Draft& draft) {
    Script script;
    Element object = tested_object(draft);
    object.inner.push_back(words("translate <-0.2, 0.9, 0>"));
    Element camera = needed(
        block("camera", draft.lens,
              {needed(words("location <0, 2.2, -5>")), needed(words("look_at <0, 0.7, 0>"))}));
    if (!draft.lens.starts_with("user_defined")) camera.inner.push_back(words("angle 45"));
    camera.inner.insert(camera.inner.end(), draft.camera.begin(), draft.camera.end());
    script.elements = {needed(block("#default", "finish { ambient 0 }")),
                       needed(block("global_settings", "assumed_gamma 1", draft.settings)),
                       camera,
                       block("plane", "y, 0 pigment { rgb 0.7 } finish { diffuse 0.8 }"),
                       ball_beside(),
                       object};
    script.elements.insert(script.elements.end(), draft.around.begin(), draft.around.end());
    script.lights = draft.lights;
    script.options = draft.options;
    return script;
}

std::string described_row(const Row& row) {
    std::string text;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] > 0) {
            text += text.empty() ? "" : ", ";
            text += std::string(factors()[i].name) + ": " + factors()[i].levels[row[i]].name;
        }
    return text;
}

}  // namespace candelabra::proof
