// SPDX-License-Identifier: GPL-3.0-or-later
// Reads pictures in braces, as after image_map: the file or function, its options and its mapping.
// Called by the readers of patterns and textures.
#pragma once

#include "pattern/pattern.h"
#include "reading/item_reader.h"

#include <span>

namespace candelabra {

/// File extensions that the name of a picture may leave out, by the word before the name, such as
/// `tga`. Without a word, those of `png`. Empty if the kind has no extension of its own.
std::span<const std::string_view> picture_endings(std::string_view kind);

/// Reads the elements in the braces that other readers do not take.
class PictureReader {
public:
    /// All arguments outlive the reader. Precondition: the pattern uses a picture.
    PictureReader(OpenBlock&, Pattern&);

    bool waiting() const { return stage_ != Stage::none || fields_.waiting(); }
    bool wants() const { return fields_.wants(); }
    bool take(const Element&);
    void finish();
    void add_words(WordList&) const;

private:
    /// The next part of `filter all 0.5` or `filter 3, 0.5`.
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

/// Reads the whole block and gives the pattern its texels. Reports errors.
template <class... Others>
void read_picture(OpenBlock& block, Body body, Pattern& pattern, Others&... others) {
    PictureReader reader(block, pattern);
    block.read(body, reader, others...);
}

}  // namespace candelabra
