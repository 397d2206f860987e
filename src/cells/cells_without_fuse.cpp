// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/cells_without_fuse.h"

#include <algorithm>
#include <cmath>

#include "brep/shape_print.h"
#include "brep/volumes/flux.h"
#include "core/dimension.h"
#include "core/geometry.h"
#include "core/ids.h"

namespace featuremesh {

namespace {

bool has_same_volumes(const Feature& was, const Feature& is) {
    return std::equal(was.volumes.begin(), was.volumes.end(), is.volumes.begin(), is.volumes.end(),
                      [](const FeatureVolume& a, const FeatureVolume& b) {
                          return a.shape.IsSame(b.shape) || print_of(a.shape) == print_of(b.shape);
                      });
}

double sum_of_volumes(const Feature& feature, const Brep& final_shape) {
    double sum = 0;
    for (const FeatureVolume& volume : feature.volumes)
        if (volume.shape.IsSame(final_shape.shape()))
            sum += final_shape.volume();
        else if (dimension_of(volume.shape) == Dimension::solids)
            sum += std::abs(flux(volume.shape, final_shape.box().center()));
    return sum;
}

}  // namespace

CellModel cells_without_fuse(const FeatureTree& tree, const Brep& final_shape,
                             const std::optional<CellsBefore>& before) {
    CellModel model;
    model.report.material_volume = model.report.final_volume = final_shape.volume();
    for (std::size_t f = 0; f < tree.features.size(); ++f) {
        const Feature& feature = tree.features[f];
        const auto old = before ? before->tree.find(feature.name) : std::nullopt;
        model.feature_volumes.push_back(old && has_same_volumes(before->tree[*old], feature)
                                            ? before->cells.feature_volumes[old->index()]
                                            : sum_of_volumes(feature, final_shape));
        if (!feature.error.empty()) model.report.untrusted.push_back(FeatureId(f));
    }
    return model;
}

}  // namespace featuremesh
