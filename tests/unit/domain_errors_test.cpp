// Every way in which a domain file can be wrong: one row each, with what the message must name.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/domain/read.h"

namespace triscope::domain_errors_test {
namespace {

constexpr int kNoPoint = -1;

struct Case {
  std::string label;
  std::string json;
  std::string loop;     // or density entry, as the error must name it
  int point;            // as the file numbers it
  std::string message;  // must be in the message
  std::string hint;     // must be in the hint
};

void PrintTo(const Case& row, std::ostream* out) { *out << row.label; }

class DomainErrorRow : public testing::TestWithParam<Case> {};

TEST_P(DomainErrorRow, NamesThePlaceAndTheCure) {
  const Case& row = GetParam();
  const auto domain = parseDomain(row.json, "plate.json");
  ASSERT_FALSE(domain.ok()) << row.json;
  const Error& error = domain.error();
  EXPECT_EQ(error.kind, ErrorKind::bad_data);
  EXPECT_EQ(error.file, "plate.json");
  if (row.loop.starts_with("density entry")) {
    EXPECT_EQ(error.loop, "");
    EXPECT_TRUE(error.message.starts_with(row.loop + ": ")) << describe(error);
  } else {
    EXPECT_EQ(error.loop, row.loop) << describe(error);
  }
  EXPECT_EQ(error.point, row.point) << describe(error);
  EXPECT_NE(error.message.find(row.message), std::string::npos) << describe(error);
  EXPECT_NE(error.hint.find(row.hint), std::string::npos) << describe(error);
  EXPECT_FALSE(error.hint.empty()) << describe(error);
}

std::string labelOf(const testing::TestParamInfo<Case>& info) { return info.param.label; }

const std::vector<Case> kText{
    {"empty_file", "", "", kNoPoint, "line 1, column 1: unexpected end of the text", "correct the text"},
    {"not_json", "outer: 3", "", kNoPoint, "line 1, column 1", "correct the text"},
    {"trailing_comma", "{\n \"outer\": [[0, 0],]\n}", "", kNoPoint, "line 2, column 19: unexpected ']'",
     "no trailing commas"},
    {"comment", "{\n// a square\n}", "", kNoPoint, "line 2, column 1", "no comments"},
    {"cut_off", "{\"outer\": [[0, 0], [1", "", kNoPoint, "unexpected end of the text", "correct the text"},
    {"not_a_number", "{\"outer\": [[NaN, 0]]}", "", kNoPoint, "line 1, column 13", "no NaN or Infinity"},
    {"overflow", "{\"outer\":\n [[1e999, 0]]}", "", kNoPoint, "1e999 ending at line 2, column 8 is too large",
     "finite"},
    {"key_twice", R"({"outer": [], "outer": []})", "", kNoPoint, "\"outer\" is given twice", "keep one"},
    {"too_deep", std::string(100, '[') + std::string(100, ']'), "", kNoPoint, "nested deeper", "not a domain file"},
    {"invalid_utf8", "{\"\xff\": 1}", "", kNoPoint, "line 1, column 3", "correct the text"},
    {"list_at_the_top", "[[0, 0], [1, 0], [0, 1]]", "", kNoPoint, "holds a list", "\"outer\""},
};

const std::vector<Case> kShape{
    {"no_outer", R"({"holes": []})", "", kNoPoint, "no \"outer\"", "add \"outer\""},
    {"outer_is_a_number", R"({"outer": 7})", "outer", kNoPoint, "a number, not a loop", "list of points"},
    {"outer_is_null", R"({"outer": null})", "outer", kNoPoint, "null", "list of points"},
    {"holes_is_an_object", R"({"outer": [[0,0],[9,0],[0,9]], "holes": {}})", "", kNoPoint, "\"holes\" is an object",
     "\"holes\": ["},
    {"segments_is_a_text", R"({"outer": [[0,0],[9,0],[0,9]], "segments": "no"})", "", kNoPoint,
     "\"segments\" is a text", "\"segments\": ["},
    {"name_is_a_number", R"({"name": 3, "outer": [[0,0],[9,0],[0,9]]})", "", kNoPoint, "\"name\" is a number",
     "\"name\""},
    {"slip_in_a_top_key", R"({"min_edge_lenght": 1, "outer": [[0,0],[9,0],[0,9]]})", "", kNoPoint,
     "unknown key \"min_edge_lenght\"", "did you mean \"min_edge_length\"?"},
    {"slip_in_a_loop_key", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corner": [0]}})", "outer",
     kNoPoint, "unknown key \"corner\"", "did you mean \"corners\"?"},
    {"foreign_loop_key", R"({"outer": {"colour": 1, "points": [[0,0],[9,0],[0,9]]}})", "outer", kNoPoint,
     "unknown key \"colour\"", "known here: kind, description, name, points"},
    {"unknown_kind", R"({"outer": {"kind": "ellipse", "points": []}})", "outer", kNoPoint, "unknown kind \"ellipse\"",
     "known here: polygon, spline, circle, pieces"},
    {"circle_as_segment",
     R"({"outer": [[0,0],[9,0],[0,9]], "segments": [{"kind": "circle", "centre": [2,2], "radius": 1}]})", "segment 1",
     kNoPoint, "unknown kind \"circle\"", "known here: polyline, spline, pieces"},
    {"kind_is_a_number", R"({"outer": {"kind": 2}})", "outer", kNoPoint, "\"kind\" is a number", "\"kind\""},
    {"no_points", R"({"outer": {"kind": "polygon"}})", "outer", kNoPoint, "\"points\" is missing", "add it"},
    {"points_is_a_number", R"({"outer": {"points": 3}})", "outer", kNoPoint, "a number, not a list", "[[x, y]"},
    {"empty_name", R"({"outer": {"name": "", "points": [[0,0],[9,0],[0,9]]}})", "outer", kNoPoint, "\"name\" is empty",
     "leave the key out"},
    {"same_name_twice", R"({"outer": {"name": "a", "points": [[0,0],[9,0],[0,9]]},
                            "holes": [{"name": "a", "points": [[1,1],[2,1],[1,2]]}]})",
     "a", kNoPoint, "two loops have this name", "its own name"},
    {"name_taken_by_default", R"({"outer": [[0,0],[9,0],[0,9]],
                                  "holes": [[[1,1],[2,1],[1,2]], {"name": "hole 1", "points": [[3,1],[4,1],[3,2]]}]})",
     "hole 1", kNoPoint, "two loops have this name", "its own name"},
};

