// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/meters.h"

#include "reading/item_reader.h"

namespace candelabra {

bool read_meter(Binder& binder, const Element& element, Meter& meter) {
    OpenBlock block(binder, "meter", element.word_span);
    block.item = &Meter::vocabulary;
    block.form =
        "{ \"desk\" illuminance corner <0, 0.8, 0> along 4*x across 3*z [counts <8, 6>] } or { "
        "\"eye\" ugr points { 1, <1, 1.2, 1> } direction z }";
    ItemReader fields(block, *block.item, &meter);
    block.read(element.body, fields);
    if (!block.broken) {
        const std::string wrong = problem(meter);
        if (!wrong.empty())
            block.report(error(Fault::missing, element.word_span, wrong).with_help(block.help()));
    }
    return !block.broken;
}

}  // namespace candelabra
