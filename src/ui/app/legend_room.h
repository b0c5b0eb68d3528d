// Where the legend has its place: in the right column, over the picture, or behind a button. While the window stays as
// it is, it may go on in this order, but not back: it would jump to and fro while one steps.
#pragma once

#include "ui/app/desk.h"
#include "ui/region/layout.h"

namespace triscope {

class LegendRoom {
 public:
  explicit LegendRoom(Desk& desk) : desk_(desk) {}

  /// Where the window has changed, every place is open again. To be called before the layout is made.
  void look(ImVec2 window);
  /// Takes a place in the layout.
  void place(const View& view, const Layout& layout);

 private:
  /// What decides how much room there is.
  struct Room {
    ImVec2 window{0.0f, 0.0f};
    double scale = 0.0;
    Appearance look;
    std::optional<Panel> bottom;
    std::optional<bool> sidePanels;
    bool pinned = false;
    friend bool operator==(const Room& a, const Room& b) {
      return a.window.x == b.window.x && a.window.y == b.window.y && a.scale == b.scale && a.look == b.look &&
             a.bottom == b.bottom && a.sidePanels == b.sidePanels && a.pinned == b.pinned;
    }
  };

  Desk& desk_;
  Room room_;
};

}  // namespace triscope
