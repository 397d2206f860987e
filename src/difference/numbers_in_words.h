// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a person writes them.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace featuremesh {

/// Six digits without trailing zeros; what is nothing beside 1 is "0".
inline std::string in_words(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", std::abs(x) < 5e-10 ? 0.0 : x);
    return text;
}

}  // namespace featuremesh
