// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before a program (LD_PRELOAD), lets all its clocks run FEATUREMESH_CLOCK_FACTOR times as fast as they do.
#include <dlfcn.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/times.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace {

template <class Function>
Function* real(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

double factor() {
    static const double value = [] {
        const char* text = std::getenv("FEATUREMESH_CLOCK_FACTOR");
        return text ? std::atof(text) : 1.0;
    }();
    return value;
}

timespec to_timespec(double seconds) {
    const double whole = std::floor(seconds);
    return {static_cast<time_t>(whole), static_cast<long>((seconds - whole) * 1e9)};
}
double to_seconds(const timespec& t) { return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec); }
timeval stretched(const timeval& t) {
    const timespec s = to_timespec(factor() * (static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec)));
    return {s.tv_sec, s.tv_nsec / 1000};
}

/// Clocks of the world begin at the same time as the real ones; those of a process or thread begin at nothing.
double start_of(clockid_t clock) {
    static const std::array<double, 2> starts = [] {
        std::array<double, 2> now{};
        for (const clockid_t c : {CLOCK_REALTIME, CLOCK_MONOTONIC}) {
            timespec t{};
            real<int(clockid_t, timespec*)>("clock_gettime")(c, &t);
            now[static_cast<std::size_t>(c)] = to_seconds(t);
        }
        return now;
    }();
    if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE) return starts[0];
    if (clock == CLOCK_MONOTONIC || clock == CLOCK_MONOTONIC_COARSE || clock == CLOCK_MONOTONIC_RAW) return starts[1];
    return 0;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
    static const auto ask = real<int(clockid_t, timespec*)>("clock_gettime");
    const int result = ask(clock, now);
    const double start = start_of(clock);
    if (result == 0) *now = to_timespec(start + factor() * (to_seconds(*now) - start));
    return result;
}

int gettimeofday(timeval* now, void*) noexcept {
    timespec t{};
    const int result = clock_gettime(CLOCK_REALTIME, &t);
    *now = {t.tv_sec, t.tv_nsec / 1000};
    return result;
}

time_t time(time_t* out) noexcept {
    timespec t{};
    clock_gettime(CLOCK_REALTIME, &t);
    if (out) *out = t.tv_sec;
    return t.tv_sec;
}

clock_t clock() noexcept {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<clock_t>(to_seconds(t) * CLOCKS_PER_SEC);
}

clock_t times(tms* used) noexcept {
    static const auto ask = real<clock_t(tms*)>("times");
    const clock_t result = ask(used);
    for (clock_t* ticks : {&used->tms_utime, &used->tms_stime, &used->tms_cutime, &used->tms_cstime})
        *ticks = static_cast<clock_t>(factor() * static_cast<double>(*ticks));
    return result;
}

int getrusage(__rusage_who_t who, rusage* used) noexcept {
    static const auto ask = real<int(__rusage_who_t, rusage*)>("getrusage");
    const int result = ask(who, used);
    used->ru_utime = stretched(used->ru_utime);
    used->ru_stime = stretched(used->ru_stime);
    return result;
}
}