const std::vector<Case> kPoints{
    {"three_coordinates", R"({"outer": [[0,0],[9,0,0],[0,9]]})", "outer", 1, "two numbers, not a list of 3", "[x, y]"},
    {"text_coordinate", R"({"outer": [[0,0],[9,0],[0,"9"]]})", "outer", 2, "not [a number, a text]", "[x, y]"},
    {"point_is_a_number", R"({"outer": [[0,0],4,[0,9]]})", "outer", 1, "two numbers, not a number", "[x, y]"},
    {"too_large", R"({"outer": [[0,0],[1e31,0],[0,9]]})", "outer", 1, "too large", "1e+30"},
    {"too_small", R"({"outer": [[0,0],[9,0],[0,9],[-1e-200,4]]})", "outer", 3, "too small", "use 0"},
    {"empty_loop", R"({"outer": []})", "outer", kNoPoint, "no points", "at least 3"},
    {"one_point", R"({"outer": [[1,2]]})", "outer", 0, "only 1 different point", "at least 3"},
    {"two_points_closed", R"({"outer": [[1,2],[3,4],[1,2]]})", "outer", 0, "only 2 different points", "at least 3"},
    {"segment_of_one_point", R"({"outer": [[0,0],[9,0],[0,9]], "segments": [[[1,1]]]})", "segment 1", 0,
     "only 1 different point", "a segment needs at least 2"},
    {"repeated_point", R"({"outer": [[0,0],[9,0],[9,0],[0,9]]})", "outer", 2, "point 2 repeats point 1", "remove one"},
    {"closed_twice", R"({"outer": [[0,0],[9,0],[0,9],[0,0],[0,0]]})", "outer", 3, "point 3 repeats point 0",
     "remove it"},
    {"no_area", R"({"outer": [[0,0],[1,1],[3,3]]})", "outer", kNoPoint, "on one line", "enclose an area"},
    {"no_area_at_all", R"({"outer": {"kind": "circle", "centre": [1e20, 1e20], "radius": 0.001}})", "outer", kNoPoint,
     "at the same place", "enclose an area"},
};

