// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a person writes them, for messages.
#pragma once

#include <string>

#include "core/geometry.h"

namespace featuremesh {

/// So many digits without trailing zeros; what is nothing beside 1 is "0".
std::string in_words(double x, int digits = 6);

/// "2.5 mm^3"; that of a part of thousandths of a millimetre, too, which is nothing beside 1.
std::string volume_in_words(double mm3, int digits = 6);

/// The number with so many digits.
double rounded(double x, int digits);

/// "(1.5, 20, -3.25)"
std::string in_words(const Vec3& p);

}  // namespace featuremesh
