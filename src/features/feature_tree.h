// SPDX-License-Identifier: GPL-3.0-or-later
// The feature tree: what each record means, in one place.
#pragma once

#include <TopoDS_Shape.hxx>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brep/booleans/shape_difference.h"
#include "core/dimension.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/message.h"
#include "core/run_context.h"
#include "features/raw_document.h"

namespace featuremesh {

enum class Role { additive, subtractive, common, dress_up, pattern, boolean, transform, base, reference, opaque };
std::string to_string(Role role);

/// What a volume does to the part.
enum class Effect { adds, removes, keeps_only };

/// How a feature's result comes from the results of its operands and its own volumes: `volumes` their union, `chain`
/// the first operand changed by one own volume after the other, `pass` the first operand as it is, else the boolean
/// operation of the operands.
enum class Combination { volumes, chain, pass, fuse, cut, common, exclusive };

/// Which volume of which feature.
struct VolumeName {
    std::string feature;
    std::int64_t instance = 0;

    auto operator<=>(const VolumeName&) const = default;
};

/// One volume of a feature: the whole, one instance of a pattern, or the part a dress-up adds or removes.
struct FeatureVolume {
    TopoDS_Shape shape;  ///< in the final shape's frame
    Effect effect = Effect::adds;
    std::int64_t instance = 0;  ///< number within a pattern
    /// From the first instance, or what is copied, to this one; the identity where a pattern mirrors or scales, a
    /// reflection where a copy is mirrored.
    RigidMotion motion;
    /// What it does to the shape that the feature is applied to: the opposite of `effect` within a tool that is cut
    /// away.
    Effect step = Effect::adds;
    /// Of a mirrored or linked volume: what it copies, and what that copies in turn.
    std::vector<VolumeName> copied_from = {};
};

struct Feature {
    std::string name, label, type;
    Role role = Role::opaque;
    std::vector<FeatureVolume> volumes;
    RigidMotion frame;  ///< of the feature, in the final shape's frame
    std::vector<FeatureId> depends_on;
    bool at_centres = false;  ///< its sketch's circles tell where it is, not how wide
    bool suppressed = false;
    std::string error;          ///< FreeCAD's message; such a feature counts as changed
    std::string volume_source;  ///< how the volumes were had: "own", "before and after", "instances", "copies", "shape"
    std::shared_ptr<const ShapeDifference> difference;  ///< where the volumes are, or should be, from before and after
    /// What FreeCAD shows before and after it, where it changes a shape or is an array; may be null.
    TopoDS_Shape before, after;
    Combination combination = Combination::volumes;
    std::vector<FeatureId> operands;  ///< whose results are combined; always earlier features
    std::vector<std::pair<std::string, double>> parameters;
    std::map<std::string, std::string> measures;  ///< of parameters that are a "length" (mm) or an "angle" (degrees)
};

/// The features in dependency order and the shape that FreeCAD shows.
struct FeatureTree {
    std::string object;  ///< name of the object that is meshed
    std::vector<Feature> features;
    TopoDS_Shape final_shape;
    std::vector<Message> notes;  ///< findings for the report

    const Feature& operator[](FeatureId id) const { return features[id.index()]; }
    std::optional<FeatureId> find(const std::string& name) const;
    /// Is its shape all that is known of it, as of one from a file, or of a copy of that?
    bool is_import(FeatureId id) const;
};

/// Interprets the records. `before`: the tree before an edit, whose features that did the same are not looked into
/// again. Where faces or edges are meshed, what has no solid counts as well: then a feature's volumes are its shells,
/// faces or wires. Throws InputError when the final object has nothing of the dimension, and Cancelled.
FeatureTree interpret(const RawDocument& document, RunContext& context, const FeatureTree* before = nullptr,
                      Dimension dimension = Dimension::from_shape);
FeatureTree interpret(const RawDocument& document);

}  // namespace featuremesh