const std::vector<Case> kCurves{
    {"corners_is_a_number", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": 0}})", "outer",
     kNoPoint, "\"corners\" is a number", "corner_turn"},
    {"corner_out_of_range", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": [3]}})", "outer",
     kNoPoint, "no point 3", "0 to 2"},
    {"corner_of_a_half", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": [0.5]}})", "outer",
     kNoPoint, "no point 0.5", "0 to 2"},
    {"corner_is_a_text", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corners": ["0"]}})", "outer",
     kNoPoint, "a text, not the number", "0 to 2"},
    {"corner_turn_too_large", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[0,9]], "corner_turn": 180}})",
     "outer", kNoPoint, "\"corner_turn\"", "degrees"},
    {"spline_points_too_close", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0],[9,1e-9],[0,9]]}})", "outer", 1,
     "too close for a spline", "corner"},
    {"spline_of_two_points", R"({"outer": {"kind": "spline", "points": [[0,0],[9,0]]}})", "outer", 0,
     "only 2 different points", "a closed spline needs at least 3"},
    {"circle_without_radius", R"({"outer": {"kind": "circle", "centre": [0,0]}})", "outer", kNoPoint,
     "\"radius\" is missing", "add it"},
    {"circle_of_no_radius", R"({"outer": {"kind": "circle", "centre": [0,0], "radius": 0}})", "outer", kNoPoint,
     "\"radius\" is 0", "positive"},
    {"circle_of_negative_radius", R"({"outer": {"kind": "circle", "centre": [0,0], "radius": -2}})", "outer", kNoPoint,
     "\"radius\" is -2", "positive"},
    {"circle_centre_is_a_number", R"({"outer": {"kind": "circle", "centre": 0, "radius": 1}})", "outer", kNoPoint,
     "\"centre\" must be two numbers", "[x, y]"},
    {"circle_with_points", R"({"outer": {"kind": "circle", "points": []}})", "outer", kNoPoint,
     "unknown key \"points\"", "centre, radius"},
    {"circle_without_centre", R"({"outer": {"kind": "circle", "radius": 1}})", "outer", kNoPoint,
     "\"centre\" is missing", "add it"},
    {"circle_center_is_a_text", R"({"outer": {"kind": "circle", "center": "0, 0", "radius": 1}})", "outer", kNoPoint,
     "\"center\" must be two numbers", "[x, y]"},
    {"circle_with_two_centres", R"({"outer": {"kind": "circle", "center": [0,0], "centre": [0,0], "radius": 1}})",
     "outer", kNoPoint, "given together", "keep one"},
    {"pieces_is_empty", R"({"outer": {"pieces": []}})", "outer", kNoPoint, "list of pieces", "\"pieces\": ["},
    {"piece_is_a_list", R"({"outer": {"pieces": [[0,0]]}})", "outer", kNoPoint, "piece 0: it is a list", "\"kind\""},
    {"piece_of_unknown_kind", R"({"outer": {"pieces": [{"kind": "polygon"}]}})", "outer", kNoPoint,
     "piece 0: unknown kind \"polygon\"", "line, arc, spline"},
    {"piece_with_a_name", R"({"outer": {"pieces": [{"name": "x", "points": [[0,0],[1,1]]}]}})", "outer", kNoPoint,
     "piece 0: unknown key \"name\"", "known here"},
    {"piece_does_not_follow",
     R"({"outer": {"pieces": [{"points": [[0,0],[9,0]]}, {"points": [[9,0.5],[0,9],[0,0]]}]}})", "outer", kNoPoint,
     "piece 0 ends at (9, 0) but piece 1 starts at (9, 0.5)", "exactly"},
    {"pieces_not_closed", R"({"outer": {"pieces": [{"points": [[0,0],[9,0],[0,9],[0,1]]}]}})", "outer", kNoPoint,
     "not closed: piece 0 ends at (0, 1) but piece 0 starts at (0, 0)", "exactly"},
    {"arc_of_two_points", R"({"outer": {"pieces": [{"kind": "arc", "points": [[0,0],[9,0]]}]}})", "outer", kNoPoint,
     "piece 0: an arc has 2 points", "give three"},
    {"straight_arc", R"({"outer": {"pieces": [{"kind": "arc", "points": [[0,0],[4,0],[9,0]]}]}})", "outer", 1,
     "piece 0: the three points of the arc lie on one line", "\"line\""},
    {"arc_back_to_its_start", R"({"outer": {"pieces": [{"kind": "arc", "points": [[0,0],[4,0],[0,0]]}]}})", "outer", 1,
     "piece 0", ""},
    {"point_of_a_piece", R"({"outer": {"pieces": [{"points": [[0,0],[9,0],[9]]}]}})", "outer", 2,
     "piece 0: a point must be two numbers", "[x, y]"},
};

