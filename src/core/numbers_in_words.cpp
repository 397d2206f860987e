// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/numbers_in_words.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace featuremesh {

namespace {

std::string with_digits(double x, int digits) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.*g", digits, x);
    return text.data();
}

}  // namespace

std::string in_words(double x, int digits) { return with_digits(std::abs(x) < 5e-10 ? 0.0 : x, digits); }

std::string volume_in_words(double mm3, int digits) { return with_digits(mm3, digits) + " mm^3"; }

double rounded(double x, int digits) { return std::strtod(in_words(x, digits).c_str(), nullptr); }

std::string in_words(const Vec3& p) {
    return std::string("(").append(in_words(p.x)) + ", " + in_words(p.y) + ", " + in_words(p.z) + ")";
}

}  // namespace featuremesh
