// The document: opening domains and sessions, saving, and work that is kept without being asked.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "ui/app/desk.h"
#include "ui/model/background_job.h"
#include "ui/model/draft.h"

namespace triscope {

class Document {
 public:
  /// `folder`: for work that is kept; empty: none is.
  Document(Desk& desk, std::string folder);
  /// Waits for what is being written, and keeps what is not saved.
  ~Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  /// A domain or a session, told apart by its content.
  void open(const std::string& path);
  void saveTo(const std::string& path);
  /// The newest work that an earlier run left behind.
  void restore();
  void answerOffer(const order::Kept& answer);

  /// A domain that is an edit of this document's, and no other document.
  void addVersion(const std::shared_ptr<const Domain>& domain) { versions_.push_back(domain); }
  /// What is shown is of another document than what was taken over before: begin() is to be called.
  [[nodiscard]] bool isAnother() const;
  /// Takes over what is shown as a new document.
  void begin();
  /// To be called when the session has news.
  void follow();
  /// To be called often: looks whether there is something to keep, and what became of saving.
  void keep();
  /// True once when a session has been written, or could not be.
  [[nodiscard]] bool saved() const { return save_.ready(); }
  /// Seconds until keep() is to be called although nothing happens; nothing when it need not be.
  [[nodiscard]] std::optional<double> due() const { return autosave_.due(Autosave::Clock::now()); }
  [[nodiscard]] std::string title() const;

 private:
  /// A session on its way from the file to the window.
  struct Opening {
    std::shared_ptr<const Domain> domain;
    SessionFile file;
    std::string path;              // of the session that it is saved as; empty: none
    std::optional<KeptWork> kept;  // where it was kept, for work that was not saved
  };

  void openSession(SessionFile file, const std::string& path, std::optional<KeptWork> kept);
  void bringBack(SessionFile file);
  void discardKept();
  void finishSave();
  [[nodiscard]] bool isVersion(const std::shared_ptr<const Domain>& domain) const;
  [[nodiscard]] Draft draft() const;

  Desk& desk_;
  Autosave autosave_;
  BackgroundJob save_;
  std::atomic<bool> saveStops_{false};                 // the window closes: hashes that are missing are left out
  std::optional<Draft> draft_;                         // as it is now; nothing until there is a mesh
  std::optional<Draft> base_;                          // as it was opened or saved; nothing for work that was restored
  bool baseWanted_ = false;                            // draft_ is to become base_ once it is complete
  std::optional<Draft> saving_;                        // being written …
  std::string savePath_;                               // … to here
  std::optional<Opening> opening_;                     // while it is made
  std::vector<std::weak_ptr<const Domain>> versions_;  // as it was opened, and after each edit of its density
};

}  // namespace triscope
