// SPDX-License-Identifier: GPL-3.0-or-later
// What each thread is working on, kept so that even a crash can say it.
#pragma once

#include <cstddef>
#include <string_view>

namespace featuremesh {

/// While it lives, its thread works on `what`, such as "Face12"; inside another one it adds to that. A few nanoseconds.
class Activity {
  public:
    explicit Activity(std::string_view what);
    ~Activity();
    Activity(const Activity&) = delete;
    Activity& operator=(const Activity&) = delete;

  private:
    std::size_t outer_;
};

/// What the calling thread works on, outermost first: "surface, Face12"; empty when nothing was said. At most 200
/// bytes.
std::string_view current_activity();

/// From now on a crash of this process (SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL) first writes the activity of the
/// thread that crashed to the file descriptor, and then ends the process as it would have.
void write_activity_of_crash_to(int descriptor);

}  // namespace featuremesh
