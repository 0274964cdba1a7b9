// SPDX-License-Identifier: GPL-3.0-or-later
// Reads color_map { [0 rgb ...] [1 rgb ...] }, and the common parts of all maps. Called by the
// readers of pigments and of #declare.
#pragma once

#include "reading/binder.h"
#include "reading/block.h"
#include "surface/texture.h"

namespace candelabra {

/// Applies the block to the map. Returns false, after a diagnostic, if the block was wrong.
bool read_colour_map(Binder&, const Element& block, ColourMap&);

/// Reads the number at the head of a map's entry; other readers take the rest.
class EntryNumber : public SimpleReader {
public:
    explicit EntryNumber(OpenBlock& block) : block_(block) {}

    bool wants() const { return false; }
    bool take(const Element&);
    void finish();

    /// In single precision, as in POV-Ray. NaN if the entry has no number; settle_values() resolves
    /// this.
    std::optional<double> value;

private:
    OpenBlock& block_;
};

/// Reads the bracketed entries of a map; calls a function with a block for each entry.
class MapEntries : public SimpleReader {
public:
    using Read = FunctionRef<void(OpenBlock& entry, Body)>;

    MapEntries(OpenBlock& block, Read read) : block_(block), read_(read) {}

    bool take(const Element&);

private:
    OpenBlock& block_;
    Read read_;
};

/// Reports a map that has no entries.
void report_empty(OpenBlock&, std::size_t entries);

/// Reads the block of a map: an optional declared map, then entries. `form` is its usage text for
/// messages.
template <class Map>
bool read_map(Binder& binder, const Element& element, std::string_view name, std::string_view form,
              Map& map, MapEntries::Read read_entry) {
    OpenBlock block(binder, name, element.word_span);
    block.form = form;
    auto declared = named<Map>(block, [&](const Handle<Map>& other) { map = *other; });
    MapEntries entries(block, read_entry);
    block.read(element.body, declared, entries);
    report_empty(block, map.size());
    return !block.broken;
}

/// Gives the entries of `average` without a number the weight 1, as well as all entries if their
/// weights sum to 0; a texture's weight is at least 0. Reports missing numbers in other patterns.
template <class Entry>
void settle_values(OpenBlock& block, Span span, std::vector<Entry>& map, bool average) {
    constexpr bool any_sign = !std::is_same_v<Entry, TextureStop>;
    double total = 0;
    bool missing = false, negative = false;
    for (Entry& entry : map) {
        missing |= std::isnan(entry.value);
        if (std::isnan(entry.value)) entry.value = 1;
        negative |= average && entry.value < 0;
        if (average && !any_sign) entry.value = std::fmax(entry.value, 0);
        total += entry.value;
    }
    if (missing && !average)
        block.report(error(Fault::missing, span, "the entries of a map begin with a number")
                         .with_help("[0 ...] [0.5 ...] [1 ...]"));
    const bool nothing = average && !map.empty() && total == 0;
    if (nothing)
        for (Entry& entry : map) entry.value = 1;
    if (nothing || (negative && !any_sign))
        block.report(warning(Fault::no_effect, span,
                             nothing ? "the weights of `average` sum to 0: all are 1 instead"
                                     : "the weights of textures in `average` should be at least 0: "
                                       "0 counts"));
}

}  // namespace candelabra
