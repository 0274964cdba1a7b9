// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/model_block.h"

#include "appearance/materials.h"
#include "appearance/textures.h"
#include "objects/objects.h"
#include "text/message.h"

namespace candelabra {

namespace {

constexpr std::string_view replace_word = "replace";
constexpr std::string_view replace_help = "replace \"Glass\" texture { pigment { rgb 1 } }";

}  // namespace

bool ReplacementReader::take(const Element& element) {
    if (stage_ == Stage::none) {
        if (element.kind != Element::Kind::word || block_.spelling(element.word) != replace_word)
            return false;
        stage_ = Stage::name;
        return true;
    }
    if (stage_ == Stage::look) return take_own(element);
    const std::string* const name =
        element.kind == Element::Kind::value ? element.value.text() : nullptr;
    if (!name) return false;
    name_ = *name;
    stage_ = Stage::look;
    return true;
}

/// The object; null if the element is none, or after a diagnostic.
ObjectHandle ReplacementReader::object_of(const Element& element) {
    if (element.kind == Element::Kind::value) return element.value.handle<Object>();
    if (!block_.makes_object(element)) return nullptr;
    ObjectHandle made = read_object(block_.binder, element);
    block_.broken |= !made;
    return made;
}

std::optional<ImportedLook> ReplacementReader::look_of(const Element& element) {
    ImportedLook look;
    if (element.kind == Element::Kind::value) {
        look.texture = element.value.handle<Texture>();
        const auto material = element.value.handle<DeclaredMaterial>();
        if (material) look = {material->texture, material->interior};
        return look.texture || material ? std::optional(look) : std::nullopt;
    }
    if (element.kind != Element::Kind::block) return std::nullopt;
    if (element.word == "texture"_word) {
        look.texture = read_whole_texture(block_.binder, element);
        block_.broken |= !look.texture;
        return look;
    }
    if (element.word != "material"_word) return std::nullopt;
    DeclaredMaterial material;
    block_.broken |= !read_material(block_.binder, element, material);
    return ImportedLook{material.texture, material.interior};
}

bool ReplacementReader::take_own(const Element& element) {
    if (ObjectHandle own = object_of(element)) {
        made_.objects[name_] = std::move(own);
    } else {
        std::optional<ImportedLook> look = look_of(element);
        if (!look && !block_.broken) return false;
        if (look) made_.looks[name_] = std::move(*look);
    }
    stage_ = Stage::none;
    return true;
}

void ReplacementReader::finish() {
    if (stage_ == Stage::none || block_.broken) return;
    block_.report(error(Fault::missing, block_.span,
                        stage_ == Stage::name
                            ? "`replace` needs the name of a material or a part of the model"
                            : "`replace` needs a texture, a material or an object behind the "
                              "name")
                      .with_help(std::string(replace_help)));
}

std::shared_ptr<ImportedContent> model_content(OpenBlock& block, const ModelSettings& settings) {
    if (settings.file.empty()) {
        block.report(error(Fault::missing, block.span, "`model` needs a file")
                         .with_help("model { file \"street.glb\" }"));
        return nullptr;
    }
    auto content = imported_content(block, settings.file);
    block.broken |= !content;
    return content;
}

ObjectHandle model_object(OpenBlock& block, const ModelSettings& settings,
                          const Replacements& replaced) {
    const auto content = model_content(block, settings);
    if (!content) return nullptr;
    ObjectHandle& known = content->objects[settings.part];
    if (known && replaced.empty()) return known;
    ObjectHandle made = imported_object(block, *content, settings.part, replaced);
    if (replaced.empty()) known = made;
    return made;
}

}  // namespace candelabra
