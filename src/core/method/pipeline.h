// The one way to carry a state on, whatever its method.
#pragma once

#include <atomic>

#include "core/base/result.h"
#include "core/density/sources.h"
#include "core/method/method.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

enum class Grain : std::uint8_t { decision, insertion, stage, round, all };

/// A state at the start of the method's first stage. Derives Δx when neither the settings nor the domain give one;
/// `goesOn` is told how far that is, and may give it up, which is an error (cancelled).
Result<MeshState> begin(std::shared_ptr<const Domain> domain, const Settings& settings, const SearchNews& goesOn = {},
                        const Method& method = paperMethod());

/// Carries the state on by one grain. Returns false when there was nothing left to do.
bool advance(MeshState& state, Grain grain, Journal& journal);
/// The same by one decision, or by a piece of the work for it: for those who must look up in between. The tick tells
/// which it was.
bool advanceAPiece(MeshState& state, Journal& journal);
/// Carries on until `stage` is over (one that may call for another round: until the last of them is), or for at most
/// `limit` beats (decisions, changes of stage, and pieces of the work for the next decision). Returns true while there
/// is more to do before that.
bool advanceUntil(MeshState& state, Stage stage, std::uint64_t limit, Journal& journal);
/// The same without a limit, and without a listener. Returns false when `cancel` became true, which is looked at every
/// few decisions.
bool advanceUntil(MeshState& state, Stage stage, const std::atomic<bool>& cancel);

}  // namespace triscope