const std::vector<Case> kMeeting{
    {"bow_tie", R"({"outer": [[0,0],[4,4],[4,0],[0,4]]})", "outer", kNoPoint, "edge 0-1 crosses edge 2-3",
     "no longer cross"},
    {"closing_edge_crosses", R"({"outer": [[0,0],[4,0],[1,4],[1,-1]]})", "outer", kNoPoint, "edge 0-1 crosses edge 2-3",
     "no longer cross"},
    {"figure_of_eight", R"({"outer": [[0,0],[2,2],[4,0],[4,4],[2,2],[0,4]]})", "outer", 1,
     "point 1 is at the same place as point 4", "touch neither itself"},
    {"point_on_own_edge", R"({"outer": [[0,0],[8,0],[8,8],[4,0],[0,8]]})", "outer", 3, "point 3 lies on edge 0-1",
     "move it away"},
    {"spike", R"({"outer": [[0,0],[4,0],[4,4],[4,6],[4,4.5],[0,4]]})", "outer", 4, "point 4 lies on edge 2-3",
     "move it away"},
    {"loops_cross", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[6,6],[10,6],[10,7],[6,7]]]})", "hole 1",
     kNoPoint, "edge 0-1 crosses edge 1-2 of loop 'outer'", "no longer cross"},
    {"loops_share_a_point", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[0,0],[2,1],[1,2]]]})", "hole 1", 0,
     "point 0 is at the same place as point 0 of loop 'outer'", "nor another loop"},
    {"hole_touches_edge", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[3,3],[4,0],[5,3]]]})", "hole 1", 1,
     "point 1 lies on edge 0-1 of loop 'outer'", "move it away"},
    {"holes_share_an_edge",
     R"({"outer": [[0,0],[9,0],[9,9],[0,9]], "holes": [[[1,1],[4,1],[4,4],[1,4]], [[4,1],[7,1],[7,4],[4,4]]]})",
     "hole 2", 0, "point 0 is at the same place as point 1 of loop 'hole 1'", "nor another loop"},
    {"edges_run_together", R"({"outer": [[0,0],[9,0],[9,9],[0,9]], "holes": [[[2,0],[6,0],[4,3]]]})", "hole 1", 0,
     "point 0 lies on edge 0-1 of loop 'outer'", "move it away"},
    {"hole_outside", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[9,9],[10,9],[9,10]]]})", "hole 1", 0,
     "lies outside the outer loop", "move it inside"},
    {"hole_in_a_hole",
     R"({"outer": [[0,0],[9,0],[9,9],[0,9]], "holes": [[[1,1],[8,1],[8,8],[1,8]], [[3,3],[4,3],[3,4]]]})", "hole 2", 0,
     "lies inside 'hole 1'", "remove one"},
    {"outer_in_a_hole", R"({"outer": [[1,1],[2,1],[1,2]], "holes": [[[0,0],[8,0],[8,8],[0,8]]]})", "outer", 0,
     "lies inside 'hole 1'", "the \"outer\" one"},
    {"named_loops_cross", R"({"outer": {"name": "far", "points": [[0,0],[8,0],[8,8],[0,8]]},
         "holes": [{"name": "body", "kind": "circle", "centre": [7.5,4.01], "radius": 2}]})",
     "body", kNoPoint, "the circle crosses edge 1-2 of loop 'far'", "no longer cross"},
    {"piece_crosses",
     R"({"outer": {"pieces": [{"points": [[0,0],[4,0]]}, {"kind": "arc", "points": [[4,0],[2,-1],[0,0.5]]},
                              {"points": [[0,0.5],[0,0]]}]}})",
     "outer", kNoPoint, "of piece 0 crosses", "no longer cross"},
    {"spline_crosses_itself",
     R"({"outer": {"kind": "spline", "points": [[0,0],[4,0],[0.2,3],[4,3.2]], "corners": [0]}})", "outer", kNoPoint,
     "crosses curve", "no longer cross"},
    {"polygon_fine_but_spline_not",
     R"({"outer": {"kind": "spline", "points": [[0,0],[4,0],[4,4],[0,4]]},
         "holes": [{"kind": "circle", "centre": [4.3, 2], "radius": 0.6}]})",
     "hole 1", kNoPoint, "the circle crosses curve 1-2 of loop 'outer'", "no longer cross"},
    {"segment_crosses_a_loop", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[4,4],[10,5]]]})", "segment 1",
     kNoPoint, "edge 0-1 crosses edge 1-2 of loop 'outer'", "no longer cross"},
    {"segment_ends_on_an_edge", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[4,4],[8,5]]]})", "segment 1", 1,
     "point 1 lies on edge 1-2 of loop 'outer'", "give both the same point"},
    {"segments_cross", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[1,1],[3,3]], [[1,3],[3,1]]]})",
     "segment 2", kNoPoint, "edge 0-1 crosses edge 0-1 of loop 'segment 1'", "no longer cross"},
    {"segment_twice", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[1,1],[3,3]], [[3,3],[1,1]]]})",
     "segment 2", 1, "edge 0-1 runs along edge 0-1 of loop 'segment 1'", "remove one"},
    {"segment_there_and_back", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[1,1],[3,3],[1,1]]]})",
     "segment 1", 0, "edge 0-1 runs along edge 1-2", "remove one"},
    {"segment_along_the_boundary", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[0,0],[8,0]]]})", "segment 1",
     0, "edge 0-1 runs along edge 0-1 of loop 'outer'", "remove one"},
    {"segment_outside", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[9,4],[10,5]]]})", "segment 1", 0,
     "outside the outer loop", "move it inside"},
    {"segment_leaves_at_a_corner", R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[4,4],[8,8],[9,9]]]})",
     "segment 1", 1, "outside the outer loop", "move it inside"},
    {"segment_across_a_notch", R"({"outer": [[0,0],[8,0],[8,8],[4,4],[0,8]], "segments": [[[0,8],[8,8]]]})",
     "segment 1", 0, "outside the outer loop", "move it inside"},
    {"segment_in_a_hole",
     R"({"outer": [[0,0],[9,0],[9,9],[0,9]], "holes": [[[1,1],[8,1],[8,8],[1,8]]], "segments": [[[3,3],[4,4]]]})",
     "segment 1", 0, "lies inside 'hole 1'", "not meshed"},
    {"segment_meets_the_inside_of_a_spline", R"({"outer": [[0,0],[9,0],[9,9],[0,9]],
         "segments": [{"kind": "spline", "points": [[1,1],[3,2],[5,1]]}, [[3,2],[3,5]]]})",
     "segment 2", 0, "point 0 is at the same place as point 1 of loop 'segment 1'", "corner or an end"},
};

