// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/colour_maps.h"

#include "reading/convert.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// Reads an entry of a colour map: [v colour], or [v1, v2 colour colour].
class ColourEntry : public SimpleReader {
public:
    ColourEntry(OpenBlock& block, ColourMap& map) : block_(block), map_(map) {}

    bool wants() const { return true; }

    bool take(const Element& element) {
        if (element.kind != Element::Kind::value) return false;
        if (element.value.broken())
            block_.broken = true;
        else if (colours_ == 0 && values_ < 2 && element.value.numbers() &&
                 element.value.numbers()->is_scalar())
            at_[values_++] = single_precision(element.value.numbers()->at[0]);
        else
            take_colour(element);
        return true;
    }

    void finish() {
        if (block_.broken || (values_ > 0 && colours_ == values_)) return;
        block_.report(error(Fault::missing, block_.span,
                            values_ == 0 ? "an entry of `color_map` begins with a number"
                                         : "an entry of `color_map` needs a colour")
                          .with_help(block_.help()));
    }

private:
    void take_colour(const Element& element) {
        if (colours_ >= std::max(values_, 1)) {
            if (!block_.broken)
                block_.report(error(Fault::wrong_count, element.span,
                                    "an entry of `color_map` has one colour for each number")
                                  .with_help(block_.help()));
            return;
        }
        const std::optional<Colour> colour = plain_colour(block_, element);
        if (colour) map_.push_back({at_[static_cast<std::size_t>(colours_)], *colour});
        ++colours_;
    }

    OpenBlock& block_;
    ColourMap& map_;
    std::array<double, 2> at_{};
    int values_ = 0;
    int colours_ = 0;
};

}  // namespace

bool EntryNumber::take(const Element& element) {
    if (value || block_.taken > 0 || element.kind != Element::Kind::value) return false;
    if (element.value.broken()) {
        block_.broken = true;
        value = 0;
        return true;
    }
    const Numbers* numbers = element.value.numbers();
    if (!numbers || !numbers->is_scalar()) return false;
    value = single_precision(numbers->at[0]);
    --block_.taken;  // a declared item must come first behind it
    return true;
}

void EntryNumber::finish() {
    if (!value) value = std::numeric_limits<double>::quiet_NaN();
}

bool MapEntries::take(const Element& element) {
    if (element.kind != Element::Kind::entry) return false;
    OpenBlock entry(block_.binder, block_.name, element.span);
    entry.form = block_.form;
    read_(entry, element.body);
    block_.broken |= entry.broken;
    return true;
}

void report_empty(OpenBlock& block, std::size_t entries) {
    if (!block.broken && entries == 0)
        block.report(error(Fault::missing, block.span, message(block.quoted(), " has no entries"))
                         .with_help(block.help()));
}

bool read_colour_map(Binder& binder, const Element& element, ColourMap& map) {
    const auto read_entry = [&](OpenBlock& entry, Body body) {
        ColourEntry values(entry, map);
        entry.read(body, values);
    };
    return read_map(binder, element, "color_map", "{ [0 rgb <r, g, b>] [1 rgb <r, g, b>] }", map,
                    read_entry);
}

}  // namespace candelabra
