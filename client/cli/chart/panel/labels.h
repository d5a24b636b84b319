// Where the labels of marks go, so that they stand neither on marks nor on one another. Thread
// safety: a function without state.
#pragma once

#include <string>
#include <vector>

namespace gonio::cli {

// In pixels, y upwards.
struct Box {
  double left, bottom, right, top;
};

struct LabelPlace {
  double x, y;   // of its middle's left or right end
  bool at_left;  // the text ends there
};

struct LabelWanted {
  double x, y;  // of the mark
  std::string text;
};

// A place for each, inside `area`, clear of `taken` as far as there is one.
std::vector<LabelPlace> place_labels(const std::vector<LabelWanted>& labels,
                                     const std::vector<Box>& taken, const Box& area,
                                     double font_size);

}  // namespace gonio::cli