const std::vector<Case> kSizes{
    {"min_edge_of_zero", R"({"outer": [[0,0],[9,0],[0,9]], "min_edge_length": 0})", "", kNoPoint,
     "\"min_edge_length\" is 0", "positive"},
    {"min_edge_is_a_text", R"({"outer": [[0,0],[9,0],[0,9]], "min_edge_length": "1"})", "", kNoPoint,
     "\"min_edge_length\" is a text", "1.5"},
    {"min_edge_too_large", R"({"outer": [[0,0],[9,0],[0,9]], "min_edge_length": 9})", "", kNoPoint,
     "is 9, but the domain is 9 wide", "less than 9"},
    {"min_edge_too_small", R"({"outer": [[0,0],[9,0],[0,9]], "min_edge_length": 1e-12})", "", kNoPoint,
     "the domain is 9 wide", "give a length from"},
    {"density_is_an_object", R"({"outer": [[0,0],[9,0],[0,9]], "density": {}})", "", kNoPoint,
     "\"density\" is an object, not a list", "\"density\": ["},
    {"request_is_a_list", R"({"outer": [[0,0],[9,0],[0,9]], "density": [[1,1]]})", "density entry 1", kNoPoint,
     "a list", "\"at\""},
    {"request_nowhere", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"rank": 1}]})", "density entry 1", kNoPoint,
     "none of at, loop, box", "exactly one"},
    {"request_in_two_places",
     R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "loop": "outer", "rank": 1}]})", "density entry 1",
     kNoPoint, "at, loop are given together", "exactly one"},
    {"request_of_nothing", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1]}]})", "density entry 1", kNoPoint,
     "none of rank, length", "exactly one"},
    {"request_of_both", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "rank": 1, "length": 1}]})",
     "density entry 1", kNoPoint, "rank, length are given together", "exactly one"},
    {"rank_of_zero", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "rank": 0}]})", "density entry 1",
     kNoPoint, "\"rank\" is 0", "1 (finest) to 64"},
    {"rank_of_a_half", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "rank": 1.5}]})", "density entry 1",
     kNoPoint, "\"rank\" is 1.5", "whole number"},
    {"rank_too_coarse", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "rank": 65}]})", "density entry 1",
     kNoPoint, "\"rank\" is 65", "1 (finest) to 64"},
    {"rank_is_a_text", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "rank": "1"}]})", "density entry 1",
     kNoPoint, "\"rank\" is a text", "whole number"},
    {"length_of_zero", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "length": 0}]})", "density entry 1",
     kNoPoint, "\"length\" is 0", "positive"},
    {"length_below_the_smallest",
     R"({"outer": [[0,0],[9,0],[0,9]], "min_edge_length": 0.5, "density": [{"at": [1,1], "length": 0.4}]})",
     "density entry 1", kNoPoint, "below the smallest edge length 0.5", "raise it"},
    {"second_request_named",
     R"({"outer": [[0,0],[9,0],[0,9]],
         "density": [{"at": [1,1], "rank": 1}, {"name": "tip", "at": [1,1], "rank": -1}]})",
     "density entry 'tip'", kNoPoint, "\"rank\" is -1", "whole number"},
    {"unknown_loop", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"loop": "wing", "rank": 1}]})", "density entry 1",
     kNoPoint, "no loop 'wing'", "there are: outer"},
    {"loop_by_number", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"loop": 0, "rank": 1}]})", "density entry 1",
     kNoPoint, "\"loop\" is a number", "name of a loop"},
    {"request_outside", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,10], "rank": 1}]})", "density entry 1",
     kNoPoint, "outside the domain", "[0, 0] to [9, 9]"},
    {"box_outside", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"box": [[10,1],[11,2]], "rank": 1}]})",
     "density entry 1", kNoPoint, "outside the domain", "[0, 0] to [9, 9]"},
    {"box_without_area", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"box": [[1,1],[2,1]], "rank": 1}]})",
     "density entry 1", kNoPoint, "no area", "opposite"},
    {"box_of_three", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"box": [[1,1],[2,1],[3,3]], "rank": 1}]})",
     "density entry 1", kNoPoint, "has 3 corners", "opposite"},
    {"slip_in_a_request", R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,1], "lenght": 1}]})",
     "density entry 1", kNoPoint, "unknown key \"lenght\"", "did you mean \"length\"?"},
};

