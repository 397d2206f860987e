// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handoff.h"

namespace featuremesh {

// Not in the header, since the caller is built without the sanitizer where these must be built with it.
void Handoff::give() { given_.fetch_add(1, std::memory_order_release); }
void Handoff::take() const { given_.load(std::memory_order_acquire); }

}  // namespace featuremesh
