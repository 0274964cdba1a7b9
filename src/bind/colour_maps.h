// SPDX-License-Identifier: GPL-3.0-or-later
// color_map { [0 rgb ...] [1 rgb ...] }, and what the entries of all maps have in common. Called by
// the readers of pigments and of #declare.
#pragma once

#include "bind/binder.h"
#include "bind/block.h"

namespace candelabra {

/// The blocks change the last argument. False: the block was wrong, and has been reported.
bool read_colour_map(Binder&, const Element& block, ColourMap&);

/// The number that an entry of a map begins with; what follows is for other readers.
class EntryNumber : public SimpleReader {
public:
    explicit EntryNumber(OpenBlock& block) : block_(block) {}

    bool wants() const { return false; }
    bool take(const Element&);
    void finish();

    std::optional<double> value;  ///< in single precision, as POV-Ray keeps it; not a number when
                                  ///< the entry has none, which settle_values() answers

private:
    OpenBlock& block_;
};

/// The entries of a map in brackets, each read by a function that is given a block of its own.
class MapEntries : public SimpleReader {
public:
    using Read = FunctionRef<void(OpenBlock& entry, Body)>;

    MapEntries(OpenBlock& block, Read read) : block_(block), read_(read) {}

    bool take(const Element&);

private:
    OpenBlock& block_;
    Read read_;
};

/// After the last entry of a map.
void report_empty(OpenBlock&, std::size_t entries);

/// The block of a map: a declared one, then entries. `form` is how it is written, for messages.
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

/// What the entries of `average` without a number weigh; those of other patterns must have one.
/// Reports numbers that are missing, and weights that are none.
template <class Entry>
void settle_values(OpenBlock& block, Span span, std::vector<Entry>& map, bool average) {
    double total = 0, least = 0;
    bool missing = false;
    for (Entry& entry : map) {
        missing |= std::isnan(entry.value);
        if (std::isnan(entry.value)) entry.value = 1;
        total += entry.value;
        least = std::fmin(least, entry.value);
    }
    if (missing && !average)
        block.report(error(Fault::missing, span, "the entries of a map begin with a number")
                         .with_help("[0 ...] [0.5 ...] [1 ...]"));
    if (average && (least < 0 || !(total > 0)))
        block.report(error(Fault::out_of_range, span,
                           "the weights of `average` must be at least 0, and not all be 0"));
}

}  // namespace candelabra
