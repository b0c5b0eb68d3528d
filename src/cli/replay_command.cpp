// triscope replay: runs a session again and holds every stage to the hash that was recorded for it.
#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/progress_line.h"
#include "core/domain/read.h"
#include "core/method/pipeline.h"
#include "core/session/session_file.h"

namespace triscope {
namespace {

std::string stageOf(const StageHash& at) { return std::string(infoOf(at.stage).name) + turnBehind(at.stage, at.round); }

Error unmet(std::string message, std::string hint, const std::string& file) {
  return {.kind = ErrorKind::unmet, .message = std::move(message), .hint = std::move(hint), .file = file};
}

/// Tells of a session that another version saved, and of a domain file that is not what the session holds: one of them
/// has been edited.
void noteChanges(const SessionFile& session, Notices notices) {
  if (notices == Notices::none) return;
  if (const std::string note = versionNote(session.madeBy); !note.empty()) say("note: the session was {}\n", note);
  const Result<std::string> text = readTextFile(session.domainFile);
  if (!text.ok())
    say("note: {} is not there; the session's own copy is used\n", session.domainFile);
  else if (*text != session.domainText)
    say("note: the session was saved with another text than that of {}; its own copy is used\n", session.domainFile);
}

/// What differs first, of the stages recorded and those of this run.
std::optional<Error> difference(const SessionFile& session, const std::vector<StageHash>& now,
                                const std::string& file) {
  const std::string note = versionNote(session.madeBy);
  const std::string hint = note.empty()
                               ? "the session was edited, or the program has a defect: this very version saved it"
                               : "the session was edited, or " + note;
  for (std::size_t k = 0; k < session.hashes.size(); ++k) {
    const StageHash& then = session.hashes[k];
    if (k >= now.size())
      return unmet(fmt::format("the run differs: it ends before the end of {} at tick {}", stageOf(then), then.tick),
                   hint, file);
    if (then == now[k]) continue;
    return unmet(
        fmt::format("the run differs at the end of {}: the session has hash {:016x} at tick {}, this run {:016x} at "
                    "tick {}{}",
                    stageOf(then), then.hash, then.tick, now[k].hash, now[k].tick,
                    now[k].stage == then.stage && now[k].round == then.round
                        ? std::string()
                        : fmt::format(" at the end of {}", stageOf(now[k]))),
        hint, file);
  }
  return std::nullopt;
}

}  // namespace

ExitCode runCommand(const ReplayCommand& options) {
  const Result<SessionFile> session = readSession(options.file);
  if (!session.ok()) return fail(session.error());
  Result<Domain> domain = parseDomain(session->domainText, options.file);
  if (!domain.ok()) return fail(domain.error());
  Result<MeshState> start = begin(std::make_shared<const Domain>(std::move(*domain)), session->settings);
  if (!start.ok()) return fail(start.error());
  noteChanges(*session, options.notices);

  ProgressLine progress(options.notices);
  const std::vector<StageHash> now =
      stageHashes(std::move(*start), ~std::uint64_t{0}, session->hashes.size(), [&](const MeshState& state) {
        progress.show(state);
        return true;
      });
  progress.clear();
  if (const std::optional<Error> differs = difference(*session, now, options.file)) return fail(*differs);
  answer("{}: {} stage ends, all as recorded\n", options.file, session->hashes.size());
  return ExitCode::ok;
}

}  // namespace triscope
