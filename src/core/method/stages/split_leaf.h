// How the stages that build the quadtree split a leaf, and when they give up.
#pragma once

#include "core/method/pipeline.h"

namespace triscope {

/// Why a leaf is split: the rule, the constraint or cell that asks for it, and the cell rank it is held against.
struct SplitReason {
  Rule rule = Rule::none;
  std::uint32_t asker = kNoId;
  int limit = 0;
};

/// Splits a leaf and returns the first of its children. The method has failed when the tree cannot but end above
/// Settings::maxTriangles, which is looked at whenever the tree has grown fourfold.
std::int32_t splitLeaf(MeshState& state, Journal& journal, const SplitReason& why, std::int32_t leaf);

}  // namespace triscope
