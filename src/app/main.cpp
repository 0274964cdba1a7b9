// SPDX-License-Identifier: GPL-3.0-or-later
// The program's entry point.
#include "app/commands.h"
#include "app/povray_command.h"
#include "tasks/library.h"
#include "app/sandbox.h"
#include "console/signals.h"
#include "text/message.h"

#include <cerrno>
#include <cstdlib>
#include <iostream>
#include <new>
#include <ostream>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

using namespace candelabra;

namespace {

/// Follows https://no-color.org.
bool colours_wanted(bool terminal) {
    const char* none = std::getenv("NO_COLOR");
    const char* kind = std::getenv("TERM");
    return terminal && !(none && *none) && !(kind && std::string_view(kind) == "dumb");
}

/// Opens closed standard streams, so that files opened later do not take their descriptors.
void fill_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0)
            std::_Exit(EXIT_FAILURE);
}

}  // namespace

int main(int count, char** arguments) {
    fill_standard_streams();
    Signals signals;
    std::vector<std::string_view> words(arguments + (count > 0 ? 1 : 0), arguments + count);
    const std::string_view command = command_named(count > 0 ? arguments[0] : "");
    if (!command.empty()) words.insert(words.begin(), command);
    Console console;
    int wrong = 0;  // first error of standard output
    console.out = [&wrong](std::string_view text) {
        errno = 0;
        std::cout << text << std::flush;
        if (!std::cout && wrong == 0) wrong = errno;
    };
    console.err = [](std::string_view text) { std::cerr << text << std::flush; };
    console.terminal = ::isatty(STDERR_FILENO) != 0;
    console.coloured = colours_wanted(console.terminal);
    console.interrupts = signals.interrupts();
    console.environment = [](const std::string& name) {
        const char* value = std::getenv(name.c_str());
        return value ? std::optional<std::string>(value) : std::nullopt;
    };
    console.confine = confine;
    console.library = standard_library(own_path(), std::getenv("CANDELABRA_STDLIB")).value_or("");
    console.povray_library = installed_povray_library();
    console.first_libraries = named_libraries(std::getenv("CANDELABRA_LIBRARY"));
    console.settings =
        settings_file(std::getenv("CANDELABRA_INI"), std::getenv("HOME")).value_or("");
    try {
        const int status = run(words, console);
        if (std::cout.good()) return status;
        // A reader that closes the pipe has read enough.
        if (wrong != EPIPE) console.err("error: cannot write to standard output\n");
        return status == exit_status::done ? exit_status::file : status;
    } catch (const std::bad_alloc&) {
        console.err(no_memory_message);
        return exit_status::file;
    }
}
