// SPDX-License-Identifier: GPL-3.0-or-later
// All that asks for sizes in a part.
#pragma once

#include <memory>
#include <vector>

#include "brep/brep.h"
#include "core/run_context.h"
#include "sizing/size_provider.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

/// One of each kind. They refer to the part and the options, which have to live as long.
std::vector<std::unique_ptr<SizeProvider>> size_providers(const Brep& brep, const SizingOptions& options);

/// The places in which the providers want less than the global size: entities are covered with balls. Nothing is
/// tessellated but for thin walls. Local sizes on entities that the part does not have are skipped and logged.
SizePlaces cover_shape(const Brep& brep, const SizingOptions& options, RunContext& context);

}  // namespace featuremesh
