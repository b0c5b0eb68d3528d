// The dialogs that lie over the window: which of them is open, and when one opens by itself.
#pragma once

#include "ui/app/desk.h"
#include "ui/dialog/dialogs.h"

namespace triscope {

class ModalDialogs {
 public:
  explicit ModalDialogs(Desk& desk) : desk_(desk) {}

  void askWhatToOpen();
  void askWhereToSave();
  /// `extension` of the name that is suggested.
  void askWhereToExport(const char* extension);
  /// A run that stopped because of Settings::maxTriangles: asks once what is to be done.
  void askAboutLimit();
  void draw(const View& view, Orders& orders);
  /// To be called at the end of each frame.
  void finishFrame();
  /// True while a dialog has not come to its place: what is typed then is meant for it.
  [[nodiscard]] bool opening() const;

 private:
  Desk& desk_;
  OpenDialog open_;
  ExportDialog export_;
  SaveDialog save_;
  LimitDialog limit_;
  std::optional<Edit> asked_;    // about its limit of triangles already
  Dialog drawn_ = Dialog::none;  // last
  int framesDrawn_ = 0;
};

}  // namespace triscope
