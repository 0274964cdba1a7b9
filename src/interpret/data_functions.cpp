// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/data_functions.h"

#include "interpret/array_data.h"
#include "interpret/csv.h"
#include "interpret/evaluator.h"
#include "interpret/json_reader.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// A file that a function reads, and the reports about it.
class DataText {
public:
    DataText(FunctionCall& call, Evaluator& evaluator) : call_(call), evaluator_(evaluator) {}

    /// False after a report.
    bool load() {
        const std::string name(call_.text(0));
        if (call_.failed()) return false;
        std::optional<Found> found = evaluator_.load_found(name, call_.place(0));
        // The text is read, and converted to numbers.
        constexpr std::uint64_t each_byte = 12;
        if (!found || !evaluator_.spend(each_byte * found->text.size(), call_.place(0))) {
            call_.fail_silently();
            return false;
        }
        found_ = std::move(*found);
        return true;
    }

    std::string_view text() const { return found_.text; }
    std::size_t most() const { return evaluator_.limits().array_elements; }
    std::string name() const { return printable(call_.text(0)); }

    /// Reports a problem of the file as a whole.
    Value fail(Fault fault, std::string why, std::string help = {}) {
        evaluator_.report(error(fault, call_.place(0), message("`", name(), "` ", why))
                              .with_help(std::move(help)));
        return call_.fail_silently();
    }

    Value too_many() {
        return fail(Fault::out_of_range,
                    message("has more than ", most(), " cells, which is the limit of an array"),
                    "--limit-elements raises the limit");
    }

    /// Reports a problem at a place in the file.
    Value fail_at(Fault fault, std::size_t first, std::size_t last, std::string_view what,
                  std::string help) {
        const Span span = span_of(to_source(), first, last);
        const int line = evaluator_.sources().place(span.source, span.first).line;
        evaluator_.report(error(fault, span, message("line ", line, " of `", name(), "` ", what))
                              .pointing(call_.place(0), "read here")
                              .with_help(std::move(help)));
        return call_.fail_silently();
    }

    /// Warns of cells because of which columns are text. The text cannot be used afterwards.
    void warn_of(const CsvTable& table) {
        if (table.strays.empty()) return;
        const SourceId source = to_source();
        for (const CsvStray& stray : table.strays) {
            const std::string column =
                table.names.empty()
                    ? message("column ", stray.column + 1)
                    : message("column `", printable(table.names[stray.column]), '`');
            evaluator_.report(warning(Fault::wrong_type, span_of(source, stray.first, stray.last),
                                      message(column, " of `", name(),
                                              "` is text, because this cell is no number"))
                                  .pointing(call_.place(0), "read here")
                                  .with_help("with the option text: read_csv(name, \"text\")"));
        }
    }

private:
    /// Gives the text away, so that diagnostics can show it.
    SourceId to_source() {
        return evaluator_.sources().add(std::move(found_.path), std::move(found_.text));
    }
    static Span span_of(SourceId source, std::size_t first, std::size_t last) {
        return {source, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
    }

    FunctionCall& call_;
    Evaluator& evaluator_;
    Found found_;
};

/// Applies the options in the second argument. False after a report.
bool take_options(FunctionCall& call, CsvForm& form) {
    if (call.count() < 2) return true;
    std::string_view rest = call.text(1);
    while (!rest.empty() && !call.failed()) {
        const std::string_view word = take_until(rest, " ,");
        if (!word.empty() && !form.take(word))
            call.fail(
                Fault::unknown_word, 1,
                message("`", printable(word), "` is no option of read_csv; there are ", csv_words));
    }
    return !call.failed();
}

ArrayData array_of_table(CsvTable& table, const Evaluator& evaluator) {
    std::vector<int> sizes = {static_cast<int>(table.rows), static_cast<int>(table.columns)};
    if (table.cells.empty()) return ArrayData(std::move(sizes), std::move(table.numbers));
    ArrayData result(std::move(sizes));
    for (std::size_t i = 0; i < table.cells.size(); ++i) {
        std::string& cell = table.cells[i];
        switch (table.kinds[i % table.columns]) {
            case CsvTable::Kind::numbers:
                if (const double number = *csv_number(cell, table.decimal_comma);
                    !std::isnan(number))
                    result.set(i, Numbers::scalar(number));
                break;
            case CsvTable::Kind::colours:
                result.set(i, evaluator.display_colour(csv_colour(cell)));
                break;
            case CsvTable::Kind::strings:
                result.set(i, Value(std::move(cell)));
                break;
        }
    }
    return result;
}

}  // namespace

