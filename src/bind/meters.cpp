// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/meters.h"

#include "bind/road_tables.h"
#include "reading/item_block.h"
#include "text/message.h"
#include "text/printable.h"

#include <string>
#include <utility>

namespace candelabra {

bool read_meter(Binder& binder, const Element& element, Meter& meter) {
    if (!read_item(binder, element, meter)) return false;
    if (meter.road_table.empty()) return true;
    Handle<RoadTable>& known = binder.road_tables[meter.road_table];
    if (known) {
        meter.surface = known;
        return true;
    }
    const auto text = binder.evaluator.load_data(meter.road_table, element.word_span);
    if (!text) return false;
    RoadTable table;
    if (const std::string wrong = read_road_table(*text, table); !wrong.empty()) {
        binder.evaluator.report(
            error(Fault::syntax, element.word_span,
                  message("`", printable(meter.road_table), "`: ", wrong))
                .with_help("beta,0,2,5 in the first row, then tan gamma and entries: 0.25,700,700,"
                           "690"));
        return false;
    }
    meter.surface = known = make_handle<RoadTable>(std::move(table));
    return true;
}

}  // namespace candelabra
