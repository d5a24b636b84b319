#include "client/cli/chart/panel/labels.h"

#include <algorithm>
#include <array>

namespace gonio::cli {
namespace {

constexpr double kGap = 7;

double shared(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return width > 0 && height > 0 ? width * height : 0;
}

double outside(const Box& box, const Box& area) {
  return (box.right - box.left) * (box.top - box.bottom) - shared(box, area);
}

struct Candidate {
  double across, up;  // of the text's near end from the mark, in gaps and lines
  bool at_left;
};
// The earlier the better.
constexpr std::array kCandidates{
    Candidate{1, 0, false},      Candidate{-1, 0, true},     Candidate{0.6, 0.7, false},
    Candidate{0.6, -0.7, false}, Candidate{-0.6, 0.7, true}, Candidate{-0.6, -0.7, true},
    Candidate{0, 1.4, false},    Candidate{0, -1.4, false},  Candidate{0, 1.4, true},
    Candidate{0, -1.4, true},    Candidate{2, 2.2, false},   Candidate{2, -2.2, false},
    Candidate{-2, 2.2, true},    Candidate{-2, -2.2, true},  Candidate{4, 0.7, false},
    Candidate{4, -0.7, false},   Candidate{3, 3.2, false},   Candidate{3, -3.2, false},
    Candidate{-3, 3.2, true},    Candidate{-3, -3.2, true},  Candidate{6, 1.5, false},
    Candidate{6, -1.5, false},   Candidate{-6, 1.5, true},   Candidate{-6, -1.5, true},
    Candidate{8, 4.2, false},    Candidate{8, -4.2, false},  Candidate{-8, 4.2, true},
    Candidate{-8, -4.2, true}};

// Characters, not bytes.
double width_of(const std::string& text, double font_size) {
  const auto characters = std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return 0.66 * font_size * static_cast<double>(characters);
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelWanted>& labels,
                                     const std::vector<Box>& taken, const Box& area,
                                     double font_size) {
  std::vector<Box> occupied = taken;
  std::vector<LabelPlace> places;
  const double line = 1.35 * font_size;
  for (const LabelWanted& label : labels) {
    const double width = width_of(label.text, font_size);
    LabelPlace best{};
    Box best_box{};
    double least = 1e300;
    for (std::size_t i = 0; i < kCandidates.size(); ++i) {
      const Candidate& at = kCandidates[i];
      const double x = label.x + at.across * kGap, y = label.y + at.up * line;
      const Box box{at.at_left ? x - width : x, y - line / 2, at.at_left ? x : x + width,
                    y + line / 2};
      double cost = static_cast<double>(i) + 50 * outside(box, area);
      for (const Box& other : occupied) cost += 2 * shared(box, other);
      if (!(cost < least)) continue;
      least = cost;
      best = {x, y, at.at_left};
      best_box = box;
    }
    places.push_back(best);
    occupied.push_back(best_box);
  }
  return places;
}

}  // namespace gonio::cli
