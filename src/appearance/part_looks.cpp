// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/part_looks.h"

#include "appearance/normals.h"
#include "appearance/texture_list.h"

#include <algorithm>

namespace candelabra {

void PartTextureReader::begin(OpenBlock& part) {
    part_ = &part;
    draft_ = TextureDraft(part.binder.default_texture);
    corners_.clear();
    given_ = false;
}

bool PartTextureReader::take(const Element& element) {
    OpenBlock& part = *part_;
    bool good = true;
    if (element.word == "texture_list"_word) {
        auto list = read_texture_list(part, element, TextureCount::three);
        if (list) corners_ = std::move(*list);
        return true;
    }
    if (element.word == "texture"_word)
        good = read_texture(part.binder, element, draft_);
    else if (element.word == "pigment"_word)
        good = read_pigment(part.binder, element, draft_.edit().pigment);
    else if (element.word == "normal"_word)
        good = read_normal(part.binder, element, draft_.edit().normal);
    else if (element.word == "finish"_word)
        good = read_finish(part.binder, element, draft_.edit().finish);
    else
        return false;
    given_ = true;
    part.broken |= !good;
    return true;
}

void PartTextureReader::move(const Transform& transform) {
    if (given_ && draft_.movable()) draft_.edit() = transformed(draft_.now(), transform);
}

void PartTextureReader::number(int* looks, int count) {
    const int one = given_ ? number_of(draft_.shared(part_->binder.textures)) : -1;
    for (int i = 0; i < count; ++i)
        looks[i] = corners_.empty() ? one : number_of(corners_[static_cast<std::size_t>(i)]);
}

int PartTextureReader::number_of(const Handle<Texture>& texture) {
    const auto found = std::ranges::find(list_, texture);
    const auto place = found - list_.begin();
    if (found == list_.end()) list_.push_back(texture);
    return static_cast<int>(place);
}

}  // namespace candelabra
