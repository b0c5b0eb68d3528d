// Edits around a triangle that no moving of vertices cures: an edge flipped, merged or split, the patch around it
// relaxed, and all of it kept only where the patch is better.
#pragma once

#include "core/optimise/penalty.h"
#include "core/optimise/workpiece.h"

namespace triscope {

enum class CureKind : std::uint8_t { relax, flip, collapse, split };

struct CureEdit {
  CureKind kind = CureKind::relax;
  Vertex a, b;   // ends of the edge; collapse merges a into b
  int gain = 0;  // change of the sum of squared excesses, by the links alone: the least is tried first
};

/// How far the edits around a triangle have been tried, one by one or in pairs.
struct CureProgress {
  Slot patient;              // none: the next is to be taken
  std::uint32_t first = 0;   // edit to be tried next
  std::uint32_t second = 0;  // of pairs: number of the one after it
  std::uint32_t tried = 0;   // edits, or second ones after this first one, that were possible
  std::uint32_t firsts = 0;  // of pairs: first ones that were
  double before = 0.0;       // penalty of the patch
  double best = 0.0;         // the lowest that an edit led to, and which
  std::uint32_t bestFirst = 0;
  std::uint32_t bestSecond = 0;
  bool any = false;
};

struct CureAims {
  PenaltyLimits wanted;
  PenaltyLimits slack;
  double lowestAngle = 0.0;  // radians: an input angle below it leaves no triangle in it that keeps to the aims
};
CureAims cureAimsFor(const Aims& aims);

/// Whether a corner of the triangle stands where the input has an angle so sharp that no edit can cure what is there.
bool touchesSharpCorner(Workpiece& work, Slot slot, const CureAims& aims);

/// Of the triangles around the vertices of a patch, each once.
struct PatchPenalty {
  double sum = 0.0;
  double beyond = 0.0;  // of what is beyond the slack, but for what touches a sharp corner: 0 is cured
};
inline constexpr double kCured = 1e-9;     // of PatchPenalty::beyond
inline constexpr double kRelaxed = 1e-10;  // of the penalty of one triangle

/// A patch of vertices around a triangle: those that are relaxed, and a ring more that feels it.
struct CurePatch {
  std::vector<Vertex> all;  // nearest first
  std::size_t relaxed = 0;  // so many of them
};
void patchAround(Workpiece& work, Slot slot, int rings, CurePatch& patch);
PatchPenalty penaltyOf(Workpiece& work, std::span<const Vertex> patch, const CureAims& aims);
/// The live triangle of the patch that is furthest beyond the slack; none where none is.
Slot worstIn(Workpiece& work, std::span<const Vertex> patch, const CureAims& aims);

/// What may be tried around a triangle, the most promising first; edits that are not possible are found out when tried.
void collectEdits(Workpiece& work, Slot slot, std::vector<CureEdit>& edits);

/// Makes the edit, without a look at what comes of it; vertices that are new or were moved are appended to
/// `room.touched`. False, with nothing changed, where it is not possible. Everything is saved in the log.
bool makeEdit(Workpiece& work, const CureEdit& edit);

/// Relaxes the patch and the touched vertices after an edit, makes them Delaunay, and relaxes again what that flipped.
/// The touched ones join the patch.
PatchPenalty settle(Workpiece& work, CureKind kind, const CureAims& aims, CurePatch& patch);

}  // namespace triscope
