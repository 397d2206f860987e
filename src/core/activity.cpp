// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/activity.h"

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <csignal>
#include <cstring>

namespace featuremesh {

namespace {

constexpr std::size_t capacity = 200;

// Plain arrays, because a signal handler reads them.
struct Text {
    char bytes[capacity];
    std::size_t length;
};
thread_local Text text{};

int crash_descriptor = -1;

void append(std::string_view part) {
    const std::size_t count = std::min(part.size(), capacity - text.length);
    std::memcpy(text.bytes + text.length, part.data(), count);
    text.length += count;
}

#ifdef _WIN32
constexpr int crashes[] = {SIGSEGV, SIGABRT, SIGFPE, SIGILL};

void write_text() { _write(crash_descriptor, text.bytes, static_cast<unsigned>(text.length)); }
#else
constexpr int crashes[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL};

void write_text() {
    alarm(2);  // ends the process should the line below hang
    if (write(crash_descriptor, text.bytes, text.length) < 0) alarm(1);
}
#endif

extern "C" void report_crash(int signal) {
    write_text();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

}  // namespace

Activity::Activity(std::string_view what) : outer_(text.length) {
    if (text.length > 0) append(", ");
    append(what);
}

Activity::~Activity() { text.length = outer_; }

std::string_view current_activity() { return {text.bytes, text.length}; }

void write_activity_of_crash_to(int descriptor) {
    crash_descriptor = descriptor;
    for (const int signal : crashes) std::signal(signal, report_crash);
}

}  // namespace featuremesh
