#include "ui/app/state_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/json_text.h"
#include "core/base/output_set.h"
#include "core/mesh/centroid.h"
#include "core/method/pipeline.h"
#include "ui/model/pinned_run.h"
#include "ui/panel/panels.h"

namespace triscope {
namespace {

/// A JSON object being written.
class Object {
 public:
  Object& add(std::string_view key, const std::string& json) {
    text_ += fmt::format("{}{}: {}", text_.empty() ? "" : ",\n", jsonText(key), json);
    return *this;
  }
  Object& text(std::string_view key, std::string_view value) { return add(key, jsonText(value)); }
  Object& number(std::string_view key, double value) { return add(key, jsonNumber(value)); }
  Object& flag(std::string_view key, bool value) { return add(key, value ? "true" : "false"); }
  [[nodiscard]] std::string str() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

constexpr std::array<std::string_view, 5> kActivities{"idle", "stepping", "playing", "meshing", "searching"};
constexpr std::array<std::string_view, 5> kSelections{"none", "vertex", "edge", "triangle", "cell"};
constexpr std::array<std::string_view, 8> kDialogs{"none", "open", "save", "export", "error", "help", "about", "limit"};

template <class Enum, std::size_t N>
std::string_view word(const std::array<std::string_view, N>& words, Enum value) {
  return words[static_cast<std::size_t>(value)];
}

std::string layers(const UiState& ui) {
  Object out;
  for (const ActionInfo& info : actions())
    if (info.isOn != nullptr && info.menu == Menu::view) out.flag(info.key, info.isOn(ui));
  out.number("fill", static_cast<double>(ui.options.fill));
  return out.str();
}

std::string figures(const Quality& q) {
  return Object()
      .number("vertices", static_cast<double>(q.vertices))
      .number("boundary_vertices", static_cast<double>(q.boundaryVertices))
      .number("triangles", static_cast<double>(q.triangles))
      .number("obtuse", static_cast<double>(q.obtuse))
      .number("aspect_ratio_max", q.aspectMax)
      .number("area_ratio_max", q.areaRatioMax)
      .number("edge_ratio_max", q.edgeRatioMax)
      .number("min_angle_deg", q.minAngle)
      .number("max_angle_deg", q.maxAngle)
      .flag("within_bounds", q.withinBounds())
      .str();
}

std::string settings(const Settings& values) {
  Object out;
  for (const SettingInfo& info : settingTable()) out.number(info.key, settingValue(values, info));
  return out.str();
}

std::string widgets(const std::vector<WidgetRect>& all) {
  Object out;
  for (const WidgetRect& w : all)
    out.add(w.name, fmt::format("[{:.0f}, {:.0f}, {:.0f}, {:.0f}, {}]", w.lo.x, w.lo.y, w.hi.x - w.lo.x,
                                w.hi.y - w.lo.y, w.enabled ? "true" : "false"));
  return out.str();
}

/// Where the selected element is, in the world.
Point placeOf(const Selection& s, const MeshState& state) {
  const Mesh& mesh = state.mesh;
  if (!isPartOf(state, s)) return {};
  switch (s.kind) {
    case Selection::Kind::none:
      return {};
    case Selection::Kind::vertex:
      return pointOf(mesh, s.vertex());
    case Selection::Kind::edge:
      return midpoint(pointOf(mesh, startOf(mesh, s.half())), pointOf(mesh, endOf(mesh, s.half())));
    case Selection::Kind::triangle:
      return centroidOf(mesh, s.slot());
    case Selection::Kind::cell: {
      const Cell& cell = state.tree.cells[static_cast<std::size_t>(s.index)];
      const double half = 0.5 * state.tree.side(cell);
      return state.tree.corner(cell) + Point{half, half};
    }
  }
  return {};
}

/// Keys of every action, as the help says them.
std::string keys() {
  Object out;
  for (const ActionInfo& info : actions()) {
    std::string list;
    for (const KeyChord& chord : info.chords)
      if (chord.key != 0) list += (list.empty() ? "" : ", ") + jsonText(textOf(chord));
    out.add(info.key, "[" + list + "]");
  }
  return out.str();
}

std::string selection(const View& view) {
  const UiState& ui = view.ui;
  const Selection here = view.selection();
  const Point place = view.now() != nullptr ? placeOf(here, view.now()->state) : Point{};
  const bool gone = ui.selected.selection.kind != Selection::Kind::none && here.kind == Selection::Kind::none;
  return Object()
      .number("x", place.x)
      .number("y", place.y)
      .text("kind", word(kSelections, ui.selected.selection.kind))
      .number("index", here.index)
      .number("id", ui.selected.id == kNoId ? -1.0 : static_cast<double>(ui.selected.id))
      .flag("gone", gone)
      .str();
}

std::string list(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return "[" + text + "]";
}

/// The debugger: what is known of the run, breakpoints, marks and answers.
std::string debugger(const View& view) {
  const RunRecord& record = view.session.record();
  const DebugUi& ui = view.ui.debug;
  std::vector<std::string> breakpoints, hits, bookmarks, why, whyNot, history;
  for (const Breakpoint& b : view.session.breakpoints())
    breakpoints.push_back(Object()
                              .text("condition", b.condition.text())
                              .flag("enabled", b.enabled)
                              .number("action", static_cast<double>(b.action))
                              .str());
  for (const PassedHit& hit : view.session.hits()) hits.push_back(jsonNumber(static_cast<double>(hit.tick)));
  for (const Bookmark& mark : ui.bookmarks) bookmarks.push_back(jsonNumber(static_cast<double>(mark.tick)));
  for (const Line& line : view.debug.answers.why) why.push_back(jsonText(textOf(line)));
  for (const Line& line : view.debug.answers.whyNot) whyNot.push_back(jsonText(textOf(line)));
  for (const Line& line : view.debug.answers.history) history.push_back(jsonText(textOf(line)));
  return Object()
      .number("ticks", static_cast<double>(record.ticks))
      .flag("complete", record.complete)
      .number("samples", static_cast<double>(record.samples.size()))
      .number("measured", record.samples.empty() ? 0.0 : static_cast<double>(record.samples.back().tick))
      .number("from", ui.from)
      .number("to", ui.to)
      .text("bottom", ui.bottom ? infoOf(*ui.bottom).name : "")
      .text("tab", infoOf(ui.rightTab).name)
      .text("condition", ui.condition)
      .text("complaint", ui.complaint ? ui.complaint->message : "")
      .number("plot", static_cast<double>(ui.plot))
      .number("histogram", static_cast<double>(ui.histogram))
      .flag("brush", view.ui.options.brush.on)
      .number("brush_low", view.ui.options.brush.low)
      .number("brush_high", view.ui.options.brush.high)
      .number("brushed", static_cast<double>(view.scene.brushed))
      .add("breakpoints", list(breakpoints))
      .add("hits", list(hits))
      .add("bookmarks", list(bookmarks))
      .add("why", list(why))
      .add("why_not", list(whyNot))
      .add("history", list(history))
      .str();
}

std::string document(const DocumentUi& ui, const DebugUi& debug) {
  std::vector<std::string> names;
  names.reserve(debug.bookmarks.size());
  for (const Bookmark& mark : debug.bookmarks) names.push_back(jsonText(mark.name));
  return Object()
      .text("path", ui.path)
      .text("notes", ui.notes)
      .flag("opening", ui.opening)
      .flag("unsaved", ui.unsaved)
      .flag("saving", ui.saving)
      .number("kept", static_cast<double>(ui.kept.size()))
      .flag("offering", ui.offering)
      .add("bookmark_names", list(names))
      .str();
}

std::string density(const View& view) {
  std::vector<std::string> requests;
  if (view.session.domain() != nullptr)
    for (const DensityRequest& request : view.session.domain()->density)
      requests.push_back(Object()
                             .number("x", request.at.x)
                             .number("y", request.at.y)
                             .number("length", request.length)
                             .number("rank", request.rank)
                             .text("name", request.name)
                             .str());
  const DensityUi& ui = view.ui.density;
  return Object()
      .flag("placing", ui.placing)
      .number("selected", view.request() != nullptr ? static_cast<double>(*ui.request) : -1.0)
      .add("requests", list(requests))
      .str();
}

std::string insertion(const View& view) {
  const InsertionUi& ui = view.ui.insertion;
  if (!view.inInsertion()) return "{\"phase\": 0}";
  return Object()
      .number("phase", static_cast<double>(ui.phase))
      .number("after", static_cast<double>(ui.after))
      .number("x", ui.now->at.x)
      .number("y", ui.now->at.y)
      .number("vertex", ui.now->event.vertex)
      .text("stage", infoOf(ui.now->event.stage).key)
      .number("reach", ui.now->measured ? std::max(ui.now->measured->length, ui.now->measured->limit) : 0.0)
      .number("walk", static_cast<double>(ui.now->walk.size()))
      .number("cavity", static_cast<double>(ui.now->cavity.triangles().size()))
      .str();
}

/// Runs A and B side by side.
std::string comparison(const View& view) {
  if (view.pinned == nullptr) return Object().flag("pinned", false).str();
  const Session& a = view.pinned->session();
  const std::optional<std::size_t>& first = view.pinned->firstDifference();
  std::vector<std::string> keys;
  for (const SettingDifference& d : differences(a.settings(), view.session.settings()))
    keys.push_back(jsonText(d.setting->key));
  Object out;
  out.flag("pinned", true)
      .flag("busy", a.busy() || a.current() == nullptr)
      .number("first", first ? static_cast<double>(*first) : -1.0)
      .add("differing", list(keys))
      .add("settings", settings(a.settings()));
  if (const Snapshot* const now = a.current().get())
    out.text("stage", infoOf(now->state.stage).key)
        .number("round", now->state.round)
        .number("tick", static_cast<double>(now->state.tick))
        .number("ticks", static_cast<double>(a.record().ticks))
        .number("events", static_cast<double>(now->events))
        .add("hash", fmt::format("\"{:016x}\"", now->hash()))
        .add("figures", figures(now->quality));
  return out.str();
}

std::string numbers(const std::vector<double>& values) {
  std::vector<std::string> items;
  items.reserve(values.size());
  for (const double value : values) items.push_back(jsonNumber(value));
  return list(items);
}

/// The sweep over ω and θ that is shown, row by row as `triscope sweep` writes it.
std::string sweepOf(const View& view) {
  const SweepUi& ui = view.ui.sweep;
  Object out;
  out.flag("running", ui.making.has_value())
      .number("done", static_cast<double>(ui.done))
      .text("figure", infoOf(ui.choice.figure).name);
  for (const auto& [key, range] : {std::pair{"omega", ui.choice.omega}, std::pair{"theta", ui.choice.theta}})
    out.add(key, fmt::format("[{}, {}, {}]", jsonNumber(range.from), jsonNumber(range.to), range.count));
  if (!ui.shown()) return out.str();
  const SweepTable& table = *ui.shown();
  const std::optional<std::size_t> best = bestOf(table, ui.choice.figure);
  return out.flag("stale", !holdsFor(table, view.session.domain(), view.session.settings()))
      .add("omegas", numbers(table.omegas))
      .add("thetas", numbers(table.thetas))
      .number("chosen", ui.chosen ? static_cast<double>(*ui.chosen) : -1.0)
      .number("best", best ? static_cast<double>(*best) : -1.0)
      .text("csv", csvOf(rowsOf(table)))
      .str();
}

std::string color(Color c) { return fmt::format("[{}, {}, {}]", c.r, c.g, c.b); }

}  // namespace

std::string describeWindow(const View& view, const std::string& caption) {
  const UiState& ui = view.ui;
  Object out;
  if (const Snapshot* const now = view.now(); now != nullptr) {
    out.text("stage", infoOf(now->state.stage).key)
        .number("tick", static_cast<double>(now->state.tick))
        .number("round", now->state.round)
        .text("domain", now->state.domain->name)
        .number("events", static_cast<double>(view.session.events().size()))
        .flag("failed", now->state.failed)
        .number("min_edge", now->state.minEdge)
        .add("hash", fmt::format("\"{:016x}\"", now->hash()))
        .add("figures", figures(now->quality));
  }
  out.flag("stale", view.session.stale())
      .text("activity", word(kActivities, view.session.progress().activity))
      .add("settings", settings(view.session.settings()))
      .text("caption", caption)
      .text("message", ui.message)
      .text("tooltip", view.tooltip != nullptr ? *view.tooltip : "")
      .text("error", ui.error ? describe(*ui.error) : "")
      .text("dialog", word(kDialogs, ui.dialog))
      .text("tab", infoOf(ui.tab).name)
      .text("theme", word(kThemeNames, ui.look.theme))
      .number("scale", ui.scale())
      .number("speed", ui.speed)
      .number("keys_pressed", static_cast<double>(ui.keysPressed))
      .number("buttons_pressed", static_cast<double>(ui.buttonsPressed))
      .number("buttons_released", static_cast<double>(ui.buttonsReleased))
      .add("camera", Object()
                         .number("x", ui.camera.centre.x)
                         .number("y", ui.camera.centre.y)
                         .number("scale", ui.camera.scale)
                         .number("width", ui.camera.width)
                         .number("height", ui.camera.height)
                         .str())
      .add("layers", layers(ui))
      .add("selection", selection(view))
      .add("debug", debugger(view))
      .add("compare", comparison(view))
      .add("sweep", sweepOf(view))
      .add("document", document(ui.document, ui.debug))
      .add("density", density(view))
      .add("insertion", insertion(view))
      .number("undo", static_cast<double>(ui.undo.size()))
      .add("colors", Object()
                         .add("background", color(view.theme().background))
                         .add("surface", color(view.theme().surface))
                         .add("selection", color(view.theme().selection))
                         .add("wire", color(view.theme().wire))
                         .str());
  out.add("keys", keys()).text("keys_markdown", keysAsMarkdown());
  if (view.widgets != nullptr) out.add("widgets", widgets(*view.widgets));
  return out.str();
}

void StateFile::update(const std::string& text, std::uint64_t frame) {
  if (!wanted() || text == last_) return;
  last_ = text;
  (void)writeWhole(path_, fmt::format("{},\n\"frame\": {}}}\n", text.substr(0, text.size() - 1), frame), Flush::no);
}

}  // namespace triscope
