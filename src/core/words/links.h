// Text in which every element named is a link: what Why, Why not and History answer with.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace triscope {

/// An element as people name it: a triangle's id (not its slot), a vertex, a cell of the quadtree, or the index of a
/// recorded event, counted from 0.
struct Ref {
  enum class Kind : std::uint8_t { triangle, vertex, cell, event } kind = Kind::triangle;
  std::uint32_t id = 0;
  friend bool operator==(const Ref&, const Ref&) = default;
};

std::string_view nameOf(Ref::Kind kind);  // "triangle"
std::string nameOf(Ref ref);              // "triangle 5821"
/// "triangle=5821", as on the command line. Nothing when the text is not of that form.
std::optional<Ref> refFrom(std::string_view text);

struct Span {
  std::string text;
  std::optional<Ref> link;
};
using Line = std::vector<Span>;

/// Cuts a text at the elements it names: "triangle 7", "Vertex 3", "cells 4 and 5", "events 10 to 12".
Line linked(std::string_view text);
/// The text again.
std::string textOf(const Line& line);

}  // namespace triscope