TEST(DomainErrors, PlacesAreWhereTheTroubleIs) {
  struct Place {
    std::string_view json;
    Point at;
  };
  const std::vector<Place> places{
      {R"({"outer": [[0,0],[4,4],[4,0],[0,4]]})", {2, 2}},
      {R"({"outer": [[0,0],[8,0],[8,8],[4,0],[0,8]]})", {4, 0}},
      {R"({"outer": [[0,0],[9,0],[9,0],[0,9]]})", {9, 0}},
      {R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "holes": [[[9,9],[10,9],[9,10]]]})", {9, 9}},
      {R"({"outer": [[0,0],[8,0],[8,8],[0,8]], "segments": [[[4,4],[12,4]]]})", {8, 4}},
      {R"({"outer": [[0,0],[9,0],[0,9]], "density": [{"at": [1,10], "rank": 1}]})", {1, 10}},
  };
  for (const Place& place : places) {
    const auto domain = parseDomain(place.json, "");
    ASSERT_FALSE(domain.ok());
    ASSERT_TRUE(domain.error().at.has_value()) << describe(domain.error());
    EXPECT_EQ(*domain.error().at, place.at) << describe(domain.error());
  }
}

TEST(DomainErrors, PlacesAreShownWithoutTheLastDigits) {
  EXPECT_EQ(describe(Error{.message = "m", .loop = "a", .at = Point{1.0, 0.6799999999999999}}),
            "loop 'a' at (1, 0.68): m");
  EXPECT_EQ(describe(Error{.message = "m", .at = Point{1e-30, 123456789}}), "at (1e-30, 123456789): m");
}

