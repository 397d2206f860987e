// SPDX-License-Identifier: GPL-3.0-or-later
// What happened, for a person and for a program.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/dimension.h"
#include "core/geometry.h"
#include "core/message.h"
#include "difference/feature_difference.h"
#include "mesh/quality.h"
#include "sizing/size_conformity.h"
#include "surface/fill_surface.h"
#include "update/size_request.h"
#include "volume/fill_solids.h"

namespace featuremesh {

struct KeptByMotion {
    RigidMotion motion;
    std::vector<std::string> features;
    std::size_t nodes = 0, tets = 0;  ///< tets, or what fills the part
};

struct Report {
    std::size_t nodes = 0, tets = 0, triangles = 0, segments = 0;
    Dimension dimension = Dimension::solids;  ///< of the elements that fill the part
    int order = 1;
    double size = 0;                        ///< mm
    std::map<std::string, double> seconds;  ///< read, difference, keep, surface, volume, optimise, validate, measure
                                            ///< (quality), engine_total: all that was waited for
    double peak_memory_mb = 0;
    QualityReport quality;
    SizeConformity lengths;
    double kept_nodes_share = 0, kept_tets_share = 0;  ///< of the new mesh, and of the elements that fill the part
    std::vector<KeptByMotion> kept;
    std::size_t active_nodes = 0;
    FeatureDifference difference;
    SurfaceReport surface;
    VolumeReport volume;
    std::vector<Round> rounds;       ///< fillings that were repeated, and why; empty is the normal case
    std::vector<Message> fallbacks;  ///< what could not be kept or done, and why; empty is the normal case
    std::vector<Message> warnings;
};

}  // namespace featuremesh
