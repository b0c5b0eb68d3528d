#include "cli/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/capitalised.h"
#include "core/base/counted.h"
#include "core/base/index_text.h"
#include "core/base/json_text.h"
#include "core/base/shown_text.h"
#include "core/explain/caption.h"
#include "core/explain/element.h"
#include "core/explain/fields.h"
#include "core/explain/life.h"
#include "core/explain/why.h"
#include "core/io/events_file.h"
#include "core/io/report.h"

namespace triscope {
namespace {

/// Lines are worded as the window has them, apart from their digits: scripts read these.
std::string plainText(const Line& line) { return ungrouped(textOf(line)); }

TriangleFacts factsAt(const Stop& stop, Ref ref) {
  if (ref.kind != Ref::Kind::triangle) return {};
  const Run& run = stop.run;
  if (const auto alive = factsOf(run.state.mesh, TriangleId(ref.id))) return *alive;
  return factsOf(run.history, run.state.tick, stop.events, TriangleId(ref.id));
}

std::vector<Line> worstLines(const Mesh& mesh, const Quality& quality) {
  std::vector<Line> lines;
  for (const WorstMeasure& worst : worstOf(quality)) {
    std::string text = fmt::format("Worst {}: {:.4g}, which is {} the bound {:g}", worst.name, worst.value,
                                   worst.met() ? "within" : "beyond", worst.bound);
    if (worst.slot.exists())
      text += fmt::format(", of triangle {} at {}", idOf(mesh, worst.slot), placeText(centroidOf(mesh, worst.slot)));
    lines.push_back(linked(text + "."));
  }
  return lines;
}

std::vector<Line> stateLines(const Stop& stop, const Quality& quality) {
  const MeshState& state = stop.run.state;
  std::vector<Line> lines{linked(summaryOf(state, quality))};
  lines.push_back(linked(fmt::format("{} made, {} recorded.", counted(state.tick, "decision", "decisions"),
                                     counted(stop.events.size(), "event", "events"))));
  if (const std::string turn = turnText(state.stage, state.round); !turn.empty())
    lines.push_back(linked(capitalised(turn) + "."));
  lines.push_back(linked(fmt::format("{}, {}, {} obtuse, {}.", counted(quality.triangles, "triangle", "triangles"),
                                     counted(quality.vertices, "vertex", "vertices"), grouped(quality.obtuse),
                                     counted(state.tree.cells.size(), "cell", "cells"))));
  return lines;
}

std::vector<Line> eventLines(const Stop& stop, const Print& print) {
  const Events& events = stop.events;
  std::vector<Line> lines;
  for (std::uint64_t k = print.from; k <= print.to && k < events.size(); ++k)
    lines.push_back(lineOf(events, static_cast<std::size_t>(k)));
  if (lines.empty())
    lines.push_back(
        linked("Only " + counted(events.size(), "event has", "events have") + " been recorded up to here."));
  return lines;
}

std::vector<Line> linesOf(const Stop& stop, const Print& print, const Quality& quality) {
  const Events& events = stop.events;
  switch (print.what) {
    case Print::What::state:
      return stateLines(stop, quality);
    case Print::What::quality:
    case Print::What::worst:
      return worstLines(stop.run.state.mesh, quality);
    case Print::What::events:
      return eventLines(stop, print);
    case Print::What::why:
      return why(events, print.ref, factsAt(stop, print.ref));
    case Print::What::whynot:
      return whyNot(events, print.ref.id, factsAt(stop, print.ref));
    case Print::What::history:
      return historyOf(events, print.ref, factsAt(stop, print.ref));
    case Print::What::figures:
      return figuresOf(stop.run.state, events, print.ref);
  }
  return {};
}

std::string jsonOf(const Line& line) {
  std::string links;
  for (const Span& span : line) {
    if (!span.link) continue;
    links += fmt::format("{}{{\"kind\": {}, \"id\": {}}}", links.empty() ? "" : ", ", jsonText(nameOf(span.link->kind)),
                         span.link->id);
  }
  return fmt::format("{{\"text\": {}, \"links\": [{}]}}", jsonText(plainText(line)), links);
}

std::string worstAsJson(const Mesh& mesh, const Quality& quality) {
  std::string list;
  for (const WorstMeasure& worst : worstOf(quality)) {
    list += fmt::format("{}\n      {{\"measure\": {}, \"value\": {}, \"bound\": {}, \"met\": {}, \"triangle\": {}}}",
                        list.empty() ? "" : ",", jsonText(worst.key), jsonNumber(worst.value), jsonNumber(worst.bound),
                        worst.met(), worst.slot.exists() ? fmt::format("{}", idOf(mesh, worst.slot)) : "null");
  }
  return "[" + list + "]";
}

/// What the lines say, as numbers: only where there are any that no line names by id.
std::string dataOf(const Stop& stop, const Print& print, const Quality& quality) {
  const Mesh& mesh = stop.run.state.mesh;
  if (print.what == Print::What::quality) return ",\n     \"quality\": " + reportOf(mesh, quality);
  if (print.what == Print::What::worst) return ",\n     \"worst\": " + worstAsJson(mesh, quality);
  if (print.what != Print::What::events) return {};
  const Events& events = stop.events;
  std::string list;
  for (std::uint64_t k = print.from; k <= print.to && k < events.size(); ++k)
    list += fmt::format("{}\n      {}", list.empty() ? "" : ",", eventLine(events[static_cast<std::size_t>(k)], k));
  return ",\n     \"events\": [" + list + "]";
}

}  // namespace

std::string answersAsText(const Stop& stop, const std::vector<Print>& prints) {
  const MeshState& state = stop.run.state;
  const Quality quality = measure(state.mesh);
  std::string text =
      fmt::format("tick {}, events {}, stage {}\n", state.tick, stop.events.size(), infoOf(state.stage).key);
  if (stop.event)
    text += fmt::format("stopped by {}\n  {}\n", stop.condition, plainText(lineOf(stop.events, *stop.event)));
  for (const Print& print : prints) {
    text += fmt::format("\n{}\n", print.text);
    for (const Line& line : linesOf(stop, print, quality)) text += fmt::format("  {}\n", plainText(line));
  }
  return shownLines(text);
}

std::string answersAsJson(const Stop& stop, const std::vector<Print>& prints) {
  const MeshState& state = stop.run.state;
  const Quality quality = measure(state.mesh);
  std::string text =
      fmt::format("{{\n  \"tick\": {}, \"events\": {}, \"stage\": {}, \"round\": {}, \"hash\": \"{:016x}\",\n",
                  state.tick, stop.events.size(), jsonText(infoOf(state.stage).key), state.round, hashOf(state));
  text += "  \"hit\": ";
  text += stop.event ? fmt::format("{{\"condition\": {}, \"event\": {}}}", jsonText(stop.condition),
                                   eventLine(stop.events[*stop.event], *stop.event))
                     : "null";
  text += ",\n  \"answers\": [";
  for (std::size_t k = 0; k < prints.size(); ++k) {
    std::string lines;
    for (const Line& line : linesOf(stop, prints[k], quality))
      lines += fmt::format("{}\n      {}", lines.empty() ? "" : ",", jsonOf(line));
    text += fmt::format("{}\n    {{\"print\": {}, \"lines\": [{}]{}}}", k == 0 ? "" : ",", jsonText(prints[k].text),
                        lines, dataOf(stop, prints[k], quality));
  }
  return text + "\n  ]\n}\n";
}

}  // namespace triscope
