// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/legacy_textures.h"

#include "appearance/normals.h"

#include <algorithm>
#include <initializer_list>

namespace candelabra {

namespace {

bool is_any_of(NameId word, std::initializer_list<NameId> words) {
    return std::ranges::find(words, word) != words.end();
}

bool of_finish(std::string_view word) {
    const auto named = [&](const FieldInfo& field) { return field.name == word; };
    return word == "reflection" || std::ranges::any_of(Finish::vocabulary.fields, named);
}

/// Whether the word belongs to the normal. Here it is always a bump, even if it names a pattern
/// elsewhere.
bool of_normal(NameId word) {
    return is_any_of(word, {"bumps"_word, "dents"_word, "ripples"_word, "waves"_word,
                            "wrinkles"_word, "bump_map"_word, "bump_size"_word,
                            // These belong to the bump as well, not to the colours.
                            "frequency"_word, "phase"_word});
}

bool of_pigment(NameId word) {
    return Kinds<Pattern>::find(word) != Kinds<Pattern>::count ||
           is_any_of(word, {"color_map"_word, "colour_map"_word, "image_map"_word,
                            "turbulence"_word, "octaves"_word, "omega"_word, "lambda"_word,
                            "quick_color"_word, "quick_colour"_word});
}

/// Number of values that follow a word of an old texture.
int values_behind(NameId word) {
    if (word == "metallic"_word) return 0;
    const std::size_t pattern = Kinds<Pattern>::find(word);
    const bool bump = of_normal(word) && word != "bump_map"_word;
    return bump || pattern == Kinds<Pattern>::count ? 1
                                                    : Kinds<Pattern>::infos[pattern]->positional;
}

/// A word at the element's place that is not in the text.
Element word_behind(const Element& element, NameId word) {
    Element result;
    result.word = word;
    result.span = result.word_span = element.word_span;
    return result;
}

}  // namespace

bool LegacyTextureReader::known_to(const Binder& binder) {
    constexpr double first_with_blocks = 3.0;
    return binder.evaluator.version() < first_with_blocks;
}

void LegacyTextureReader::put(ElementList& part, const Element& element) {
    part_ = &part;
    part.push_back(element);
}

bool LegacyTextureReader::take(const Element& element) {
    if (!known_to(block_.binder)) return false;
    if (element.kind == Element::Kind::value) {
        take_value(element);
        return true;
    }
    if (element.kind != Element::Kind::word && element.kind != Element::Kind::block) return false;
    if (of_finish(block_.spelling(element.word)) || element.word == "irid"_word)
        put(finish_, element);
    else if (of_normal(element.word))
        put(normal_, element);
    else if (of_pigment(element.word))
        put(pigment_, element);
    else
        return false;
    missing_ = element.kind == Element::Kind::word ? values_behind(element.word) : 0;
    // As in POV-Ray, their veins have one steep side in this notation.
    if (element.word == "marble"_word || element.word == "wood"_word)
        put(pigment_, word_behind(element, "ramp_wave"_word));
    return true;
}

/// Takes a value of the preceding word. A value that no word waits for is a colour, or, if it is a
/// number, the texture's grain (crand).
void LegacyTextureReader::take_value(const Element& element) {
    const Numbers* numbers = element.value.numbers();
    const bool amount = numbers && numbers->is_scalar();
    if (part_ == &normal_ && !amount) missing_ = 0;
    if (missing_ > 0) {
        --missing_;
        return put(*part_, element);
    }
    if (amount) put(finish_, word_behind(element, "crand"_word));
    put(amount ? finish_ : pigment_, element);
}

bool LegacyTextureReader::move(const Transform& transform) {
    if (!known_to(block_.binder)) return false;
    settle();
    ahead_ = ahead_.then(transform);
    draft_.move(transform);
    return true;
}

/// Moves the elements read so far into the texture.
void LegacyTextureReader::settle() {
    missing_ = 0;
    const auto read = [&](ElementList& part, auto reader, auto& result) {
        if (!reader(block_.binder, std::exchange(part, {}), block_.span, result))
            block_.broken = true;
    };
    if (!pigment_.empty()) {
        const bool plain = !draft_.now().pigment.pattern;
        Pigment& pigment = draft_.edit().pigment;
        read(pigment_, read_legacy_pigment, pigment);
        if (plain && pigment.pattern) pigment.transform = pigment.transform.then(ahead_);
    }
    if (!normal_.empty()) read(normal_, read_legacy_normal, draft_.edit().normal);
    if (!finish_.empty()) read(finish_, read_legacy_finish, draft_.edit().finish);
}

}  // namespace candelabra
