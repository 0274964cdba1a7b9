// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures in braces, behind image_map and its kin: which file or function, how its values are
// meant, how it lies. Called by the readers of patterns and textures.
#pragma once

#include "bind/bind.h"
#include "pattern/pattern.h"

#include <span>

namespace candelabra {

/// Endings that the file of a picture may have when its name leaves them out, by the word before
/// the name: `tga`; without a word, as with `png`. None: the kind has no ending of its own.
std::span<const std::string_view> picture_endings(std::string_view kind);

/// What stands in the braces, apart from what other readers take.
class PictureReader {
public:
    /// All outlive the reader. Precondition: the pattern is made of a picture.
    PictureReader(OpenBlock&, Pattern&);

    bool waiting() const { return stage_ != Stage::none || fields_.waiting(); }
    bool wants() const { return fields_.wants(); }
    bool take(const Element&);
    void finish();
    void add_words(WordList&) const;

private:
    /// Of `filter all 0.5` or `filter 3, 0.5`: what comes next.
    enum class Stage { none, which, amount };

    bool take_adjustment(const Element&);
    void take_number(double number, Span);
    std::string_view adjusted() const { return adjustment_.filter ? "filter" : "transmit"; }
    void load();

    OpenBlock& block_;
    Pattern& pattern_;
    PictureMap& map_;
    ItemReader fields_;
    Stage stage_ = Stage::none;
    ImageMap::Adjustment adjustment_;
};

/// The whole block; the pattern gets its texels. What is wrong is reported.
template <class... Others>
void read_picture(OpenBlock& block, Body body, Pattern& pattern, Others&... others) {
    PictureReader reader(block, pattern);
    block.read(body, reader, others...);
}

}  // namespace candelabra
