// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/files.h"

#include "interpret/expressions.h"
#include "interpret/files.h"
#include "interpret/statements.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/scene_text.h"
#include "text/written_name.h"

#include <algorithm>
#include <filesystem>

namespace candelabra {

void DataFiles::open_file(const Tree& tree, const node::Open& node, NodeId id) {
    const std::string_view mode = context_.names.spelling(node.mode);
    const Span span = tree.span(node.path);
    const Value path = context_.expressions->evaluate(tree, node.path);
    if (path.broken() || !context_.costs.count_file(span)) return;
    if (!path.text()) {
        context_.broken(Fault::wrong_type, span,
                        message("#fopen takes the name of a file, but this is ", kind_name(path)));
        return;
    }
    if (context_.scope.find(node.file)) {
        context_.report(
            error(Fault::redefinition, tree.span(id),
                  message("`", context_.names.spelling(node.file), "` is declared already"))
                .with_help("#undef it before, or choose another name"));
        return;
    }
    DataFile file(*path.text(), tree.span(id));
    if (mode == "read") {
        open_for_reading(file, span);
    } else if (mode == "write" || mode == "append") {
        open_for_writing(file, mode == "append", span);
    } else {
        context_.broken(
            Fault::unknown_word, tree.span(id),
            message("a file is opened for read, write or append, not for `", mode, "`"));
        return;
    }
    if (file.reader || file.writer)
        context_.scope.declare(node.file, make_handle<DataFile>(std::move(file)));
    else
        context_.stop();  // each use of the name would be reported again
}

void DataFiles::open_for_reading(DataFile& file, Span span) {
    const std::string directory = directory_of(context_.sources.name(span.source));
    std::optional<Found> found = context_.loader.load(file.name, directory, FileKind::data);
    if (!found)
        return context_.report(context_.loader.problem(file.name, span, FileKind::data, directory));
    if (!context_.costs.spend(found->text.size() / 4, span)) return;
    const SourceId source = data_source(std::move(*found), span);
    file.reader = std::make_unique<DataReader>(source, context_.sources, context_.names,
                                               context_.diagnostics);
}

/// A file that is opened again is kept once, as long as it stays the same.
SourceId DataFiles::data_source(Found found, Span span) {
    const auto known = data_sources_.find(found.path);
    if (known != data_sources_.end() && context_.sources.text(known->second) == found.text)
        return known->second;
    const SourceId source = context_.sources.add(found.path, std::move(found.text), span);
    data_sources_[std::move(found.path)] = source;
    return source;
}

void DataFiles::open_for_writing(DataFile& file, bool append, Span span) {
    constexpr std::uint64_t making = 300'000;  // a file system takes long
    if (!context_.costs.spend(making, span)) return;
    const FileAccess& access = context_.loader.file_access();
    const std::optional<std::string> path = access.destination(file.name);
    const std::string rule = !path                          ? access.writing_rule(file.name)
                             : context_.loader.keeps(*path) ? std::string()
                                                            : access.rule_of_file(*path);
    if (!rule.empty()) {
        // POV-Ray renders scenes that write pages and the like, so a scene goes on without them.
        const std::filesystem::path last = std::filesystem::path(file.name).filename();
        const bool goes_on = rule == forbidden_data_name(last) && forbidden_name(last).empty();
        const std::string said = message("a scene may not write `", clipped(file.name), "`");
        context_.report((goes_on ? warning(Fault::file_access, span, said)
                                 : error(Fault::file_access, span, said))
                            .with_note(rule)
                            .with_help(access.writing_help(file.name)));
        if (goes_on) file.writer = std::make_unique<DataWriter>(std::make_shared<std::string>());
        return;
    }
    const std::shared_ptr<DataWriter> writer = writer_for(*path, append);
    if (!writer->good())
        return context_.report(error(
            Fault::io, span, message("the file `", clipped(file.name), "` cannot be written")));
    // A later #include of this file must see its new content.
    if (!context_.loader.keeps_off_disk()) context_.loader.written(*path);
    context_.trees.forget(*path);
    file.writer = writer;
    written_files_.push_back({file.name, file.opened, writer});
}

/// A writer to a destination that may be written. In a run that keeps off the disk, it writes to
/// memory, where the loader finds the text.
std::unique_ptr<DataWriter> DataFiles::writer_for(const std::string& path, bool append) {
    if (!context_.loader.keeps_off_disk())
        return std::make_unique<DataWriter>(context_.loader.file_access().open(path, append));
    auto text = std::make_shared<std::string>();
    if (append)
        if (auto before = context_.loader.load(path, {}, FileKind::data))
            *text = std::move(before->text);
    context_.loader.written(path, text);
    return std::make_unique<DataWriter>(std::move(text));
}

Handle<DataFile> DataFiles::open_file_named(const Tree& tree, NodeId id) {
    const auto* name = tree.get_if<node::Name>(id);
    if (!name) {
        context_.broken(Fault::wrong_type, tree.span(id),
                        "the name of an open file is wanted first");
        return nullptr;
    }
    return open_file_named(name->name, tree.span(id));
}

Handle<DataFile> DataFiles::open_file_named(NameId name, Span span) {
    const Value* found = context_.scope.find(name);
    if (!found) {
        context_.report(error(Fault::unknown_name, span,
                              message("no file is open as `", context_.names.spelling(name), "`"))
                            .with_help(message("#fopen ", context_.names.spelling(name),
                                               " \"...\" opens one; at its end it is closed")));
        return nullptr;
    }
    Handle<DataFile> file = found->handle<DataFile>();
    if (!file && !found->broken())
        context_.broken(Fault::wrong_type, span,
                        message("`", context_.names.spelling(name), "` is ", kind_name(*found),
                                " and not an open file"));
    return file;
}

void DataFiles::close_file(const Tree& tree, const node::Close& node, NodeId id) {
    const Value* found = context_.scope.find(node.file);
    if (!found) return;  // #read has closed it at its end
    const Handle<DataFile> file = open_file_named(node.file, tree.span(id));
    if (!file) return;
    context_.scope.undefine(node.file);
    if (file->writer) check_written(file->writer, tree.span(id));
}

/// Closes a file and reports, once, if not all of it could be written.
void DataFiles::check_written(const std::shared_ptr<DataWriter>& writer, Span span) {
    const auto file = std::ranges::find(written_files_, writer, &WrittenFile::writer);
    if (file == written_files_.end()) return;
    if (!writer->close())
        context_.report(error(Fault::io, span,
                              message("not everything could be written to `", file->name, "`")));
    written_files_.erase(file);
}

void DataFiles::check_written_files() {
    while (!written_files_.empty())
        check_written(written_files_.front().writer, written_files_.front().opened);
}

void DataFiles::read_values(const Tree& tree, const node::Read& node, NodeId id) {
    if (node.content == no_node) {
        context_.broken(Fault::missing, tree.span(id),
                        "#read needs an open file and names to read into");
        return;
    }
    const Handle<DataFile> file = open_file_named(tree, node.content);
    if (!file) return;
    if (!file->reader) {
        context_.report(error(Fault::wrong_type, tree.span(node.content),
                              message("`", file->name, "` is open for writing"))
                            .pointing(file->opened, "opened here"));
        return;
    }
    const NodeId first = tree[node.content].next;
    for (NodeId target = first; target != no_node; target = tree[target].next) {
        const Span before = file->reader->place();
        if (!read_into(tree, target, *file->reader)) return;
        if (target != first && file->reader->behind_line_end())
            warn_of_line_end(*file, tree.span(target), before);
        if (!file->reader->at_end()) continue;
        context_.scope.undefine(tree.get<node::Name>(node.content).name);
        return;
    }
}

/// Warns that a short row is completed from the next one. Reported once for each file.
void DataFiles::warn_of_line_end(const DataFile& file, Span target, Span before) {
    if (!crossed_lines_.insert(file.name).second) return;
    context_.report(
        warning(Fault::wrong_count, target,
                message("this #read goes on in the next line of `", printable(file.name), "`"))
            .with_label("this is in the next line")
            .pointing({before.source, before.last, before.last}, "here a line ends")
            .with_help("read_csv(\"...\") reads tables, and reports short rows"));
}

/// Reads one value; false when reading cannot go on.
bool DataFiles::read_into(const Tree& tree, NodeId target, DataReader& reader) {
    const auto* name = tree.get_if<node::Name>(target);
    if (!name && !tree.get_if<node::Index>(target)) {
        context_.broken(Fault::wrong_type, tree.span(target),
                        "#read puts values into names and elements of arrays, and this is neither");
        return false;
    }
    constexpr std::uint64_t reading = 50;
    context_.costs.work += reading;
    std::optional<Value> value = reader.next();
    if (!value) {  // the comma before announced one; a new name is declared, but has no value
        if (name && !context_.scope.find(name->name))
            context_.scope.declare(name->name, Absence::uninitialised);
        return true;
    }
    if (value->broken()) {
        context_.stop();
        return false;
    }
    context_.statements->assign(tree, target, std::move(*value), false);
    return !context_.stopped();
}

void DataFiles::write_values(const Tree& tree, const node::Write& node, NodeId id) {
    if (node.content == no_node) {
        context_.broken(Fault::missing, tree.span(id), "#write needs an open file and values");
        return;
    }
    const Handle<DataFile> file = open_file_named(tree, node.content);
    if (!file) return;
    if (!file->writer) {
        context_.report(error(Fault::wrong_type, tree.span(node.content),
                              message("`", file->name, "` is open for reading"))
                            .pointing(file->opened, "opened here"));
        return;
    }
    const std::uint64_t before = file->writer->bytes();
    std::optional<BinaryForm> form;
    context_.statements->walk(tree, tree[node.content].next, [&](const Element& element) {
        const std::string_view word =
            element.kind == Element::Kind::word ? context_.names.spelling(element.word) : "";
        if (word == ",")
            form.reset();
        else if (const auto found = binary_form(word))
            form = found;
        else
            write_value(*file->writer, context_.evaluator.value_of(element), form, element.span);
    });
    context_.costs.count_written(file->writer->bytes() - before, tree.span(id));
}

void DataFiles::write_value(DataWriter& writer, const Value& value,
                        const std::optional<BinaryForm>& form, Span span) {
    if (value.broken()) return;
    const bool fits = value.numbers() || (value.text() && !form);
    if (!fits)
        context_.broken(Fault::wrong_type, span,
                        message("numbers, vectors and strings can be written, but this is ",
                                kind_name(value), form ? " where binary numbers are written" : ""));
    else if (form)
        writer.write(*value.numbers(), *form);
    else
        writer.write(value);
}

}  // namespace candelabra
