// One insertion taken apart, from the state before it: the triangle that it was proposed for, the walk that finds the
// place, the cavity that gives way. Nothing is changed; the last phase is the state after.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/cavity.h"
#include "core/method/state.h"
#include "core/words/vocabulary.h"

namespace triscope {

enum class InsertionPhase : std::uint8_t { candidate = 1, walk, cavity, filled };
inline constexpr int kInsertionPhases = 4;
std::string_view name(InsertionPhase phase);  // "new triangles"

/// What the candidate was measured by: from where, how far it is, and how far it may not reach.
struct Measured {
  Point from;
  Point to;  // where the measured length ends
  double length = 0.0;
  double limit = 0.0;
  TriangleId limitFrom;  // triangle that the limit was taken from, when it is another one
};

struct Insertion {
  Event event;     // that it was recorded as
  Point at;        // the new vertex
  Slot candidate;  // triangle that the point was proposed for, if any
  Vertex owner;    // vertex that a front's point stands off
  Half splits;     // half-edge on the boundary that the point splits
  std::optional<Measured> measured;
  std::vector<Slot> walk;  // from the start to the one that holds the point; empty for a split
  Cavity cavity;
};

/// Whether a decision put a vertex into the triangulation.
inline bool inserts(const Event& event) {
  return event.vertex != kNoId && does(event, kInserts) && wordsOf(event.rule).family != Family::edit;
}

/// `before` is the state right before the decision of `event`, which must be one that inserts(). Nothing when there is
/// no triangulation yet.
std::optional<Insertion> takeApart(const MeshState& before, const Event& event);

/// One or two sentences with the figures of a phase.
std::string captionOf(const Insertion& insertion, const Mesh& before, InsertionPhase phase);

}  // namespace triscope
