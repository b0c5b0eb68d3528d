// The stage table, and the one way to carry a state on.
#pragma once

#include <atomic>
#include <span>
#include <string_view>

#include "core/base/result.h"
#include "core/density/sources.h"
#include "core/method/state.h"
#include "core/words/event.h"

namespace triscope {

enum class Outcome : std::uint8_t {
  decided,   // a decision was made that inserted no point
  inserted,  // a decision was made that inserted a point
  worked,    // no decision yet, but the next one is nearer
  done,      // the stage has nothing left to do; nothing was changed
};

struct StageInfo {
  Stage id;
  std::string_view name;    // "step 3"
  std::string_view key;     // "step3": command line, files
  std::string_view does;    // one line
  std::string_view figure;  // of the paper, may be empty
  Outcome (*runOne)(MeshState&, Journal&);
};

/// One entry per Stage, in order; `finished` has no runOne.
std::span<const StageInfo> stages();
inline const StageInfo& infoOf(Stage stage) { return stages()[static_cast<std::size_t>(stage)]; }

enum class Grain : std::uint8_t { decision, insertion, stage, round, all };

/// A state at the start of the first stage. Derives Δx when neither the settings nor the domain give one; `goesOn` is
/// told how far that is, and may give it up, which is an error (cancelled).
Result<MeshState> begin(std::shared_ptr<const Domain> domain, const Settings& settings, const SearchNews& goesOn = {});

/// Carries the state on by one grain. Returns false when there was nothing left to do.
bool advance(MeshState& state, Grain grain, Journal& journal);
/// The same by one decision, or by a piece of the work for it: for those who must look up in between. The tick tells
/// which it was.
bool advanceAPiece(MeshState& state, Journal& journal);
/// Carries on until `stage` is over (step5: until the last round and its repairs are over), or for at most `limit`
/// beats (decisions, changes of stage, and pieces of the work for the next decision). Returns true while there is more
/// to do before that.
bool advanceUntil(MeshState& state, Stage stage, std::uint64_t limit, Journal& journal);
/// The same without a limit, and without a listener. Returns false when `cancel` became true, which is looked at every
/// few decisions.
bool advanceUntil(MeshState& state, Stage stage, const std::atomic<bool>& cancel);

}  // namespace triscope
