#include "ui/app/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/file_identity.h"
#include "core/domain/read.h"

namespace triscope {

Document::Document(Desk& desk, std::string folder) : desk_(desk), autosave_(std::move(folder), desk.wake) {
  desk_.ui.document.kept = autosave_.keptWork();
  desk_.ui.document.offering = !desk_.ui.document.kept.empty();
}

Document::~Document() {
  saveStops_ = true;
  save_.wait();
  keep();
  if (desk_.ui.document.unsaved)
    autosave_.flush();
  else
    autosave_.forget();
}

void Document::open(const std::string& path) {
  const Result<std::string> text = readTextFile(path);
  // The session reads domains by itself, and says what is wrong with them.
  if (!text || !isSession(*text)) return give(desk_, command::OpenFile{path});
  Result<SessionFile> file = parseSession(*text, path);
  if (!file) return complain(desk_.ui, file.error());
  openSession(std::move(*file), path, std::nullopt);
}

void Document::openSession(SessionFile file, const std::string& path, std::optional<KeptWork> kept) {
  Result<Domain> domain = parseDomain(file.domainText, file.domainFile);
  if (!domain) {
    Error error = domain.error();
    error.file = path;
    return complain(desk_.ui, error);
  }
  auto shared = std::make_shared<const Domain>(std::move(*domain));
  const command::Load load{shared, file.settings, file.tick};
  opening_ = Opening{std::move(shared), std::move(file), path, std::move(kept)};
  give(desk_, load);
}

bool Document::isVersion(const std::shared_ptr<const Domain>& domain) const {
  return std::any_of(versions_.begin(), versions_.end(),
                     [&domain](const std::weak_ptr<const Domain>& version) { return version.lock() == domain; });
}

bool Document::isAnother() const { return desk_.shown != nullptr && !isVersion(desk_.shown->state.domain); }

void Document::begin() {
  DocumentUi& document = desk_.ui.document;
  const bool lost = document.unsaved;
  if (lost)
    autosave_.setAside();
  else
    autosave_.forget();
  const std::shared_ptr<const Domain>& shown = desk_.shown->state.domain;
  versions_ = {shown};
  document.opening = !isVersion(desk_.session.domain());
  base_.reset();
  draft_.reset();
  std::optional<Opening> opening = std::exchange(opening_, std::nullopt);
  if (opening && opening->domain != shown) opening.reset();
  document.path = opening ? opening->path : std::string();
  document.unsaved = opening && opening->kept;
  baseWanted_ = !document.unsaved;
  if (opening && opening->kept) autosave_.adopt(*opening->kept);
  if (lost || document.unsaved) document.kept = autosave_.keptWork();
  if (document.kept.empty()) document.offering = false;
  desk_.ui.debug.bookmarks.clear();
  document.notes.clear();
  if (opening) bringBack(std::move(opening->file));
  if (lost) desk_.ui.message = "The work from before was not saved and is kept: File, Restore unsaved work.";
}

/// What a session file holds beside domain and settings.
void Document::bringBack(SessionFile file) {
  desk_.ui.debug.bookmarks = std::move(file.bookmarks);
  desk_.ui.document.notes = std::move(file.notes);
  if (file.view) {
    desk_.ui.camera.centre = file.view->centre;
    desk_.ui.camera.scale = file.view->scale;
    desk_.ui.fitted = false;
  }
  desk_.session.apply(command::SetBreakpoints{std::move(file.breakpoints)});
  if (const std::string note = versionNote(file.madeBy); !note.empty())
    desk_.ui.message = "The session was " + note + ".";
}

void Document::follow() {
  std::erase_if(versions_, [](const std::weak_ptr<const Domain>& version) { return version.expired(); });
  desk_.ui.document.opening = desk_.session.domain() != nullptr && !isVersion(desk_.session.domain());
}

Draft Document::draft() const {
  const UiState& ui = desk_.ui;
  Draft now;
  now.domain = desk_.session.domain();
  now.settings = desk_.session.settings();
  now.breakpoints = desk_.session.breakpoints();
  now.bookmarks = ui.debug.bookmarks;
  now.notes = ui.document.notes;
  now.tick = desk_.shown->state.tick;
  if (!ui.fitted) now.view = SavedView{ui.camera.centre, ui.camera.scale};
  return now;
}

void Document::keep() {
  finishSave();
  // While something else is being opened, what is shown and what is in force belong to different documents.
  DocumentUi& document = desk_.ui.document;
  if (desk_.shown == nullptr || document.opening) return;
  if (baseWanted_ && desk_.session.busy()) return;
  draft_ = draft();
  if (std::exchange(baseWanted_, false)) base_ = draft_;
  document.unsaved = !base_ || !sameWork(*draft_, *base_);
  if (base_ && same(*draft_, *base_))
    autosave_.forget();
  else
    autosave_.follow(*draft_, document.path, Autosave::Clock::now());
  if (const std::optional<Error> error = autosave_.complaint())
    desk_.ui.message = "Work cannot be kept automatically: " + describe(*error);
}

void Document::saveTo(const std::string& path) {
  if (save_.running() || !draft_) return;
  if (const Status apart = checkOverwrites({openDomain(desk_)}, {{"the session", path}}); !apart)
    return complain(desk_.ui, apart.error());
  saving_ = draft_;
  savePath_ = path;
  desk_.ui.document.saving = true;
  desk_.ui.message = "Saving " + path + " …";
  save_.start(
      [draft = *draft_, path, &stop = saveStops_]() -> Status {
        SessionFile file = fileOf(draft, "");
        file.hashes = hashesOf(draft, [&stop] { return !stop; });
        return writeSession(path, file);
      },
      desk_.wake);
}

void Document::finishSave() {
  const std::optional<Status> outcome = save_.finished();
  if (!outcome) return;
  desk_.ui.document.saving = false;
  if (!*outcome) {
    desk_.ui.message.clear();
    return complain(desk_.ui, outcome->error());
  }
  base_ = std::exchange(saving_, std::nullopt);
  desk_.ui.document.path = savePath_;
  desk_.ui.message = "Saved " + savePath_ + ".";
}

void Document::answerOffer(const order::Kept& answer) {
  desk_.ui.document.offering = false;
  if (answer.what == order::Kept::What::restore) restore();
  if (answer.what == order::Kept::What::discard) discardKept();
}

void Document::restore() {
  const KeptWork work = desk_.ui.document.kept.front();
  desk_.ui.document.offering = false;
  Result<SessionFile> file = readSession(work.path);
  if (!file) return complain(desk_.ui, file.error());
  const std::string path = file->savedAs;
  openSession(std::move(*file), path, work);
}

void Document::discardKept() {
  DocumentUi& document = desk_.ui.document;
  discard(document.kept.front());
  document.kept.erase(document.kept.begin());
  document.offering = !document.kept.empty();
}

std::string Document::title() const {
  const DocumentUi& document = desk_.ui.document;
  std::string name = std::filesystem::path(document.path).filename().string();
  if (const Domain* const shown = shownDomain(desk_); name.empty() && shown != nullptr) name = shown->name;
  if (name.empty()) return "Triscope";
  return fmt::format("{}{} – Triscope", document.unsaved ? "*" : "", name);
}

}  // namespace triscope
