// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/fmt.h"

#include "editor/layout.h"
#include "options/subcommands.h"
#include "picture/file.h"
#include "syntax/parser.h"
#include "text/excerpt.h"
#include "text/loader.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

class Formatter {
public:
    Formatter(const Console& console, bool checks) : console_(console), checks_(checks) {}

    void file(const std::string& path) {
        // A pipe could keep the program waiting for ever.
        const std::optional<std::string> text =
            is_regular_file(path) ? disk_reader()(path) : std::nullopt;
        if (!text)
            return say(error(Fault::io, {}, message("`", printable(path), "` cannot be read")));
        const std::optional<std::string> better = laid_out_if_correct(path, *text);
        if (!better || *better == *text) return;
        if (checks_) {
            console_.out(message(printable(path), "\n"));
            status = std::max(status, exit_status::scene);
            return;
        }
        Diagnostics diagnostics;
        if (!write_file(path, *better, diagnostics))
            for (const Diagnostic& each : diagnostics.all()) say(each);
    }

    void standard_input() {
        const std::string text(std::istreambuf_iterator<char>(std::cin), {});
        const auto better = laid_out_if_correct("standard input", text);
        if (!better) return;
        if (!checks_)
            console_.out(*better);
        else if (*better != text)
            status = std::max(status, exit_status::scene);
    }

    int status = exit_status::done;

private:
    void say(const Diagnostic& diagnostic) {
        console_.err(format(diagnostic, SourceStore(), console_.coloured));
        status = exit_status::file;
    }

    std::optional<std::string> laid_out_if_correct(const std::string& name,
                                                   const std::string& text) {
        SourceStore sources;
        Names names;
        Diagnostics diagnostics;
        parse(sources.add(name, text), sources, names, diagnostics,
              {.included = name.ends_with(".inc")});
        for (const Diagnostic& each : diagnostics.all())
            if (each.severity == Severity::error)
                console_.err(format(each, sources, console_.coloured));
        if (!diagnostics.failed()) return laid_out(text);
        status = std::max(status, exit_status::scene);
        return std::nullopt;
    }

    const Console& console_;
    bool checks_;
};

}  // namespace

int fmt(std::span<const std::string_view> arguments, const Console& console) {
    std::vector<std::string> files;
    bool checks = false, only_files = false;
    Diagnostics none;  // no option has a value
    const auto take = [&](std::string_view, const std::string&) { checks = true; };
    for (std::string& word : take_options("fmt", arguments, take, none)) {
        if (only_files || !word.starts_with('-') || word == "-") {
            files.push_back(std::move(word));
        } else if (word == "--") {
            only_files = true;
        } else {
            console.err(format(
                error(Fault::option, {}, message("fmt has no option `", printable(word), "`"))
                    .with_help("candelabra fmt [--check] [file ...]"),
                SourceStore(), console.coloured));
            return exit_status::usage;
        }
    }
    Formatter formatter(console, checks);
    if (files.empty()) files = {"-"};
    for (const std::string& path : files) {
        if (path == "-")
            formatter.standard_input();
        else
            formatter.file(path);
    }
    return formatter.status;
}

}  // namespace candelabra
