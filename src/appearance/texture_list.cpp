// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/texture_list.h"

#include "appearance/textures.h"
#include "reading/convert.h"
#include "text/message.h"

namespace candelabra {

namespace {

class TexturesReader : public SimpleReader {
public:
    TexturesReader(OpenBlock& block, TextureCount count) : block_(block) {
        if (count == TextureCount::three) count_ = 3;
    }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::block) return take_block(element);
        if (element.kind != Element::Kind::value) return false;
        if (const auto texture = element.value.handle<Texture>()) {
            textures.push_back(texture);
            return true;
        }
        if (count_ || !element.value.numbers()) return false;
        const auto value = converted(block_, element, FieldType::integer,
                                     {[&] { return message("the count of ", block_.quoted()); },
                                      [&] { return block_.help(); }});
        count_ = value ? std::get<double>(*value) : 0;
        return true;
    }

    void add_words(WordList& words) const { words.push_back("texture"); }

    void finish() {
        const auto found = static_cast<double>(textures.size());
        if (block_.broken || (count_ && *count_ == found)) return;
        block_.report(error(Fault::wrong_count, block_.span,
                            count_ ? message(block_.quoted(), " has ", found,
                                             found == 1 ? " texture" : " textures",
                                             ", but it needs ", *count_)
                                   : message(block_.quoted(), " needs a count"))
                          .with_help(block_.help()));
    }

    std::vector<Handle<Texture>> textures;

private:
    bool take_block(const Element& element) {
        if (element.word != "texture"_word) return false;
        TextureDraft draft(block_.binder.default_texture);
        if (read_texture(block_.binder, element, draft))
            textures.push_back(draft.shared(block_.binder.textures));
        else
            block_.broken = true;
        return true;
    }

    OpenBlock& block_;
    std::optional<double> count_;
};

}  // namespace

std::optional<std::vector<Handle<Texture>>> read_texture_list(OpenBlock& around,
                                                              const Element& block,
                                                              TextureCount count) {
    OpenBlock inner(around.binder, around.spelling(block.word), block.word_span);
    inner.form = count == TextureCount::said ? "{ count, texture { ... } texture { ... } ... }"
                                             : "{ texture, texture, texture }";
    TexturesReader reader(inner, count);
    inner.read(block.body, reader);
    around.broken |= inner.broken;
    if (inner.broken) return std::nullopt;
    return std::move(reader.textures);
}

void check_texture_numbers(OpenBlock& block, const Shape& shape, std::size_t count) {
    const auto* mesh = std::get_if<Shared<Mesh>>(&shape);
    if (!mesh) return;
    for (const Face& looks : (*mesh)->looks)
        for (const int look : looks)
            if (look < -1 || look >= static_cast<int>(count)) {
                block.report(error(Fault::bad_index, block.span,
                                   message("a face has texture ", look, ", but there are ", count,
                                           " in `texture_list`, counted from 0")));
                return;
            }
}

}  // namespace candelabra
