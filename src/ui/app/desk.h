// What lies on the desk, for every owner to act on: the run, what is shown of it, and the state of the window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/file_identity.h"
#include "render/scene.h"
#include "ui/model/view.h"

namespace triscope {

struct Desk {
  /// `wake` makes the event loop run once more; it is called from other threads.
  explicit Desk(std::function<void()> onNews) : wake(std::move(onNews)), session(wake) {}

  std::function<void()> wake;
  Session session;
  UiState ui;
  SnapshotPtr shown;               // the session's, as far as it has been taken over; null until the first
  Scene scene;                     // of it
  Orders orders;                   // of the owners, to be carried out as the panels' are
  std::uint64_t failuresSeen = 0;  // of the session
  std::string saidNotice;          // of the session, in the message already
};

/// What the questions of a View are asked of where nothing is drawn.
inline RunView runOf(const Desk& desk) { return {desk.session, desk.ui}; }

/// Gives the session a command, and waits a little: what is quick is shown in this very frame.
void give(Desk& desk, const Command& command);

/// The parameters and the domain in force, or being applied.
inline Edit inForce(const Desk& desk) { return {desk.session.settings(), desk.session.domain()}; }
/// Null until there is something to show.
inline const Domain* shownDomain(const Desk& desk) { return desk.shown ? desk.shown->state.domain.get() : nullptr; }
/// The file that no export and no session may overwrite.
NamedFile openDomain(const Desk& desk);

void select(UiState& ui, const Pick& pick);
void openDialog(UiState& ui, Dialog dialog);
void complain(UiState& ui, const Error& error);

}  // namespace triscope
