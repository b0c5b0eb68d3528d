// The modal dialogs, and what they remember while they are open.
#pragma once

#include <string>
#include <vector>

#include "ui/model/view.h"

namespace triscope {

class OpenDialog {
 public:
  /// Lists the folder of `path` (or the working directory) and the samples.
  void prepare(const std::string& path);
  void draw(const View& view, Orders& orders);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  void list(const std::string& folder);

  std::string folder_;
  std::string path_;
  std::string complaint_;  // why the folder cannot be listed
  std::vector<Entry> entries_;
};

class ExportDialog {
 public:
  void prepare(const std::string& path) { path_ = path; }
  void draw(const View& view, Orders& orders);

 private:
  std::string path_;
};

class SaveDialog {
 public:
  void prepare(const std::string& path) { path_ = path; }
  void draw(const View& view, Orders& orders);

 private:
  std::string path_;
};

/// What to do about a run that stopped before it made too many triangles.
class LimitDialog {
 public:
  /// Of such a run, see overLimit().
  void prepare(const MeshState& stopped);
  void draw(const View& view, Orders& orders);

 private:
  std::string question_;
  std::string reason_;
  std::string hint_;
  double minEdge_ = 0.0;  // suggested, then as typed
  double most_ = 0.0;     // triangles that it would take
};

void drawErrorDialog(const View& view, Orders& orders);
void drawHelpDialog(const View& view, Orders& orders);
void drawAboutDialog(const View& view, Orders& orders);

/// Samples that are built in: "blunt_body", …
std::vector<std::string> sampleNames();

}  // namespace triscope