TEST(DomainErrors, AMissingFileIsNoInput) {
  for (const std::string path : {"/nowhere/plate.json", "/"}) {
    const auto domain = readDomain(path);
    ASSERT_FALSE(domain.ok());
    EXPECT_EQ(domain.error().kind, ErrorKind::no_input);
    EXPECT_EQ(domain.error().file, path);
  }
}

TEST(DomainErrors, OneLineTellsEverything) {
  const auto domain = parseDomain(R"({"outer": [[0,0],[9,0],[9,0],[0,9]]})", "plate.json");
  ASSERT_FALSE(domain.ok());
  EXPECT_EQ(describe(domain.error()),
            "plate.json: loop 'outer', point 2 at (9, 0): point 2 repeats point 1; remove one of the two");
}

INSTANTIATE_TEST_SUITE_P(Text, DomainErrorRow, testing::ValuesIn(kText), labelOf);
INSTANTIATE_TEST_SUITE_P(Shape, DomainErrorRow, testing::ValuesIn(kShape), labelOf);
INSTANTIATE_TEST_SUITE_P(Points, DomainErrorRow, testing::ValuesIn(kPoints), labelOf);
INSTANTIATE_TEST_SUITE_P(Curves, DomainErrorRow, testing::ValuesIn(kCurves), labelOf);
INSTANTIATE_TEST_SUITE_P(Meeting, DomainErrorRow, testing::ValuesIn(kMeeting), labelOf);
INSTANTIATE_TEST_SUITE_P(Sizes, DomainErrorRow, testing::ValuesIn(kSizes), labelOf);

}  // namespace
}  // namespace triscope::domain_errors_test