Value csv_file(FunctionCall& call) {
    Evaluator& evaluator = *call.world.evaluator;
    DataText file(call, evaluator);
    CsvForm form;
    if (!take_options(call, form) || !file.load()) return Absence::broken;
    CsvProblem problem;
    std::optional<CsvTable> table = read_csv(file.text(), form, file.most(), problem);
    if (!table && problem.too_many) return file.too_many();
    if (!table && problem.last == 0) return file.fail(Fault::missing, problem.message);
    if (!table)
        return file.fail_at(Fault::wrong_count, problem.first, problem.last, problem.message,
                            message("cells are separated by one sign and may stand in double "
                                    "quotes; read_csv(name, options) takes ",
                                    csv_words));
    constexpr std::uint64_t each_string = 300;
    if (!evaluator.spend(each_string * table->cells.size(), call.place(0)))
        return call.fail_silently();
    file.warn_of(*table);
    ArrayData result = array_of_table(*table, evaluator);
    if (!table->names.empty())
        result.set_names(std::make_shared<const IndexNames>(std::move(table->names)));
    return make_handle<ArrayData>(std::move(result));
}

Value json_file(FunctionCall& call) {
    Evaluator& evaluator = *call.world.evaluator;
    DataText file(call, evaluator);
    if (call.count() > 1) call.text(1);
    if (call.failed() || !file.load()) return Absence::broken;
    constexpr std::uint64_t each_value = 500;
    const auto values =
        std::ranges::count_if(file.text(), [](char c) { return c == ',' || c == '[' || c == '{'; });
    if (!evaluator.spend(each_value * static_cast<std::uint64_t>(values), call.place(0)))
        return call.fail_silently();
    JsonProblem problem;
    std::optional<Value> result = read_json(file.text(), file.most(), problem);
    if (!result && problem.placed)
        return file.fail_at(Fault::syntax, problem.at, problem.at + 1, problem.message, {});
    if (!result) return file.fail(Fault::out_of_range, problem.message);
    Value found = call.count() > 1 ? evaluator.element_at(*result, call.text(1), call.place(1))
                                   : std::move(*result);
    if (found.broken()) return call.fail_silently();
    if (!found.absent()) return found;
    return file.fail(Fault::missing,
                     call.count() > 1 ? "has null or nothing in this place" : "has nothing in it");
}

Value column_names(FunctionCall& call) {
    const ArrayData* array = call.array(0);
    if (!array) return Absence::broken;
    if (!array->names()) return make_handle<ArrayData>(ArrayData::growing(ArrayData::Kinds::one));
    const std::vector<std::string>& names = array->names()->all();
    constexpr std::uint64_t making = 300, each_name = 100;
    if (!call.world.evaluator->spend(making + each_name * names.size(), call.place(0)))
        return call.fail_silently();
    ArrayData result({static_cast<int>(names.size())});
    for (std::size_t i = 0; i < names.size(); ++i) result.set(i, Value(names[i]));
    return make_handle<ArrayData>(std::move(result));
}

Value find_column(FunctionCall& call) {
    const ArrayData* array = call.array(0);
    const std::string_view name = call.text(1);
    if (call.failed() || !array->names()) return -1.0;
    if (const auto found = array->names()->find(name)) return static_cast<double>(*found);
    const std::vector<std::string>& names = array->names()->all();
    constexpr std::uint64_t each_name = 10;
    if (!call.world.evaluator->spend(each_name * names.size(), call.place(0)))
        return call.fail_silently();
    const auto similar = std::ranges::find_if(
        names, [&](const std::string& each) { return same_letters(each, name); });
    return similar == names.end() ? -1.0 : static_cast<double>(similar - names.begin());
}

}  // namespace candelabra
