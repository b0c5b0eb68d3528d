// Documents: opening domains and sessions, saving, and work that is kept without being asked.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/domain/read.h"
#include "ui/app/app.h"

namespace triscope {

void App::openFile(const std::string& path) {
  const Result<std::string> text = readTextFile(path);
  // The session reads domains by itself, and says what is wrong with them.
  if (!text || !isSession(*text)) {
    session_.apply(command::OpenFile{path});
    return;
  }
  Result<SessionFile> file = parseSession(*text, path);
  if (!file) return complain(file.error());
  openSession(std::move(*file), path, std::nullopt);
}

void App::openSession(SessionFile file, const std::string& path, std::optional<KeptWork> kept) {
  Result<Domain> domain = parseDomain(file.domainText, file.domainFile);
  if (!domain) {
    Error error = domain.error();
    error.file = path;
    return complain(error);
  }
  auto shared = std::make_shared<const Domain>(std::move(*domain));
  const command::Load load{shared, file.settings, file.tick};
  opening_ = Opening{std::move(shared), std::move(file), path, std::move(kept)};
  apply(load);
}

void App::complain(const Error& error) {
  ui_.error = error;
  ui_.dialog = Dialog::error;
}

bool App::isVersion(const std::shared_ptr<const Domain>& domain) const {
  return std::any_of(versions_.begin(), versions_.end(),
                     [&domain](const std::weak_ptr<const Domain>& version) { return version.lock() == domain; });
}

void App::beginDocument() {
  DocumentUi& document = ui_.document;
  const bool lost = document.unsaved;
  if (lost)
    autosave_.setAside();
  else
    autosave_.forget();
  sweep_.cancel();
  versions_ = {shownDomain_};
  document.opening = !isVersion(session_.domain());
  tuning_.reset();
  select({});
  ui_.insertion = {};
  near_.reset();
  entering_ = {};
  ui_.density = {};
  ui_.undo.clear();
  ui_.redo.clear();
  ui_.debug.from = ui_.debug.to = 0.0;
  fitted_ = true;
  base_.reset();
  draft_.reset();
  std::optional<Opening> opening = std::exchange(opening_, std::nullopt);
  if (opening && opening->domain != shownDomain_) opening.reset();
  ui_.debug.bookmarks = opening ? std::move(opening->file.bookmarks) : std::vector<Bookmark>();
  document.notes = opening ? std::move(opening->file.notes) : std::string();
  document.path = opening ? opening->path : std::string();
  document.unsaved = opening && opening->kept;
  baseWanted_ = !document.unsaved;
  if (opening && opening->file.view) {
    ui_.camera.centre = opening->file.view->centre;
    ui_.camera.scale = opening->file.view->scale;
    fitted_ = false;
  }
  if (opening) session_.apply(command::SetBreakpoints{std::move(opening->file.breakpoints)});
  if (opening && opening->kept) autosave_.adopt(*opening->kept);
  if (lost || document.unsaved) document.kept = autosave_.keptWork();
  if (document.kept.empty()) document.offering = false;
  const std::string note = opening ? versionNote(opening->file.madeBy) : std::string();
  if (!note.empty()) ui_.message = "The session was " + note + ".";
  if (lost) ui_.message = "The work from before was not saved and is kept: File, Restore unsaved work.";
}

Draft App::draft() const {
  Draft now;
  now.domain = session_.domain();
  now.settings = session_.settings();
  now.breakpoints = session_.breakpoints();
  now.bookmarks = ui_.debug.bookmarks;
  now.notes = ui_.document.notes;
  now.tick = shown_->state.tick;
  if (!fitted_) now.view = SavedView{ui_.camera.centre, ui_.camera.scale};
  return now;
}

void App::followDocument() {
  finishSave();
  // While something else is being opened, what is shown and what is in force belong to different documents.
  if (shown_ == nullptr || ui_.document.opening) return;
  if (baseWanted_ && session_.busy()) return;
  draft_ = draft();
  if (std::exchange(baseWanted_, false)) base_ = draft_;
  ui_.document.unsaved = !base_ || !sameWork(*draft_, *base_);
  if (base_ && same(*draft_, *base_))
    autosave_.forget();
  else
    autosave_.follow(*draft_, ui_.document.path, Autosave::Clock::now());
  if (const std::optional<Error> error = autosave_.complaint())
    ui_.message = "Work cannot be kept automatically: " + describe(*error);
}

NamedFile App::openDomain() const {
  return {"the domain that is open", shownDomain_ ? shownDomain_->file : std::string()};
}

void App::saveTo(const std::string& path) {
  if (save_.running() || !draft_) return;
  if (const Status apart = checkOverwrites({openDomain()}, {{"the session", path}}); !apart)
    return complain(apart.error());
  saving_ = draft_;
  savePath_ = path;
  ui_.document.saving = true;
  ui_.message = "Saving " + path + " …";
  save_.start(
      [draft = *draft_, path, &stop = saveStops_]() -> Status {
        SessionFile file = fileOf(draft, "");
        file.hashes = hashesOf(draft, [&stop] { return !stop; });
        return writeSession(path, file);
      },
      wake_);
}

void App::finishSave() {
  const std::optional<Status> outcome = save_.finished();
  if (!outcome) return;
  ui_.document.saving = false;
  if (!*outcome) {
    ui_.message.clear();
    return complain(outcome->error());
  }
  base_ = std::exchange(saving_, std::nullopt);
  ui_.document.path = savePath_;
  ui_.message = "Saved " + savePath_ + ".";
}

void App::restore() {
  DocumentUi& document = ui_.document;
  const KeptWork work = document.kept.front();
  document.offering = false;
  Result<SessionFile> file = readSession(work.path);
  if (!file) return complain(file.error());
  const std::string path = file->savedAs;
  openSession(std::move(*file), path, work);
}

void App::discardKept() {
  DocumentUi& document = ui_.document;
  discard(document.kept.front());
  document.kept.erase(document.kept.begin());
  document.offering = !document.kept.empty();
}

void App::closeDocument() {
  saveStops_ = true;
  save_.wait();
  followDocument();
  if (ui_.document.unsaved)
    autosave_.flush();
  else
    autosave_.forget();
}

std::string App::title() const {
  const DocumentUi& document = ui_.document;
  std::string name = std::filesystem::path(document.path).filename().string();
  if (name.empty() && shownDomain_) name = shownDomain_->name;
  if (name.empty()) return "Triscope";
  return fmt::format("{}{} – Triscope", document.unsaved ? "*" : "", name);
}

}  // namespace triscope
