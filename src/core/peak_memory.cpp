// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/peak_memory.h"

#ifdef _WIN32
#include <windows.h>
// after windows.h, whose types it uses
#include <psapi.h>
#else
#include <sys/resource.h>
#endif

namespace featuremesh {

#ifdef _WIN32

double peak_memory_mb() {
    PROCESS_MEMORY_COUNTERS counters{};
    K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return static_cast<double>(counters.PeakWorkingSetSize) / (1 << 20);
}

#else

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
    constexpr double units_per_mb = 1 << 20;
#else
    constexpr double units_per_mb = 1 << 10;
#endif
    return static_cast<double>(usage.ru_maxrss) / units_per_mb;
}

#endif

}  // namespace featuremesh
