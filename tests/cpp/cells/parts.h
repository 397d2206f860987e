// SPDX-License-Identifier: GPL-3.0-or-later
// Parts made of primitives: the feature tree and the shape FreeCAD would show.
#pragma once

#include <BRepPrimAPI_MakeSphere.hxx>
#include <string>

#include "brep/shapes.h"
#include "features/feature_tree.h"

namespace featuremesh::test {

inline TopoDS_Shape sphere(gp_Pnt center, double radius) { return BRepPrimAPI_MakeSphere(center, radius).Solid(); }

/// A chain of features, each applied to the result of the one before.
class Part {
  public:
    Part& add(const std::string& name, const TopoDS_Shape& volume) { return step(name, {volume}, Effect::adds); }
    Part& remove(const std::string& name, const TopoDS_Shape& volume) { return step(name, {volume}, Effect::removes); }
    Part& step(const std::string& name, const std::vector<TopoDS_Shape>& volumes, Effect effect) {
        Feature feature;
        feature.name = feature.label = name;
        feature.combination = Combination::chain;
        feature.role = effect == Effect::adds ? Role::additive : Role::subtractive;
        if (!tree_.features.empty()) {
            feature.operands = {FeatureId(tree_.features.size() - 1)};
            feature.depends_on = feature.operands;
        }
        for (std::size_t i = 0; i < volumes.size(); ++i) {
            feature.volumes.push_back({volumes[i], effect, static_cast<int>(i), {}, effect});
            apply(volumes[i], effect);
        }
        tree_.object = name;
        tree_.features.push_back(std::move(feature));
        tree_.final_shape = shape_;
        return *this;
    }
    const FeatureTree& tree() const { return tree_; }

  private:
    void apply(const TopoDS_Shape& volume, Effect effect) {
        if (shape_.IsNull())
            shape_ = volume;
        else if (effect == Effect::adds)
            shape_ = fused(shape_, volume);
        else if (effect == Effect::removes)
            shape_ = cut(shape_, volume);
        else
            shape_ = BRepAlgoAPI_Common(shape_, volume).Shape();
    }

    FeatureTree tree_;
    TopoDS_Shape shape_;
};

}  // namespace featuremesh::test
